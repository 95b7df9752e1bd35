#pragma once

#include <vector>

#include "lapilli/mpm/dynamics/dynamics_data.hpp"

namespace lapilli {

// Where bodies that touch move in velocity fields of their own, which of them a load at a node acts
// on: those whose free surface it is there. By mass, a block lost up to 16 % of what pushed its
// side to the base below it.

/// Area vectors sum V grad S of every field, by axis, at its nodes.
template <int Dim>
struct FieldAreas {
  const double* along[Dim];
};

/// Shares of the fields in the force at each node, by axis, nodes x fields.
template <int Dim>
std::vector<Vec<Dim>> shares_of_pressure(const DynamicsData<Dim>& data,
                                         const FieldAreas<Dim>& areas,
                                         const std::vector<Index>& nodes);

/// The same, alike along all axes, by the free surface along the normal of each node.
template <int Dim>
std::vector<Vec<Dim>> shares_of_traction(const DynamicsData<Dim>& data,
                                         const FieldAreas<Dim>& areas,
                                         const std::vector<Index>& nodes,
                                         const std::vector<Vec<Dim>>& normals);

}  // namespace lapilli
