#pragma once

#include <variant>

#include "lapilli/geometry/box.hpp"
#include "lapilli/geometry/combine.hpp"
#include "lapilli/geometry/ellipse.hpp"
#include "lapilli/geometry/height_field.hpp"
#include "lapilli/geometry/image_mask.hpp"
#include "lapilli/geometry/mesh.hpp"
#include "lapilli/geometry/polygon.hpp"
#include "lapilli/geometry/round.hpp"

namespace lapilli {

/// Any shape: plain data with a signed distance, negative inside. Scenes of one or two dimensions
/// leave the last coordinates zero.
struct Shape : std::variant<Box, HalfSpace, Disk, Annulus, Ellipse, Sphere, Ellipsoid, Cylinder,
                            Polygon, Mesh, HeightField, ImageMask, Union, Intersection, Difference,
                            Rotated, Translated> {
  using variant::variant;
};

/// Signed distance to the surface (m), negative inside. Exact for simple shapes, otherwise of the
/// right sign and at most the true size; each shape says which.
double distance(const Shape& shape, const Vec3& x);

/// Unit outward normal of the surface nearest to `x`: the gradient of the distance.
Vec3 gradient(const Shape& shape, const Vec3& x);

/// A point of the surface near `x`: the nearest one where the distance is exact; otherwise reached
/// by walking down the distance, on the surface to 1e-12 of the way walked, to rounding, or as near
/// as 64 steps bring it.
Vec3 project(const Shape& shape, const Vec3& x);

/// A box that holds the shape.
Bounds bounds(const Shape& shape);

/// Whether a region selects the place `x`: inside, or at most `slack` (m) outside.
bool covers(const Shape& shape, const Vec3& x, double slack = 0.0);

/// Throws std::invalid_argument unless every number of the shape is usable on a grid of `dimension`
/// axes: what was given, what is allowed, in which shape. Reads the files the shape names and
/// prepares what queries need, so that later queries neither throw nor wait: call it once for each
/// shape before the functions above (`fill` does), and again when its members have changed; copies
/// share what was prepared. Not to be called while other threads ask.
void check(const Shape& shape, int dimension);

/// The name of the shape in scene files: "annulus".
const char* kind_of(const Shape& shape);

}  // namespace lapilli
