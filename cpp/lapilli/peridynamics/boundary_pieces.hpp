#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// A flat piece of the surface of a body.
struct BoundaryPiece {
  Vec3 place;     // m, its centroid
  Vec3 normal;    // unit, out of the body
  double area;    // m^(dimension - 1)
  int wall = -1;  // which wall it meets; -1: none
};

/// Boxes of side `side` (m) in which surface is looked for; `lower` corners, m.
struct SurfaceBoxes {
  std::vector<Vec3> lower;
  double side = 1.0;
  int dimension = 2;
};

/// Pieces of the surface of a region within each box, in the order of the boxes.
///
/// `region` is a signed distance, negative inside, that changes by at most the way walked. In a box
/// it is taken as the largest (convex edge) or the smallest (re-entrant edge) of a few planes,
/// where it is that; a surface that is smooth and bends by less than 2 % of the box is cut along
/// simplices; other boxes are halved, up to 7 times in two and 4 times in three dimensions, as are
/// those in which pieces meet several walls. Polygons and polyhedra are exact to rounding, smooth
/// surfaces to 1e-3 at four and 2e-4 at ten boxes of radius. `wall_at(place, normal)` names the
/// wall that the surface meets there, -1 for none. Inner faces, where two bodies of a union touch,
/// give no piece.
std::vector<std::vector<BoundaryPiece>> boundary_pieces(
    const std::function<double(const Vec3&)>& region, const SurfaceBoxes& boxes,
    const std::function<int(const Vec3&, const Vec3&)>& wall_at);

}  // namespace lapilli
