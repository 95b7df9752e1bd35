#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/geometry/grid.hpp"
#include "lapilli/geometry/prescribed_motion.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/materials/thermal.hpp"
#include "lapilli/mpm/heat/heat_obstacle.hpp"
#include "lapilli/mpm/heat/heat_settings.hpp"
#include "lapilli/mpm/surface/nodal_surface.hpp"
#include "lapilli/mpm/surface/wall_contact.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {

/// What heat conduction needs to know of one body.
struct HeatBody {
  Thermal material;
  double half_width = 0.25;  // of the GIMP box in cells: half the fill spacing over the cell size
  Value temperature;         // K, initial; a function of place may be given
  Value source;              // W/m^3
  std::optional<Shape> shape{};  // where it stands; absent where only points are known
  std::string name{};            // for contacts and messages; may be empty
};

/// Everything a heat solver is made from.
template <int Dim>
struct HeatProblem {
  Grid<Dim> grid;
  ShapeFunction shape = ShapeFunction::gimp;
  std::vector<HeatBody> bodies;  // by body number of the points
  HeatSettings settings;
  DistanceFunction distance;  // signed distance to the union of the bodies; may be empty
  bool moving = false;        // whether another physics moves the points
  ContactFaces walls{};       // faces of the grid that bodies rest against: no heat passes there
  bool fixed_steps = false;   // whether the user has chosen the step
  std::optional<Motion> frame{};  // the one prescribed motion of all bodies, where they share one
  std::vector<HeatObstacle> obstacles{};
  bool separates = false;  // whether the physics that moves the points knows where bodies touch
};

/// Whether heat is not linear in the temperature of the nodes of one part alone: properties depend
/// on it, something melts, or bodies at rest touch with a resistance. EnthalpyHeat solves these.
template <int Dim>
bool is_nonlinear(const HeatProblem<Dim>& problem) {
  return (!problem.settings.contacts.empty() && !problem.separates) ||
         std::any_of(problem.bodies.begin(), problem.bodies.end(),
                     [](const HeatBody& body) { return body.material.varies(); });
}

/// The heat solver a scene needs: operators integrated over the shapes where bodies rest and have
/// them; nodal operators assembled once from points where these rest and the transfer closes on the
/// nodes (FLIP does not where the surface exchanges strongly), the point-to-grid cycle otherwise.
/// Throws std::invalid_argument when the settings contradict each other.
template <int Dim>
std::unique_ptr<Physics> make_heat(Points& points, HeatProblem<Dim> problem);

}  // namespace lapilli
