#pragma once

#include <span>
#include <string>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/quasi_static/equilibrium.hpp"
#include "lapilli/mpm/quasi_static/loaded_surface.hpp"
#include "lapilli/mpm/quasi_static/moving_surface.hpp"

namespace lapilli {

/// A load step that may succeed when it is made smaller.
class LoadStepFailed : public RunError {
 public:
  using RunError::RunError;
};

/// A vector law at some places and a time.
template <int Dim>
std::vector<Vec<Dim>> values_at(const std::vector<Value>& law, const std::vector<Vec3>& places,
                                double time);

/// The walls and tractions of a scene.
template <int Dim>
class Boundary {
 public:
  /// Throws std::invalid_argument for surfaces and laws that cannot be used. `settings` must
  /// outlive it. `bodies`: the shapes of all bodies at time 0, where tractions on surfaces of
  /// shapes end; empty: not known.
  explicit Boundary(const QuasiStaticSettings& settings, std::vector<Shape> bodies = {});

  std::size_t walls() const { return walls_.size(); }
  const MovingSurface<Dim>& wall(std::size_t w) const { return walls_[w]; }
  const std::vector<Shape>& bodies() const { return bodies_; }
  std::span<const HeldMotion> kinds() const { return kinds_; }
  std::span<const std::string> names() const { return names_; }

  /// The facets of all walls where they stand at a time and hold material; `state` gets the moduli
  /// of empty cells. Throws RunError naming a wall that cuts no material.
  std::vector<Facet<Dim>> cut_walls(const Grid<Dim>& grid, CellState<Dim>& state,
                                    double time) const;

  /// The surfaces of all tractions at time 0. Throws RunError naming one that meets no material,
  /// leaves the grid or has its pressure on the wrong side of a body.
  std::vector<LoadedSurface<Dim>> cut_tractions(const Grid<Dim>& grid,
                                                const CellState<Dim>& state) const;
  /// The forces of the tractions at a time on these surfaces.
  std::vector<SurfaceForce<Dim>> surface_forces(const std::vector<LoadedSurface<Dim>>& surfaces,
                                                double time) const;

  /// Whether a wall stops the material across its face at a place on the surface of a body.
  bool is_held_across(const Vec<Dim>& place, double time, double cell_size) const;

  /// The wall whose face is nearest to a place at time 0, in words.
  std::string nearest_wall(const Vec<Dim>& place) const;

  /// Mark in `guarded` (rows x walls, 0 or 1) the points a wall must keep in front: those that are
  /// in front of it, or were before they went behind. Points that come from beside it are not.
  void guard(const Grid<Dim>& grid, const Points& points, double time,
             std::span<double> guarded) const;

  /// How deep the deepest guarded point goes behind its wall when the points move by `moves` until
  /// `to`, m. Throws LoadStepFailed beyond `max_penetration`, and for points that leave the
  /// grid.
  double deepest_penetration(const Grid<Dim>& grid, const Points& points,
                             const std::vector<Vec<Dim>>& moves, double to,
                             std::span<const double> guarded) const;

 private:
  const QuasiStaticSettings& settings_;
  std::vector<MovingSurface<Dim>> walls_, tractions_;
  std::vector<HeldMotion> kinds_;
  std::vector<std::string> names_;
  std::vector<Shape> bodies_;
};

}  // namespace lapilli
