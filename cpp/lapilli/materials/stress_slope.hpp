#pragma once

#include "lapilli/materials/symmetric_tensor.hpp"

namespace lapilli {

/// Derivative of the components xx, yy, zz, xy, yz, xz of a stress to those of another.
using StressSlope = Eigen::Matrix<double, 6, 6>;

}  // namespace lapilli
