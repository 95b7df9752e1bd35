#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace lapilli {

template <int Dim>
using Vec = Eigen::Matrix<double, Dim, 1>;
template <int Dim>
using Mat = Eigen::Matrix<double, Dim, Dim>;

/// A place in space; scenes of one or two dimensions leave the last coordinates zero.
using Vec3 = Vec<3>;
using Mat3 = Mat<3>;

using Index = std::int64_t;

}  // namespace lapilli
