#pragma once

namespace lapilli {

/// A vector at every node: an array over the nodes for each axis.
template <int Dim>
struct AxisArrays {
  double* axis[Dim];
  double* operator[](int along) const { return axis[along]; }
};

}  // namespace lapilli
