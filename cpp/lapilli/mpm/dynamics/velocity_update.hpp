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
/// the blend adds increments of both and lets what they leave out fade with the strain around it.
///
/// The blend takes from a point, V <- V - sum S f_I (V + C (x_I - x) - v_I) with the share f_I of
/// every node: what points lose to a node sums to nothing, so that linear momentum is kept, whereas
/// a share of the point's own would not keep it.
template <int Dim, class Shape, VelocityTransfer transfer, bool with_gradient>
class VelocityUpdate {
 public:
  static constexpr bool affine = is_affine<transfer, Shape>;
  static constexpr bool blended = transfer == VelocityTransfer::blended_apic;
  static constexpr bool increments = blended || !affine;
  static constexpr bool levered = affine && transfer != VelocityTransfer::tpic;
  static constexpr bool slopes = with_gradient || !(levered || transfer == VelocityTransfer::flip);

  // Nodal arrays: velocity, increment, gain and fade, strain velocity.
  static constexpr int own = increments ? 2 * Dim : Dim;
  static constexpr int gain = own, fade = own + Dim;
  static constexpr int strain = blended ? fade + 1 : own;
  static constexpr int arrays = strain + (slopes ? Dim : 0);
  using Nodes = CellNodes<Dim, Shape, arrays>;

  VelocityUpdate(DynamicsData<Dim>& data, double step)
      : h_(data.grid.cell_size()),
        share_(data.settings.pic_fraction),
        step_(step),
        velocity_(data.velocity.data()),
        affine_(data.affine ? data.affine->data() : nullptr),
        strain_rate_(data.strain_rate ? data.strain_rate->data() : nullptr),
        mass_(data.mass.data()) {
    for (int axis = 0; axis < Dim; ++axis) {
      from[axis] = data.nodes.velocity(axis);
      if constexpr (increments) {
        from[Dim + axis] = data.nodes.increment(axis);
      }
      if constexpr (blended) {
        from[gain + axis] = data.nodes.gain(axis);
        from[fade] = data.nodes.fade();
      }
      if constexpr (slopes) {
        from[strain + axis] = data.nodes.strain_velocity(axis);
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
    alignas(32) double value[count];
    weigh(nodes, axes, w, value);
    double square = 0.0;
    double* velocity = velocity_ + row * Dim;
    if constexpr (blended) {
      blend_velocity(row, value, velocity);
      if constexpr (affine) {
        square = blend_affine(row, axes, value, here);
      } else {
        strain_rate_[row] = rate_of(Eigen::Map<const RowMajor>(value + first_slope));
      }
    } else if constexpr (affine) {
      square = keep_affine(row, axes, value + (levered ? first_lever : first_slope));
      std::copy_n(affine_ + row * Dim * Dim, Dim * Dim, here);
    }
    for (int axis = 0; axis < Dim; ++axis) {
      carried[axis] = affine ? value[axis] : value[axis] - 0.5 * value[Dim + axis];
      if constexpr (!blended && increments) {
        velocity[axis] =
            (1.0 - share_) * (velocity[axis] + value[Dim + axis]) + share_ * value[axis];
      } else if constexpr (!blended) {
        velocity[axis] = value[axis];
      }
      square += velocity[axis] * velocity[axis];
    }
    if constexpr (with_gradient) {
      for (int k = 0; k < Dim * Dim; ++k) {
        gradient[k] = value[first_slope + k];
      }
    }
    return 0.5 * mass_[row] * square;
  }

 private:
  using Matrix = Eigen::Matrix<double, Dim, Dim>;
  using RowMajor = Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>;

  // What is weighed for a point: arrays but the strain velocity, its slopes, levers of velocity and
  // increment, levers of the fade.
  static constexpr int first_slope = strain;
  static constexpr int first_lever = first_slope + (slopes ? Dim * Dim : 0);
  static constexpr int fade_lever = first_lever + (levered ? own * Dim : 0);
  static constexpr int used = fade_lever + (blended && affine ? Dim : 0);
  static constexpr int count = (used + 3) / 4 * 4;

  void weigh(const Nodes& nodes, const AxisWeights<Dim, Shape>& axes,
             const SimdWeights<Dim, Shape>& w, double (&value)[count]) const {
    Double4 parts[count];
    for (int k = used; k < count; ++k) {
      parts[k] = all(0.0);
    }
    for (int array = 0; array < strain; ++array) {
      parts[array] = nodes.weigh(array, w.value);
    }
    if constexpr (slopes) {
      for (int axis = 0; axis < Dim; ++axis) {
        for (int along = 0; along < Dim; ++along) {
          parts[first_slope + axis * Dim + along] = nodes.weigh(strain + axis, w.slope[along]);
        }
      }
    }
    if constexpr (levered) {
      double factor[Dim][Shape::support];
      levers(axes, h_, factor);
      const SimdWeights<Dim, Shape> lever(axes.value, factor);
      for (int along = 0; along < Dim; ++along) {
        for (int array = 0; array < own; ++array) {
          parts[first_lever + array * Dim + along] = nodes.weigh(array, lever.slope[along]);
        }
        if constexpr (blended) {
          parts[fade_lever + along] = nodes.weigh(fade, lever.slope[along]);
        }
      }
    }
    add_lanes(parts, value);
  }

  static double rate_of(const Matrix& gradient) {
    return (0.5 * (gradient + gradient.transpose())).norm();
  }

  void blend_velocity(Index row, const double* value, double* velocity) const {
    for (int axis = 0; axis < Dim; ++axis) {
      double lost = value[fade] * velocity[axis];
      if constexpr (affine) {
        for (int along = 0; along < Dim; ++along) {
          lost += affine_[(row * Dim + axis) * Dim + along] * value[fade_lever + along];
        }
      }
      velocity[axis] += value[gain + axis] - lost;
    }
  }

  /// C <- (C+ + keep (C - C-)) (1 + dt C+)^-1 with the nodes' matrices before and after the step;
  /// the last factor carries the gradient with the motion. Returns twice the kinetic energy of
  /// the matrix over the mass.
  double blend_affine(Index row, const AxisWeights<Dim, Shape>& axes, const double* value,
                      double* here) const {
    Eigen::Map<RowMajor> stored(affine_ + row * Dim * Dim);
    const double* lever = value + first_lever;
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
    strain_rate_[row] = rate_of(after);
    const Matrix now = after + (1.0 - value[fade]) * (stored - after + change);
    Eigen::Map<RowMajor>{here} = now;
    stored = carried_along(now, after);
    double square = 0.0;
    for (int along = 0; along < Dim; ++along) {
      square += now.col(along).squaredNorm() * moment[along];
    }
    return square;
  }

  /// The gradient where the point goes, C (1 + dt C+)^-1. What converges steepens; the reach of a
  /// point does not shrink with it, so that a faster strain would be energy from nowhere. What a
  /// spin needs to stay one, dt |W|^2, is allowed. The spin itself is left alone but where a step
  /// strains by more than elastic solids do: limited in every vibration, it would fade.
  Matrix carried_along(const Matrix& now, const Matrix& after) const {
    const Matrix carry = Matrix::Identity() + step_ * after;
    const Matrix there = now * carry.inverse();
    const Matrix deforming = 0.5 * (there + there.transpose());
    const double spin = (0.5 * (now - now.transpose())).squaredNorm();
    const double allowed = rate_of(now) + step_ * spin, found = deforming.norm();
    Matrix limited = there;
    if (found > allowed) {
      limited -= (1.0 - allowed / found) * deforming;
    }
    constexpr double elastic_strain = 0.01;
    const double had = now.squaredNorm(), has = limited.squaredNorm();
    if (has > had && step_ * rate_of(after) > elastic_strain) {
      limited *= std::sqrt(had / has);
    }
    return limited;
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
  double* strain_rate_;
  const double* mass_;
};

}  // namespace lapilli

#pragma GCC diagnostic pop
