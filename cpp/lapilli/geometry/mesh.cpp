#include "lapilli/geometry/mesh.hpp"

#include <cmath>

#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/stl_file.hpp"

namespace lapilli {
namespace {

const TriangleSurface& surface_of(const Mesh& mesh) {
  require(mesh.surface != nullptr, "mesh: asked before it was checked; call check(shape, 3) first");
  return *mesh.surface;
}

Triangles given_triangles(const Mesh& mesh) {
  Triangles all;
  for (std::size_t k = 0; k < mesh.vertices.size(); ++k) {
    require_row(mesh.vertices[k], 3, Mesh::kind, "vertex", k);
    all.vertices.push_back(place(mesh.vertices[k]));
  }
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const auto& row = mesh.triangles[k];
    require(row.size() == 3, "mesh: triangle ", k, " needs 3 vertices, got ", row.size());
    all.rows.push_back({row[0], row[1], row[2]});
  }
  return all;
}

}  // namespace

double Mesh::distance(const Vec3& x) const {
  const TriangleSurface& triangles_of_surface = surface_of(*this);
  const double away = std::sqrt(triangles_of_surface.nearest(x).squared);
  return triangles_of_surface.winding(x) != 0 ? -away : away;
}

Vec3 Mesh::gradient(const Vec3& x) const {
  const TriangleSurface& triangles_of_surface = surface_of(*this);
  const auto nearest = triangles_of_surface.nearest(x);
  const Bounds& box = triangles_of_surface.bounds();
  if (std::sqrt(nearest.squared) <= 1e-12 * (box.upper - box.lower).norm()) {
    return triangles_of_surface.normal(nearest.triangle);
  }
  const Vec3 direction = (x - nearest.place).normalized();
  return triangles_of_surface.winding(x) != 0 ? Vec3(-direction) : direction;
}

Bounds Mesh::bounds() const { return surface_of(*this).bounds(); }

void Mesh::check(int dimension) const {
  require_dimension(dimension, 3, kind, "a polygon");
  require_positive(scale, kind, "scale");
  const bool given = !vertices.empty() || !triangles.empty();
  require(file.empty() != !given, given ? "mesh: give a file or vertices and triangles, not both"
                                        : "mesh: give a file, or vertices and triangles");
  Triangles all = given ? given_triangles(*this) : read_stl(file);
  for (Vec3& vertex : all.vertices) {
    vertex *= scale;
  }
  surface = std::make_shared<const TriangleSurface>(std::move(all), given ? "mesh" : file);
}

}  // namespace lapilli
