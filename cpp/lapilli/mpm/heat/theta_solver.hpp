#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "lapilli/algebra/stencil_matrix.hpp"
#include "lapilli/core/physics.hpp"
#include "lapilli/mpm/heat/boundary_conditions.hpp"

namespace lapilli {

/// Solves (C + theta dt (K + slopes)) d = residual for the increment of the nodal temperatures.
/// The factor is kept as long as step and slopes stay.
template <int Dim>
class ThetaSolver {
 public:
  ThetaSolver(const NodeRows<Dim>& rows, const StencilMatrix<Dim>& conduction,
              std::span<const double> lumped, HeatSolver choice);
  ~ThetaSolver();

  /// Factorise for `scale` = theta dt and the laws' present slopes, unless that was done already.
  void prepare(double scale, const BoundaryConditions<Dim>& laws);
  /// increment = matrix^-1 residual, both by place. Throws RunError when the solver fails.
  void solve(std::span<const double> residual, std::span<double> increment);

 private:
  struct Backend;
  const StencilMatrix<Dim>& conduction_;
  std::span<const double> lumped_;
  std::vector<Index> number_;  // unknown of a place, -1 inactive
  std::vector<Index> place_;   // of an unknown
  std::unique_ptr<Backend> backend_;
  double scale_ = -1.0;
  std::vector<double> slopes_;
};

}  // namespace lapilli
