#pragma once

#include <cmath>

#include "lapilli/mpm/dynamics/dynamics_data.hpp"

namespace lapilli {

/// Call body(node, weight) with the linear functions at a place, for the nodes around it that the
/// body of a point has, and has touched; false, without a call, where the place is off its nodes.
template <int Dim, class Body>
bool for_each_node_around(const DynamicsData<Dim>& data, Index row, const Vec<Dim>& place,
                          const Body& body) {
  const NodeField<Dim>& field = data.fields.of_body(data.points.body()[row]);
  const Grid<Dim>& grid = field.grid;
  double share[Dim];
  Index base = field.offset;
  for (int axis = 0; axis < Dim; ++axis) {
    const double at = (place[axis] - grid.origin()[axis]) * grid.inverse_cell_size();
    const auto cell = static_cast<Index>(std::floor(at));
    if (cell < 0 || cell + 1 >= grid.nodes(axis)) {
      return false;
    }
    share[axis] = at - static_cast<double>(cell);
    base += cell * grid.node_stride(axis);
  }
  for (int corner = 0; corner < 1 << Dim; ++corner) {
    Index node = base;
    double weight = 1.0;
    for (int axis = 0; axis < Dim; ++axis) {
      const bool upper = (corner >> axis) & 1;
      node += upper ? grid.node_stride(axis) : 0;
      weight *= upper ? share[axis] : 1.0 - share[axis];
    }
    if (node >= data.nodes.first() && node < data.nodes.last()) {
      body(node, weight);
    }
  }
  return true;
}

}  // namespace lapilli
