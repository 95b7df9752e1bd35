#pragma once

#include <optional>
#include <vector>

#include "lapilli/geometry/fill.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// The dimension of a scene: how many numbers grid.lower has.
int dimension_of(const Scene& scene);

/// The box that the grid spans.
Bounds grid_bounds(const Scene& scene);

/// The shape of a body where it stands, rotation and translation included; none for bodies that are
/// not given by a shape.
std::optional<Shape> placed_shape(const Body& body);

/// The points of a full cell along one axis.
int points_along_axis(const Body& body, int dimension);

/// The lattice that fills a body in the frame of its shape, and how far it may reach.
struct BodyLattice {
  Lattice lattice;
  FillOptions options;
};
BodyLattice lattice_of(const Scene& scene, const Body& body);

/// Whether the points of a body carry the volumes of their parts of its shape.
bool is_filled_exactly(const Scene& scene, const Body& body);

/// Whether the shape of a body is filled where it stands, cell by cell of the grid (`fill_cells`):
/// implicit solvers want points that integrate cut cells exactly.
bool is_filled_in_place(const Scene& scene, const Body& body);

/// The points of one body, turned and moved to their places.
FilledPoints fill_body(const Scene& scene, std::size_t body);

/// Throw std::invalid_argument where a point lies deep inside the shape of another body: two bodies
/// claim the same place. Shapes of bodies that go on (none where `goes_on` is empty) say nothing.
void require_apart(const Scene& scene, const std::vector<FilledPoints>& filled,
                   const std::vector<bool>& goes_on = {});

/// The points of every body, turned and moved to their places. Throws std::invalid_argument with
/// the place in the scene file for bodies that are empty, reach out of the grid or overlap.
std::vector<FilledPoints> fill_bodies(const Scene& scene);

}  // namespace lapilli
