#include <algorithm>

#include "lapilli/mpm/heat/point_grid_shapes.hpp"

namespace lapilli {
namespace {

constexpr Index padding = 4;  // reading a patch may reach past the last node

}  // namespace

template <int Dim>
PointGridTransfer<Dim>::PointGridTransfer(const Grid<Dim>& grid, ShapeFunction shape,
                                          const HeatCoefficients<Dim>& coefficients,
                                          bool with_surface, const NodeFields<Dim>* fields)
    : grid_(grid),
      whole_(grid),
      fields_(fields != nullptr ? *fields : whole_),
      shape_(shape),
      coefficients_(coefficients),
      with_surface_(with_surface) {
  for (const double width : coefficients.half_width) {
    gimp_.emplace_back(width);
  }
  if constexpr (Dim == 2) {
    const bool isotropic = std::all_of(
        coefficients.conductivity.begin(), coefficients.conductivity.end(),
        [](const Mat<2>& k) { return k(0, 0) == k(1, 1) && k(0, 1) == 0.0 && k(1, 0) == 0.0; });
    if (shape == ShapeFunction::linear && isotropic && fields == nullptr) {
      stiffness_.emplace(grid);
    }
  }
  resize();
}

template <int Dim>
void PointGridTransfer<Dim>::resize() {
  const auto nodes = static_cast<std::size_t>(fields_.node_count() + padding);
  for (auto* values : {&capacity, &temperature, &rate, &increment, &blended}) {
    values->assign(nodes, 0.0);
  }
  if (with_surface_) {
    sums.fraction.assign(nodes, 0.0);
    sums.area_vector.assign(nodes, Vec<Dim>::Zero());
    for (auto& values : area_) {
      values.assign(nodes, 0.0);
    }
  }
}

template <int Dim>
void PointGridTransfer<Dim>::clear(const CellOrder<Dim>& order) {
  if (!fields_.is_single()) {
    resize();
    first_ = 0;
    last_ = fields_.node_count();
    return;
  }
  const auto clear_range = [this](Index begin, Index end) {
    for (auto* values : {&capacity, &temperature, &rate, &increment}) {
      std::fill(values->begin() + begin, values->begin() + end, 0.0);
    }
    if (stiffness_) {
      stiffness_->clear(begin, end);
    }
    if (with_surface_) {
      std::fill(sums.fraction.begin() + begin, sums.fraction.begin() + end, 0.0);
      std::fill(sums.area_vector.begin() + begin, sums.area_vector.begin() + end,
                Vec<Dim>(Vec<Dim>::Zero()));
      for (auto& values : area_) {
        std::fill(values.begin() + begin, values.begin() + end, 0.0);
      }
    }
  };
  for_active_nodes(clear_range);
  const auto [from, to] = order.node_layers();
  const Index layer = grid_.node_stride(Dim - 1);
  first_ = from * layer;
  last_ = std::min(to * layer, grid_.node_count());
}

template <int Dim>
void PointGridTransfer<Dim>::project(const Points& points, const CellOrder<Dim>& order,
                                     const double* point_capacity, const double* carried,
                                     const double* gradient) {
  clear(order);
  const double* position = points.position().data();
  const double* volume = points.volume().data();
  const Index* body = points.body().data();
  const double per_cell = 1.0 / grid_.cell_volume();
  const auto sweep = [&](auto shape_of, auto affine, auto surface) {
    using Function = std::decay_t<decltype(shape_of(0))>;
    using Patch = PatchWeights<Dim, Function>;
    constexpr bool may_sum_stiffness = Dim == 2 && std::is_same_v<Function, LinearShape>;
    const auto sum_run = [&](const NodeField<Dim>& field, Index begin, Index end) {
      const PatchNodes<Dim, Function> nodes(field.grid);
      PlaneStiffness::Held stiffness(stiffness_ ? &*stiffness_ : nullptr);
      HeldPatches<Dim, Function, 2> held(
          nodes, {capacity.data() + field.offset, temperature.data() + field.offset});
      std::array<double*, 1 + Dim> arrays{sums.fraction.data() + field.offset};
      for (int axis = 0; axis < Dim; ++axis) {
        arrays[1 + axis] = area_[axis].data() + field.offset;
      }
      HeldPatches<Dim, Function, 1 + Dim> shell(nodes, arrays);
      for_points(field.grid, begin, end, position, shape_of, body, [&](Index row, const auto& w) {
        held.hold(w.first());
        const double m = point_capacity[row];
        // T_p + G_p . (x_I - x_p) over a patch: constant plus what varies within it.
        const double* g = gradient + row * Dim;
        Double4 tilt{};
        if constexpr (decltype(affine)::value) {
          for (int axis = 0; axis < Patch::inner; ++axis) {
            tilt += (nodes.lanes(axis) - w.from_base(axis)) * g[axis];
          }
        }
#pragma GCC unroll 9
        for (int patch = 0; patch < Patch::patches; ++patch) {
          double constant = carried[row];
          if constexpr (decltype(affine)::value) {
            for (int axis = Patch::inner; axis < Dim; ++axis) {
              constant += g[axis] * (nodes.distance(patch, axis) - w.from_base(axis));
            }
          }
          const Double4 mass = w.value() * (w.across(patch) * m);
          held.sum[0][patch] += mass;
          held.sum[1][patch] += mass * (tilt + constant);
        }
        if constexpr (may_sum_stiffness) {
          const double k = coefficients_.conductivity[body[row]](0, 0);
          stiffness.add(w.first(), k * volume[row], w.slope(0), w.slope(1));
        }
        if constexpr (decltype(surface)::value) {
          shell.hold(w.first());
          const double v = volume[row];
#pragma GCC unroll 9
          for (int patch = 0; patch < Patch::patches; ++patch) {
            const double across = w.across(patch) * v;
            shell.sum[0][patch] += w.value() * (across * per_cell);
            for (int axis = 0; axis < Patch::inner; ++axis) {
              shell.sum[1 + axis][patch] += w.slope(axis) * across;
            }
            for (int axis = Patch::inner; axis < Dim; ++axis) {
              shell.sum[1 + axis][patch] += w.value() * (w.slope_across(patch, axis) * v);
            }
          }
        }
      });
      held.flush();
      stiffness.flush();
      if constexpr (decltype(surface)::value) {
        shell.flush();
      }
    };
    order.for_each_strip(
        [&](Index begin, Index end) { fields_.for_each_run(body, begin, end, sum_run); });
  };
  with_shapes([&](auto shape_of) {
    const auto choose = [&](auto affine) {
      with_surface_ ? sweep(shape_of, affine, std::true_type{})
                    : sweep(shape_of, affine, std::false_type{});
    };
    gradient != nullptr ? choose(std::true_type{}) : choose(std::false_type{});
  });
  for_active_nodes([this](Index begin, Index end) {
    for (Index node = begin; node < end; ++node) {
      temperature[node] = capacity[node] > 0.0 ? temperature[node] / capacity[node] : 0.0;
    }
    if (with_surface_) {
      for (Index node = begin; node < end; ++node) {
        for (int axis = 0; axis < Dim; ++axis) {
          sums.area_vector[node][axis] = area_[axis][node];
        }
      }
    }
  });
}

template class PointGridTransfer<1>;
template class PointGridTransfer<2>;
template class PointGridTransfer<3>;

}  // namespace lapilli
