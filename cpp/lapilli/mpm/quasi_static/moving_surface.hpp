#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lapilli/mpm/quasi_static/settings.hpp"
#include "lapilli/mpm/quasi_static/surface.hpp"

namespace lapilli {

/// The surface of a wall or a traction, carried along by its displacement.
template <int Dim>
class MovingSurface {
 public:
  /// Throws std::invalid_argument when the surface or its displacement cannot be used; `what` names
  /// it ("support 'footing'").
  MovingSurface(const SurfaceSettings& settings, const std::vector<Value>& displacement,
                std::string what, const Value& advance = 0.0);

  const std::string& what() const { return what_; }
  /// How far it has been carried at a time, m.
  Vec<Dim> offset(double time) const;
  /// Displacement increments of the boundary from one time to another at the points of a facet, m.
  std::vector<Vec<Dim>> increments(const Facet<Dim>& facet, double from, double to) const;

  /// Whether it bounds a solid; an open line does not.
  bool is_solid() const { return shape_.has_value(); }
  /// Distance of a place from the solid at a time, positive on the side of the material, m.
  double distance(const Vec3& place, double time) const;
  /// Distance of a place from the surface on the side of the material (m) if the place is in front
  /// of or behind it.
  std::optional<double> gap(const Vec3& place, double time) const;

  /// Cut it at the cells marked in `cells`, where it stands at `time`; `solids` end it, and so does
  /// the region where `counts` is not positive (m; none: everywhere).
  std::vector<Facet<Dim>> cut(const Grid<Dim>& grid, std::span<const char> cells, int number,
                              double time, std::span<const MovingSurface* const> solids,
                              const std::optional<LevelSet>& counts = {}) const;
  /// Throws RunError unless these facets make up the whole of an open line; one with `within`
  /// passes.
  void require_whole(const std::vector<Facet<Dim>>& facets) const;

 private:
  bool counts(const Vec3& place, double time) const;
  /// Of a solid, positive in the material.
  LevelSet level_set(double time) const;

  std::string what_;
  std::optional<Shape> shape_, within_;
  double side_ = 1.0;         // -1: the material is inside the shape
  std::vector<Vec<2>> line_;  // open line, or the closed outline of a shape with straight sides
  std::vector<Value> displacement_;
  Value advance_;
};

}  // namespace lapilli
