#include "lapilli/mpm/dynamics/update_points.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/mpm/dynamics/cell_parts.hpp"
#include "lapilli/mpm/dynamics/mover.hpp"
#include "lapilli/mpm/dynamics/velocity_update.hpp"

#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {
namespace {

template <int Dim>
double squared(const double* vector) {
  double sum = vector[0] * vector[0];
  for (int axis = 1; axis < Dim; ++axis) {
    sum += vector[axis] * vector[axis];
  }
  return sum;
}

/// Sums over pieces of the points, added in order.
template <class Body>
PointSums sum_over_points(Index count, const Body& body) {
  std::vector<PointSums> partial(static_cast<std::size_t>((count + piece_rows - 1) / piece_rows));
  parallel_ranges(count,
                  [&](Index begin, Index end) { partial[begin / piece_rows] = body(begin, end); });
  PointSums total;
  for (const PointSums& sums : partial) {
    total += sums;
  }
  return total;
}

/// G <- F^-T G with F = 1 + A of every point of a block.
template <int Dim>
void turn_gradients(double* gradient, const DeformationBlock<Dim>& block, int rows) {
  const auto& a = block.gradient;
  for (int k = 0; k < rows; ++k) {
    double* g = gradient + k * Dim;
    if constexpr (Dim == 2) {
      const double xx = 1.0 + a[0][k], yy = 1.0 + a[3][k];
      const double scale = 1.0 / (xx * yy - a[1][k] * a[2][k]);
      const double x = g[0];
      g[0] = scale * (yy * x - a[2][k] * g[1]);
      g[1] = scale * (xx * g[1] - a[1][k] * x);
    } else {
      Mat<Dim> deformation = Mat<Dim>::Identity();
      for (int c = 0; c < Dim * Dim; ++c) {
        deformation(c / Dim, c % Dim) += a[c][k];
      }
      Eigen::Map<Vec<Dim>> at(g);
      at = Vec<Dim>(deformation.inverse().transpose() * at);
    }
  }
}

/// Deform the points of a staged block, one run of equal bodies at a time.
template <int Dim>
void deform_block(DynamicsData<Dim>& data, const DeformationBlock<Dim>& block, double step,
                  Index begin, int rows, PointSums& sums) {
  constexpr int components = DynamicsData<Dim>::stress_components;
  StressRows at{data.stress.data() + begin * components,
                data.points.volume().data() + begin,
                data.mass.data() + begin,
                data.free_strain ? data.free_strain->data() + begin : nullptr,
                data.plastic ? data.plastic->data() + begin : nullptr,
                data.opened ? data.opened->data() + begin : nullptr};
  const Index* body = data.points.body().data() + begin;
  for (int first = 0; first < rows;) {
    int last = first + 1;
    while (last < rows && body[last] == body[first]) {
      ++last;
    }
    const StressMaterial& material = data.materials[body[first]];
    const auto state = data.states.rows(body[first], begin);
    at.state = state.data();
    at.variables = data.states.count(body[first]);
    at.step = step;
    const StressSums found = update_stress<Dim>(material, block, at, first, last);
    sums.plastic += found.plastic;
    sums.strain_work += found.strain_work;
    sums.work_ahead += found.work_ahead;
    sums.expansion += found.expansion;
    sums.strain = std::max(sums.strain, found.strain);
    sums.least_volume = std::min(sums.least_volume, found.least_volume);
    sums.wave_speed = std::max(sums.wave_speed, material.wave_modulus * found.wave_ratio);
    first = last;
  }
  if (data.turned != nullptr) {
    turn_gradients<Dim>(data.turned->data() + begin * Dim, block, rows);
  }
  if (data.deformation) {
    double* to = data.deformation->data() + begin * Dim * Dim;
    for (int row = 0; row < rows; ++row) {
      for (int c = 0; c < Dim * Dim; ++c) {
        to[row * Dim * Dim + c] = block.gradient[c][row];
      }
    }
  }
}

/// Move and deform the points [begin, end), a block at a time. read(row, axes, weights, velocity,
/// gradient, sums) reads both of a point from the nodes. Points that drifted over the first half of
/// the step (`in_halves`) move over the second.
template <int Dim, class Shape, bool in_halves, class Read>
[[gnu::always_inline]] inline PointSums move_and_deform(DynamicsData<Dim>& data,
                                                        const NodeField<Dim>& field, double step,
                                                        Index begin, Index end, const Read& read) {
  const ShapeOfBody<Shape> shape_of(data.half_widths);
  const Mover<Dim> move(data, in_halves ? 0.5 * step : step);
  const Grid<Dim> grid = field.grid;
  const Index offset = field.offset;
  double* position = data.points.position().data();
  const Index* body = data.points.body().data();
  PointDilatation<Dim, Shape> dilatation(data, field);
  DeformationBlock<Dim> block;
  PointSums sums;
  for (Index start = begin; start < end; start += block_rows) {
    const int rows = static_cast<int>(std::min<Index>(block_rows, end - start));
    for (int k = 0; k < rows; ++k) {
      const Index row = start + k;
      const AxisWeights<Dim, Shape> axes(grid, shape_of(body[row]), position + row * Dim, offset);
      const SimdWeights<Dim, Shape> w(axes.value, axes.slope);
      double velocity[Dim], gradient[Dim * Dim];
      read(row, axes, w, velocity, gradient, sums);
      if (dilatation.counts(body[row])) {
        dilatation(body[row], axes, gradient);
      }
      sums.speed = std::max(sums.speed, squared<Dim>(velocity));
      sums.outside = !move(position + row * Dim, velocity) | sums.outside;
      for (int c = 0; c < Dim * Dim; ++c) {
        block.gradient[c][k] = step * gradient[c];
      }
    }
    deform_block(data, block, step, start, rows, sums);
  }
  return sums;
}

template <int Dim, class Shape, VelocityTransfer transfer>
PointSums update_usl_rows(DynamicsData<Dim>& data, const NodeField<Dim>& field, double step,
                          Index begin, Index end) {
  const Stencil<Dim, Shape> stencil(field.grid);
  const VelocityUpdate<Dim, Shape, transfer, true> update(data, step);
  typename VelocityUpdate<Dim, Shape, transfer, true>::Nodes nodes(stencil, update.from);
  return move_and_deform<Dim, Shape, is_affine<transfer, Shape>>(
      data, field, step, begin, end,
      [&](Index row, const auto& axes, const auto& w, double* velocity, double* gradient,
          PointSums& sums) {
        nodes.move_to(axes.first);
        double here[Dim * Dim];
        sums.kinetic += update(row, nodes, axes, w, velocity, gradient, here);
        if constexpr (is_affine<transfer, Shape>) {
          std::copy_n(velocity, Dim, data.carried->data() + row * Dim);
        }
        sums.speed = std::max(sums.speed, squared<Dim>(data.velocity.data() + row * Dim));
      });
}

template <int Dim, class Shape, VelocityTransfer transfer>
PointSums update_velocity_rows(DynamicsData<Dim>& data, const NodeField<Dim>& field, double step,
                               Index begin, Index end) {
  const Stencil<Dim, Shape> stencil(field.grid);
  const VelocityUpdate<Dim, Shape, transfer, false> update(data, step);
  typename VelocityUpdate<Dim, Shape, transfer, false>::Nodes nodes(stencil, update.from);
  double* to[Dim];
  for (int axis = 0; axis < Dim; ++axis) {
    to[axis] = data.nodes.second_velocity(axis);
  }
  CellSums<Dim, Shape, Dim> sums(stencil, to);
  const ShapeOfBody<Shape> shape_of(data.half_widths);
  const Grid<Dim> grid = field.grid;
  const Index offset = field.offset;
  const double* position = data.points.position().data();
  const Index* body = data.points.body().data();
  PointSums found;
  for (Index row = begin; row < end; ++row) {
    const AxisWeights<Dim, Shape> axes(grid, shape_of(body[row]), position + row * Dim, offset);
    const SimdWeights<Dim, Shape> w(axes.value, axes.slope);
    nodes.move_to(axes.first);
    sums.move_to(axes.first);
    double carried[Dim], here[Dim * Dim];
    found.kinetic += update(row, nodes, axes, w, carried, nullptr, here);
    if constexpr (is_affine<transfer, Shape>) {
      std::copy_n(carried, Dim, data.carried->data() + row * Dim);
    }
    const double* velocity = data.velocity.data() + row * Dim;
    found.speed = std::max(found.speed, squared<Dim>(velocity));
    add_momentum<transfer>(sums, 0, w, axes, grid.cell_size(), data.mass[row], velocity, here);
  }
  return found;
}

template <int Dim, class Shape, bool in_halves>
PointSums update_musl_rows(DynamicsData<Dim>& data, const NodeField<Dim>& field, double step,
                           Index begin, Index end) {
  const Stencil<Dim, Shape> stencil(field.grid);
  constexpr int gradients = Dim * Dim, values = in_halves ? 0 : Dim;
  const double* from[values + Dim];
  for (int axis = 0; axis < Dim; ++axis) {
    from[axis] = data.nodes.second_velocity(axis);
    if constexpr (!in_halves) {
      from[Dim + axis] = data.nodes.velocity(axis);
    }
  }
  CellNodes<Dim, Shape, values + Dim> nodes(stencil, from);
  const double* carried = in_halves ? data.carried->data() : nullptr;
  return move_and_deform<Dim, Shape, in_halves>(
      data, field, step, begin, end,
      [&](Index row, const auto& axes, const auto& w, double* velocity, double* gradient,
          PointSums&) {
        nodes.move_to(axes.first);
        constexpr int count = (gradients + values + 3) / 4 * 4;
        Double4 parts[count];
        for (int axis = 0; axis < Dim; ++axis) {
          for (int along = 0; along < Dim; ++along) {
            parts[axis * Dim + along] = nodes.weigh(axis, w.slope[along]);
          }
          if constexpr (!in_halves) {
            parts[gradients + axis] = nodes.weigh(Dim + axis, w.value);
          }
        }
        for (int c = gradients + values; c < count; ++c) {
          parts[c] = all(0.0);
        }
        alignas(32) double value[count];
        add_lanes(parts, value);
        std::copy_n(value, gradients, gradient);
        std::copy_n(in_halves ? carried + row * Dim : value + gradients, Dim, velocity);
      });
}

}  // namespace

template <int Dim>
PointSums update_velocities(DynamicsData<Dim>& data, double step) {
  data.nodes.clear_second_velocity();
  std::vector<PointSums> partial(static_cast<std::size_t>(data.order.strip_count()));
  with_transfer(data.shape, data.settings.transfer, [&]<class Shape, VelocityTransfer transfer>() {
    data.order.for_each_strip([&](Index begin, Index end, Index strip) {
      const auto update = [&](const NodeField<Dim>& field, Index from, Index to) {
        partial[strip] += update_velocity_rows<Dim, Shape, transfer>(data, field, step, from, to);
      };
      data.fields.for_each_run(data.points.body().data(), begin, end, update);
    });
  });
  PointSums total;
  for (const PointSums& sums : partial) {
    total += sums;
  }
  total.speed = std::sqrt(total.speed);
  return total;
}

template <int Dim>
PointSums update_points(DynamicsData<Dim>& data, double step) {
  if (data.dilatation) {
    find_mean_dilatation(data);
  }
  PointSums total;
  with_transfer(data.shape, data.settings.transfer, [&]<class Shape, VelocityTransfer transfer>() {
    total = sum_over_points(data.points.size(), [&](Index begin, Index end) {
      PointSums sums;
      const auto update = [&](const NodeField<Dim>& field, Index from, Index to) {
        sums += data.settings.stress_update == StressUpdate::usl
                    ? update_usl_rows<Dim, Shape, transfer>(data, field, step, from, to)
                    : update_musl_rows<Dim, Shape, is_affine<transfer, Shape>>(data, field, step,
                                                                               from, to);
      };
      data.fields.for_each_run(data.points.body().data(), begin, end, update);
      return sums;
    });
  });
  total.speed = std::sqrt(total.speed);
  total.wave_speed = std::sqrt(total.wave_speed);
  return total;
}

template PointSums update_velocities<2>(DynamicsData<2>&, double);
template PointSums update_velocities<3>(DynamicsData<3>&, double);
template PointSums update_points<2>(DynamicsData<2>&, double);
template PointSums update_points<3>(DynamicsData<3>&, double);

}  // namespace lapilli
