#pragma once

#include <functional>
#include <memory>

#include "lapilli/algebra/stencil_matrix.hpp"
#include "lapilli/mpm/heat/point_fields.hpp"

namespace lapilli {

/// The nodal operators of points at rest, stored for the active nodes only.
template <int Dim>
struct NodalOperators {
  std::vector<unsigned char> active;  // by node of the grid
  std::unique_ptr<NodeRows<Dim>> rows;
  std::unique_ptr<StencilMatrix<Dim>> conduction;  // K = sum V grad S . k grad S, W/K
  std::unique_ptr<StencilMatrix<Dim>> capacity;    // M = sum m S S, J/K; absent unless asked for
  std::vector<double> lumped;                      // C = sum m S by place, J/K
};

template <int Dim>
NodalOperators<Dim> assemble_operators(const Points& points, const HeatProblem<Dim>& problem,
                                       const HeatCoefficients<Dim>& coefficients,
                                       const std::vector<double>& capacity, bool with_capacity);

/// n . k n at a node, the bodies' conductivities weighted by their volume there.
template <int Dim>
std::function<double(Index, const Vec<Dim>&)> nodal_conductivity(
    const Points& points, const HeatProblem<Dim>& problem,
    const HeatCoefficients<Dim>& coefficients, const NodalSums<Dim>& sums);

}  // namespace lapilli
