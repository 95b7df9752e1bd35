#pragma once

#include "lapilli/mpm/momentum/cell_sums.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {

/// Takes the velocity of points from the nodes: FLIP adds the interpolated increment and blends in
/// the nodal velocity, the affine transfers take the nodal velocity and their matrix.
template <int Dim, class Shape, VelocityTransfer transfer, bool with_gradient>
class VelocityUpdate {
 public:
  static constexpr bool flip = transfer == VelocityTransfer::flip;
  static constexpr bool slopes = with_gradient || transfer == VelocityTransfer::tpic;
  static constexpr int values = flip ? 2 * Dim : Dim;  // velocity, and increment
  static constexpr int arrays = values + (slopes ? Dim : 0);
  using Nodes = CellNodes<Dim, Shape, arrays>;

  explicit VelocityUpdate(MomentumData<Dim>& data)
      : h_(data.grid.cell_size()),
        pic_share_(data.settings.pic_share),
        velocity_(data.velocity.data()),
        affine_(data.affine ? data.affine->data() : nullptr),
        mass_(data.mass.data()) {
    for (int axis = 0; axis < Dim; ++axis) {
      from[axis] = data.nodes.velocity(axis);
      if constexpr (flip) {
        from[Dim + axis] = data.nodes.increment(axis);
      }
      if constexpr (slopes) {
        from[values + axis] = data.nodes.strain_velocity(axis);
      }
    }
  }

  const double* from[arrays];  // nodal arrays that it reads

  /// Update one point; writes the velocity of its place over the step to `carried` (FLIP: the mean
  /// of before and after, so that a constant acceleration is exact; affine: the one after, which
  /// keeps angular momentum) and the gradient of the strain velocity, row-major, to `gradient`
  /// where asked for. Returns its kinetic energy.
  double operator()(Index row, const Nodes& nodes, const AxisWeights<Dim, Shape>& axes,
                    const QuadWeights<Dim, Shape>& w, double* carried, double* gradient) const {
    constexpr bool affine = !flip;
    constexpr int first_gradient = values;
    constexpr int first_lever = first_gradient + (slopes ? Dim * Dim : 0);
    constexpr int used = first_lever + (transfer == VelocityTransfer::apic ? Dim * Dim : 0);
    constexpr int count = (used + 3) / 4 * 4;
    Quad parts[count];
    for (int k = used; k < count; ++k) {
      parts[k] = all(0.0);
    }
    for (int axis = 0; axis < values; ++axis) {
      parts[axis] = nodes.weigh(axis, w.value);
    }
    if constexpr (slopes) {
      for (int axis = 0; axis < Dim; ++axis) {
        for (int along = 0; along < Dim; ++along) {
          parts[first_gradient + axis * Dim + along] = nodes.weigh(values + axis, w.slope[along]);
        }
      }
    }
    if constexpr (transfer == VelocityTransfer::apic) {
      double factor[Dim][Shape::support];
      levers(axes, h_, factor);
      const QuadWeights<Dim, Shape> lever(axes.value, factor);
      for (int axis = 0; axis < Dim; ++axis) {
        for (int along = 0; along < Dim; ++along) {
          parts[first_lever + axis * Dim + along] = nodes.weigh(axis, lever.slope[along]);
        }
      }
    }
    alignas(32) double value[count];
    add_lanes(parts, value);

    double* velocity = velocity_ + row * Dim;
    double square = 0.0;
    for (int axis = 0; axis < Dim; ++axis) {
      carried[axis] = value[axis];
      if constexpr (flip) {
        carried[axis] -= 0.5 * value[Dim + axis];
        velocity[axis] =
            (1.0 - pic_share_) * (velocity[axis] + value[Dim + axis]) + pic_share_ * value[axis];
      } else {
        velocity[axis] = value[axis];
      }
      square += velocity[axis] * velocity[axis];
    }
    if constexpr (with_gradient) {
      for (int k = 0; k < Dim * Dim; ++k) {
        gradient[k] = value[first_gradient + k];
      }
    }
    if constexpr (affine) {
      square += keep_affine(
          row, axes,
          transfer == VelocityTransfer::apic ? value + first_lever : value + first_gradient);
    }
    return 0.5 * mass_[row] * square;
  }

 private:
  /// Store the affine matrix; returns twice its kinetic energy over the mass.
  double keep_affine(Index row, const AxisWeights<Dim, Shape>& axes, const double* found) const {
    double* matrix = affine_ + row * Dim * Dim;
    double square = 0.0;
    for (int along = 0; along < Dim; ++along) {
      const double moment = second_moment(axes, h_, along);
      // APIC keeps the gradient times the moment, TPIC the gradient.
      const double inverse = moment > 0.0 ? 1.0 / moment : 0.0;
      const double scale = transfer == VelocityTransfer::apic ? inverse : moment;
      for (int axis = 0; axis < Dim; ++axis) {
        const double entry = found[axis * Dim + along];
        matrix[axis * Dim + along] = entry;
        square += entry * entry * scale;
      }
    }
    return square;
  }

  double h_, pic_share_;
  double* velocity_;
  double* affine_;
  const double* mass_;
};

}  // namespace lapilli

#pragma GCC diagnostic pop
