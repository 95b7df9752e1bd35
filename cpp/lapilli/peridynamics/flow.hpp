#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/flow_settings.hpp"
#include "lapilli/peridynamics/fluid.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

class PeridynamicHeat;

/// What others may ask of a flow, whatever its dimension.
class Flow : public Physics {
 public:
  virtual const PointArray& velocity() const = 0;     // m/s, rows x dimension
  virtual PointArray& velocity() = 0;                 //
  virtual const PointArray& density() const = 0;      // kg/m^3
  virtual const PointArray* dissipation() const = 0;  // W/m^3; nullptr unless asked for
  /// How far the last step shifted each point to keep all evenly spread, m, rows x dimension.
  virtual const PointArray* shifted() const = 0;
  virtual double sound_speed() const = 0;  // m/s
  /// rms(v - its mean over the family) / rms(v) over the fluid; 0 at rest.
  virtual double velocity_noise() const = 0;
  /// Least and greatest density / rho0 - 1 since the start.
  virtual std::pair<double, double> density_variation() const = 0;
  /// Least distance of a fluid point from any other since the start, in spacings; at most 1.
  virtual double smallest_spacing() const = 0;
  virtual Index searches() const = 0;
};

/// Ways in which the paper's printed equations fail; for the tests that show it.
struct PrintedEquations {
  bool old_stress = false;          // Eq. 35: acceleration from the stress of the step before
  bool towards_neighbours = false;  // Eq. 38: shifting towards the neighbours
};

/// A weakly compressible viscous fluid; `heat` may be null (no buoyancy). Moves the points.
std::unique_ptr<Flow> make_flow(Points& points, std::shared_ptr<WallSurface> walls,
                                const PeridynamicFlowSettings& settings, const Fluid& fluid,
                                const PeridynamicHeat* heat, bool with_dissipation = false,
                                PrintedEquations printed = {});

}  // namespace lapilli
