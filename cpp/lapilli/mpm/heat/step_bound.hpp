#pragma once

#include "lapilli/algebra/stencil_matrix.hpp"
#include "lapilli/mpm/heat/boundary_conditions.hpp"
#include "lapilli/mpm/heat/point_fields.hpp"

namespace lapilli {

/// A bound on the largest eigenvalue of C^-1 (K + couplings), 1/s, from Gershgorin's circles of
/// D^-1 C^-1 K D; the scaling D is improved pass by pass, and every pass is a bound of its own.
template <int Dim>
double fastest_rate(const StencilMatrix<Dim>& conduction, std::span<const double> lumped,
                    std::span<const NodeCoupling> couplings = {});

/// The largest diagonal entry of C^-1 K, 1/s: over a step beyond its inverse a node
/// would pass the mean of its neighbours.
template <int Dim>
double fastest_node(const StencilMatrix<Dim>& conduction, std::span<const double> lumped);

/// The largest eigenvalue of C^-1 M C^-1 K, 1/s: how fast points that carry temperature by FLIP
/// answer. Estimated by powers, 5 % on the safe side.
template <int Dim>
double fastest_carried_rate(const StencilMatrix<Dim>& conduction,
                            const StencilMatrix<Dim>& capacity, std::span<const double> lumped);

/// Hard limit of FLIP and PIC with one material, in h^2/alpha. FLIP runs to 1.03 at the least and
/// to 1.5 with quadratic B-splines on every set of points measured; PIC, whose points also forget,
/// to 0.7.
double carried_limit(HeatTransfer transfer, ShapeFunction shape);

/// Whether convection or radiation may be so strong (coefficient h / conductivity > 1) that points
/// with FLIP would be carried past the surroundings.
template <int Dim>
bool exchanges_strongly(const HeatProblem<Dim>& problem);

/// Limits of an explicit step for points that carry temperature. One material: the multiple of
/// h^2/alpha above for FLIP and PIC, 1.6 l h/alpha (GIMP half-width l, at most 0.4 h^2/alpha) for
/// transfers with a gradient; several: the bound of the nodal operator at the points' present
/// places.
template <int Dim>
StepLimit explicit_step_limit(const Points& points, const HeatProblem<Dim>& problem,
                              const HeatCoefficients<Dim>& coefficients,
                              std::span<const double> capacity, HeatTransfer transfer);

}  // namespace lapilli
