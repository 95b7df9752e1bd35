#pragma once

#include "lapilli/mpm/dynamics/dynamics_data.hpp"
#include "lapilli/mpm/dynamics/stencil.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {

/// The shape function of the points of each body.
template <class Shape>
class ShapeOfBody {
 public:
  explicit ShapeOfBody(const std::vector<double>& half_widths) : half_widths_(half_widths.data()) {}
  Shape operator()(Index body) const {
    if constexpr (Shape::support == 2) {
      return Shape{};
    } else {
      return Shape{half_widths_[body]};
    }
  }

 private:
  const double* half_widths_;
};

/// Levers of the affine transfers: shape function times distance along one axis, sum over nodes of
/// lever(k) = S (x_k - x).
template <int Dim, class Shape>
void levers(const AxisWeights<Dim, Shape>& weights, double h,
            double (&lever)[Dim][Shape::support]) {
  for (int axis = 0; axis < Dim; ++axis) {
    for (int k = 0; k < Shape::support; ++k) {
      lever[axis][k] = weights.value[axis][k] * (weights.base[axis] + k - weights.at[axis]) * h;
    }
  }
}

/// Second moment along one axis, sum S (x_k - x)^2, m2.
template <int Dim, class Shape>
double second_moment(const AxisWeights<Dim, Shape>& weights, double h, int axis) {
  double sum = 0.0;
  for (int k = 0; k < Shape::support; ++k) {
    const double distance = weights.base[axis] + k - weights.at[axis];
    sum += weights.value[axis][k] * distance * distance;
  }
  return sum * h * h;
}

/// Whether points carry an affine part. Under linear functions the blend leaves it out: the moment
/// that it divides by vanishes where a hat function meets a node.
template <VelocityTransfer transfer, class Shape>
inline constexpr bool is_affine =
    transfer == VelocityTransfer::blended_apic ? Shape::support > 2
                                               : transfer != VelocityTransfer::flip;

/// Factors that multiply the affine matrix of a point when it is projected: the levers, with APIC
/// these over the second moment (zero where a hat function meets a node: refused).
template <VelocityTransfer transfer, int Dim, class Shape>
void affine_factors(const AxisWeights<Dim, Shape>& weights, double h,
                    double (&factor)[Dim][Shape::support]) {
  levers(weights, h, factor);
  if constexpr (transfer == VelocityTransfer::apic) {
    for (int axis = 0; axis < Dim; ++axis) {
      const double inverse = 1.0 / second_moment(weights, h, axis);
      for (int k = 0; k < Shape::support; ++k) {
        factor[axis][k] *= inverse;
      }
    }
  }
}

/// One call of body.template operator()<Shape, transfer>() with the types a scene chose.
template <class Body>
void with_transfer(ShapeFunction shape, VelocityTransfer transfer, const Body& body) {
  const auto shaped = [&]<class Shape>() {
    switch (transfer) {
      case VelocityTransfer::blended_apic:
        return body.template operator()<Shape, VelocityTransfer::blended_apic>();
      case VelocityTransfer::flip:
        return body.template operator()<Shape, VelocityTransfer::flip>();
      case VelocityTransfer::apic:
        return body.template operator()<Shape, VelocityTransfer::apic>();
      case VelocityTransfer::tpic:
        return body.template operator()<Shape, VelocityTransfer::tpic>();
    }
  };
  if (shape == ShapeFunction::linear) {
    shaped.template operator()<LinearShape>();
  } else {
    shaped.template operator()<GimpShape>();
  }
}

}  // namespace lapilli

#pragma GCC diagnostic pop
