#pragma once

#include <vector>

#include "lapilli/mpm/heat/heat_problem.hpp"

namespace lapilli {

/// Conductivity and capacity of the bodies in the form the loops want.
template <int Dim>
struct HeatCoefficients {
  explicit HeatCoefficients(const std::vector<HeatBody>& bodies, ShapeFunction shape);

  std::vector<double> capacity;        // rho0 c by body, J/(m^3 K)
  std::vector<Mat<Dim>> conductivity;  // by body, W/(m K)
  std::vector<double> half_width;      // of the shape function by body, cells
  double largest_diffusivity = 0.0;    // m^2/s
  bool uniform = false;                // one isotropic material, one half-width
};

/// Capacity rho0 c V0 of every point from its present (undeformed) volume, J/K.
std::vector<double> point_capacities(const Points& points, const std::vector<HeatBody>& bodies);

/// Initial temperature of every point, K. Throws std::invalid_argument naming the point when a
/// value is not finite.
std::vector<double> initial_temperatures(const Points& points, const std::vector<HeatBody>& bodies);

/// Nodal temperatures T_I = sum m S (T_p + G_p . (x_I - x_p)) / C_I at every node of the grid (zero
/// where inactive). With `gradient` (rows x Dim, may be null: G = 0), G is recovered from the nodes
/// in two passes, body by body: second order for smooth fields, exact for uniform bodies.
template <int Dim>
std::vector<double> map_initial(const Points& points, const HeatProblem<Dim>& problem,
                                const HeatCoefficients<Dim>& coefficients,
                                const std::vector<double>& capacity,
                                const std::vector<double>& temperature,
                                std::vector<double>* gradient);

}  // namespace lapilli
