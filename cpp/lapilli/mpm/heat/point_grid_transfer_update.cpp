#include <algorithm>

#include "lapilli/mpm/heat/point_grid_shapes.hpp"

namespace lapilli {
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

#define LAPILLI_INSTANTIATE(Dim)                                                                  \
  template void PointGridTransfer<Dim>::conduct(const Points&, const CellOrder<Dim>&);            \
  template void PointGridTransfer<Dim>::update(const Points&, const std::vector<double>&, double, \
                                               double*, double*);                                 \
  template void PointGridTransfer<Dim>::interpolate(const Points&, const std::vector<double>&,    \
                                                    double*, double*);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
