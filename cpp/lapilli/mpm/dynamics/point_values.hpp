#pragma once

#include "lapilli/mpm/dynamics/dynamics_data.hpp"
#include "lapilli/mpm/dynamics/point_kernel.hpp"

namespace lapilli {

/// The stress of a point, Pa.
template <int Dim>
SymmetricTensor stress_of(const DynamicsData<Dim>& data, Index row) {
  constexpr int components = DynamicsData<Dim>::stress_components;
  SymmetricTensor stress;
  for (int c = 0; c < components; ++c) {
    stress[c] = data.stress[row * components + c];
  }
  return stress;
}

/// Second moments of the shape function of a point along every axis, m2.
template <int Dim>
Vec<Dim> second_moments(const DynamicsData<Dim>& data, Index row) {
  Vec<Dim> moments;
  with_transfer(data.shape, data.settings.transfer, [&]<class Shape, VelocityTransfer>() {
    const ShapeOfBody<Shape> shape_of(data.half_widths);
    const AxisWeights<Dim, Shape> axes(data.grid, shape_of(data.points.body()[row]),
                                       data.points.position().data() + row * Dim);
    for (int axis = 0; axis < Dim; ++axis) {
      moments[axis] = second_moment(axes, data.grid.cell_size(), axis);
    }
  });
  return moments;
}

}  // namespace lapilli
