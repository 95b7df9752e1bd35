#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/geometry/grid.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/materials/solid.hpp"
#include "lapilli/mpm/dynamics/dynamics_settings.hpp"
#include "lapilli/mpm/surface/nodal_surface.hpp"
#include "lapilli/mpm/transfer/shape_function.hpp"

namespace lapilli {

/// What momentum needs to know of one body.
struct DynamicsBody {
  Solid material;
  double half_width = 0.25;  // of the GIMP box in cells: half the fill spacing over the cell size
  std::function<Vec3(const Vec3&)> velocity;           // m/s at the start; empty: at rest
  std::function<SymmetricTensor(const Vec3&)> stress;  // Pa at the start; empty: none
  std::string name = {};                               // in the history; empty: its number
  std::string label = "a body";                        // in messages: "body 'sand'"
  double spacing = 0.0;                                // m, of the fill, for runs that go on
  std::optional<Shape> shape = {};                     // of one that starts anew, where it is known
};

struct PointStart;

/// Everything a momentum solver is made from.
template <int Dim>
struct DynamicsProblem {
  Grid<Dim> grid;
  ShapeFunction shape = ShapeFunction::gimp;
  std::vector<DynamicsBody> bodies;  // by body number of the points
  DynamicsSettings settings;
  DistanceFunction distance = {};  // signed distance to the union of the bodies; may be empty
  std::shared_ptr<const PointStart> start = {};   // null where all points start anew
  std::function<std::vector<Note>()> notes = {};  // on the stresses that bodies started with
};

}  // namespace lapilli
