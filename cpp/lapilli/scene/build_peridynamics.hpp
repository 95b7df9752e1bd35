#pragma once

#include <memory>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/geometry/fill.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// Whether a scene is peridynamic heat without flow in the form that wants bodies cut where their
/// surface runs: its points never move and carry the volumes of their parts.
bool conducts_at_rest(const Scene& scene);

/// Whether a scene has a peridynamic fluid whose particles move.
bool flows(const Scene& scene);

/// The points of every wall of a peridynamic scene that its fluid can feel, one entry a wall;
/// nothing where the scene has no [peridynamics]. `filled` holds the points of its bodies. Throws
/// std::invalid_argument for bodies that differ in spacing or have no shape, and for walls out of
/// reach of the fluid.
std::vector<FilledPoints> fill_walls(const Scene& scene, const std::vector<FilledPoints>& filled);

/// The physics of [peridynamics]. `points` holds those of the bodies, then those of the walls.
std::vector<std::unique_ptr<Physics>> physics_of_peridynamics(
    const Scene& scene, const std::vector<FilledPoints>& filled, Points& points);

}  // namespace lapilli
