#include "lapilli/mpm/heat/point_grid_transfer.hpp"

#include <algorithm>

#include "lapilli/mpm/transfer/patch_weights.hpp"

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

/// Calls body(shape_of), where shape_of(b) is the shape function of body b.
template <int Dim>
template <class Body>
void PointGridTransfer<Dim>::with_shapes(const Body& body) const {
  if (shape_ == ShapeFunction::linear) {
    body(OneShape<LinearShape>{});
  } else if (std::all_of(gimp_.begin(), gimp_.end(), [this](const GimpShape& shape) {
               return shape.half_width == gimp_.front().half_width;
             })) {
    body(OneShape<GimpShape>{gimp_.front()});
  } else {
    body([shapes = gimp_.data()](Index b) { return shapes[b]; });
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

namespace {

/// Level and slopes of a nodal array at a point: parts whose lanes add up to the value (first) and
/// to the gradient.
template <int Dim, class Shape, bool WithGradient, class Point>
[[gnu::always_inline]] inline std::array<Double4, 4> parts_at(const PatchNodes<Dim, Shape>& nodes,
                                                              const double* nodal, const Point& w) {
  using Patch = PatchWeights<Dim, Shape>;
  Double4 level{}, slope[Dim] = {};
#pragma GCC unroll 9
  for (int patch = 0; patch < Patch::patches; ++patch) {
    const Double4 here = nodes.read(nodal, w.first(), patch);
    level += here * w.across(patch);
    if constexpr (WithGradient) {
      for (int axis = Patch::inner; axis < Dim; ++axis) {
        slope[axis] += here * w.slope_across(patch, axis);
      }
    }
  }
  std::array<Double4, 4> parts{w.value() * level};
  if constexpr (WithGradient) {
    for (int axis = 0; axis < Dim; ++axis) {
      parts[1 + axis] = axis < Patch::inner ? w.slope(axis) * level : w.value() * slope[axis];
    }
  }
  return parts;
}

}  // namespace

template <int Dim>
void PointGridTransfer<Dim>::conduct(const Points& points, const CellOrder<Dim>& order) {
  if (stiffness_) {
    stiffness_->conduct(temperature.data(), rate.data(), first_, last_);
  } else {
    conduct_by_points(points, order);
  }
}

template <int Dim>
void PointGridTransfer<Dim>::conduct_by_points(const Points& points, const CellOrder<Dim>& order) {
  const double* position = points.position().data();
  const double* volume = points.volume().data();
  const Index* body = points.body().data();
  with_shapes([&](auto shape_of) {
    using Function = std::decay_t<decltype(shape_of(0))>;
    using Patch = PatchWeights<Dim, Function>;
    const auto conduct_run = [&](const NodeField<Dim>& field, Index begin, Index end) {
      const PatchNodes<Dim, Function> nodes(field.grid);
      const double* nodal = temperature.data() + field.offset;
      HeldPatches<Dim, Function, 1> held(nodes, {rate.data() + field.offset});
      for_points(field.grid, begin, end, position, shape_of, body, [&](Index row, const auto& w) {
        held.hold(w.first());
        const auto parts = parts_at<Dim, Function, true>(nodes, nodal, w);
        const Double4 added = lapilli::sums(parts[0], parts[1], parts[2], parts[3]);
        const Mat<Dim>& conductivity = coefficients_.conductivity[body[row]];
        double flux[Dim];
        for (int axis = 0; axis < Dim; ++axis) {
          flux[axis] = 0.0;
          for (int other = 0; other < Dim; ++other) {
            flux[axis] += conductivity(axis, other) * added[1 + other];
          }
          flux[axis] *= volume[row];
        }
        Double4 inner{};
        for (int axis = 0; axis < Patch::inner; ++axis) {
          inner += w.slope(axis) * flux[axis];
        }
#pragma GCC unroll 9
        for (int patch = 0; patch < Patch::patches; ++patch) {
          double outer = 0.0;
          for (int axis = Patch::inner; axis < Dim; ++axis) {
            outer += w.slope_across(patch, axis) * flux[axis];
          }
          held.sum[0][patch] -= inner * w.across(patch) + w.value() * outer;
        }
      });
      held.flush();
    };
    order.for_each_strip(
        [&](Index begin, Index end) { fields_.for_each_run(body, begin, end, conduct_run); });
  });
}

template <int Dim>
void PointGridTransfer<Dim>::update(const Points& points, const std::vector<double>& nodal,
                                    double beta, double* carried, double* carried_gradient) {
  const double* position = points.position().data();
  const Index* body = points.body().data();
  const double keep = 1.0 - beta;
  const auto sweep = [&](auto shape_of, auto with_gradient) {
    using Function = std::decay_t<decltype(shape_of(0))>;
    const auto update_run = [&](const NodeField<Dim>& field, Index begin, Index end) {
      const PatchNodes<Dim, Function> nodes(field.grid);
      const double* from = nodal.data() + field.offset;
      for_points(field.grid, begin, end, position, shape_of, body, [&](Index row, const auto& w) {
        const auto parts = parts_at<Dim, Function, decltype(with_gradient)::value>(nodes, from, w);
        const Double4 added = lapilli::sums(parts[0], parts[1], parts[2], parts[3]);
        carried[row] = keep * carried[row] + added[0];
        if constexpr (decltype(with_gradient)::value) {
          for (int axis = 0; axis < Dim; ++axis) {
            double& g = carried_gradient[row * Dim + axis];
            g = keep * g + added[1 + axis];
          }
        }
      });
    };
    parallel_ranges(points.size(), [&](Index begin, Index end) {
      fields_.for_each_run(body, begin, end, update_run);
    });
  };
  with_shapes([&](auto shape_of) {
    carried_gradient != nullptr ? sweep(shape_of, std::true_type{})
                                : sweep(shape_of, std::false_type{});
  });
}

template <int Dim>
void PointGridTransfer<Dim>::interpolate(const Points& points, const std::vector<double>& nodal,
                                         double* value, double* flux) {
  std::fill_n(value, points.size(), 0.0);
  std::fill_n(flux, points.size() * Dim, 0.0);
  update(points, nodal, 1.0, value, flux);
  parallel_for(points.size(), [&](Index row) {
    Eigen::Map<Vec<Dim>> q(flux + row * Dim);
    q = Vec<Dim>(-(coefficients_.conductivity[points.body()[row]] * q));
  });
}

template class PointGridTransfer<1>;
template class PointGridTransfer<2>;
template class PointGridTransfer<3>;

}  // namespace lapilli
