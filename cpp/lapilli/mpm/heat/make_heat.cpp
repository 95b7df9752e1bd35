#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/cut_cell_heat.hpp"
#include "lapilli/mpm/heat/enthalpy_heat.hpp"
#include "lapilli/mpm/heat/heat_in_body_frame.hpp"
#include "lapilli/mpm/heat/nodal_heat.hpp"
#include "lapilli/mpm/heat/particle_heat.hpp"
#include "lapilli/mpm/heat/step_bound.hpp"

namespace lapilli {
namespace {

/// Whether nothing needs to touch the points in a step.
template <int Dim>
bool closes_on_nodes(const HeatProblem<Dim>& problem) {
  const HeatSettings& settings = problem.settings;
  return !problem.moving && settings.method != FluxMethod::particle &&
         settings.transfer != HeatTransfer::affine && settings.transfer != HeatTransfer::tpic &&
         !(settings.transfer == HeatTransfer::flip && settings.implicit_robin &&
           exchanges_strongly(problem));
}

}  // namespace

template <int Dim>
std::unique_ptr<Physics> make_heat(Points& points, HeatProblem<Dim> problem) {
  if (HeatInBodyFrame<Dim>::suits(problem)) {
    return std::make_unique<HeatInBodyFrame<Dim>>(points, std::move(problem));
  }
  require(!problem.moving || problem.settings.transfer != HeatTransfer::nodal,
          "heat.transfer = \"nodal\" needs points at rest or one rigid motion of all bodies, but "
          "this scene moves them");
  const bool cut_cells = CutCellHeat<Dim>::suits(problem);
  if (is_nonlinear(problem)) {
    require(cut_cells,
            "properties that depend on the temperature, latent heat and heat.contacts need bodies "
            "with shapes, at rest or in one rigid motion, and the defaults of heat.method, "
            "heat.transfer, heat.normal_smoothing, heat.corner_fit and heat.implicit_robin");
    require(problem.settings.time_integration != TimeIntegration::implicit_theta,
            "properties that depend on the temperature, latent heat and heat.contacts are stepped "
            "explicitly: leave heat.time_integration out");
    return std::make_unique<EnthalpyHeat<Dim>>(points, std::move(problem));
  }
  TimeIntegration& stepping = problem.settings.time_integration;
  if (stepping == TimeIntegration::automatic && (!cut_cells || problem.fixed_steps)) {
    stepping = TimeIntegration::explicit_euler;
  }
  if (cut_cells) {
    return std::make_unique<CutCellHeat<Dim>>(points, std::move(problem));
  }
  if (closes_on_nodes(problem)) {
    return std::make_unique<NodalHeat<Dim>>(points, std::move(problem));
  }
  return std::make_unique<ParticleHeat<Dim>>(points, std::move(problem));
}

template std::unique_ptr<Physics> make_heat(Points&, HeatProblem<1>);
template std::unique_ptr<Physics> make_heat(Points&, HeatProblem<2>);
template std::unique_ptr<Physics> make_heat(Points&, HeatProblem<3>);

}  // namespace lapilli
