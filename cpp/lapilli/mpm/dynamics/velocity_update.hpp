#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "lapilli/mpm/dynamics/cell_sums.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {

/// Takes the velocity of points from the nodes. FLIP adds the interpolated increment and blends in
/// a share of the nodal velocity each step; APIC and TPIC take the nodal velocity and their matrix;
/// the blend adds increments of both and lets what they leave out fade with the strain of the step.
template <int Dim, class Shape, VelocityTransfer transfer, bool with_gradient>
class VelocityUpdate {
 public:
  static constexpr bool affine = is_affine<transfer, Shape>;
  static constexpr bool blended = transfer == VelocityTransfer::blended_apic;
  static constexpr bool increments = blended || !affine;
  static constexpr bool levered = affine && transfer != VelocityTransfer::tpic;
  static constexpr bool slopes = with_gradient || !(levered || transfer == VelocityTransfer::flip);
  static constexpr int values = increments ? 2 * Dim : Dim;  // velocity, and increment
  static constexpr int arrays = values + (slopes ? Dim : 0);
  using Nodes = CellNodes<Dim, Shape, arrays>;

  VelocityUpdate(DynamicsData<Dim>& data, double step)
      : h_(data.grid.cell_size()),
        share_(blended ? data.settings.blend_rate : data.settings.pic_fraction),
        step_(step),
        velocity_(data.velocity.data()),
        affine_(data.affine ? data.affine->data() : nullptr),
        mass_(data.mass.data()) {
    for (int axis = 0; axis < Dim; ++axis) {
      from[axis] = data.nodes.velocity(axis);
      if constexpr (increments) {
        from[Dim + axis] = data.nodes.increment(axis);
      }
      if constexpr (slopes) {
        from[values + axis] = data.nodes.strain_velocity(axis);
      }
    }
  }

  const double* from[arrays];  // nodal arrays that it reads

  /// Update one point; writes the velocity of its place over the step to `carried` (FLIP: the mean
  /// of before and after; affine: the one after) and the gradient of the strain velocity,
  /// row-major, to `gradient` where asked for, and the affine matrix where the point still is,
  /// row-major, to `here`: the stored one belongs to where it moves. Returns its kinetic energy.
  double operator()(Index row, const Nodes& nodes, const AxisWeights<Dim, Shape>& axes,
                    const SimdWeights<Dim, Shape>& w, double* carried, double* gradient,
                    double* here) const {
    constexpr int first_gradient = values;
    constexpr int first_lever = first_gradient + (slopes ? Dim * Dim : 0);
    constexpr int used = first_lever + (levered ? values * Dim : 0);
    constexpr int count = (used + 3) / 4 * 4;
    Double4 parts[count];
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
    if constexpr (levered) {
      double factor[Dim][Shape::support];
      levers(axes, h_, factor);
      const SimdWeights<Dim, Shape> lever(axes.value, factor);
      for (int axis = 0; axis < values; ++axis) {
        for (int along = 0; along < Dim; ++along) {
          parts[first_lever + axis * Dim + along] = nodes.weigh(axis, lever.slope[along]);
        }
      }
    }
    alignas(32) double value[count];
    add_lanes(parts, value);

    double square = 0.0;
    double share = share_;
    if constexpr (blended && affine) {
      square = blend_affine(row, axes, value + first_lever, share, here);
    } else if constexpr (blended) {
      share = 1.0 - kept(Eigen::Map<const RowMajor>(value + first_gradient));
    } else if constexpr (affine) {
      square = keep_affine(row, axes, value + (levered ? first_lever : first_gradient));
      std::copy_n(affine_ + row * Dim * Dim, Dim * Dim, here);
    }
    double* velocity = velocity_ + row * Dim;
    for (int axis = 0; axis < Dim; ++axis) {
      carried[axis] = affine ? value[axis] : value[axis] - 0.5 * value[values - Dim + axis];
      if constexpr (increments) {
        velocity[axis] = (1.0 - share) * (velocity[axis] + value[Dim + axis]) + share * value[axis];
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
    return 0.5 * mass_[row] * square;
  }

 private:
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  using RowMajor = Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>;

  /// What a point keeps of its own over a step in which its surroundings deform by `rate`: it does
  /// not know the number of steps, nor flight or spin, nor the stiffness.
  double kept(const Matrix& rate) const {
    return std::exp(-share_ * step_ * (0.5 * (rate + rate.transpose())).norm());
  }

  /// C <- (C+ + keep (C - C-)) (1 + dt C+)^-1 with the nodes' matrices before and after the step;
  /// the last factor carries the gradient with the deformation. Sets the share of the nodes, and
  /// returns twice the kinetic energy of the matrix over the mass.
  double blend_affine(Index row, const AxisWeights<Dim, Shape>& axes, const double* lever,
                      double& share, double* here) const {
    Eigen::Map<RowMajor> own(affine_ + row * Dim * Dim);
    Matrix after, change;
    double moment[Dim];
    for (int along = 0; along < Dim; ++along) {
      moment[along] = second_moment(axes, h_, along);
      const double inverse = 1.0 / moment[along];
      for (int axis = 0; axis < Dim; ++axis) {
        after(axis, along) = lever[axis * Dim + along] * inverse;
        change(axis, along) = lever[(Dim + axis) * Dim + along] * inverse;
      }
    }
    const double keep = kept(after);
    share = 1.0 - keep;
    const Matrix blended_here = after + keep * (own - after + change);
    Eigen::Map<RowMajor>{here} = blended_here;
    const Matrix carry = Matrix::Identity() + step_ * after;
    own = blended_here * carry.inverse();
    double square = 0.0;
    for (int along = 0; along < Dim; ++along) {
      square += blended_here.col(along).squaredNorm() * moment[along];
    }
    return square;
  }

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

  double h_, share_, step_;
  double* velocity_;
  double* affine_;
  const double* mass_;
};

}  // namespace lapilli

#pragma GCC diagnostic pop
