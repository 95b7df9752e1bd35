#include "lapilli/mpm/quasi_static/boundary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/in_space.hpp"
#include "lapilli/mpm/quasi_static/on_bodies.hpp"

namespace lapilli {
namespace {

template <int Dim>
double total_area(const std::vector<Facet<Dim>>& facets) {
  double sum = 0.0;
  for (const Facet<Dim>& facet : facets) {
    sum += facet.area();
  }
  return sum;
}

/// Where there is a body, and `off` (m) around it.
LevelSet on_bodies(const std::vector<Shape>& bodies, double off) {
  return {[&bodies, off](const Vec3& at) { return off - distance_to(bodies, at); },
          [&bodies](const Vec3& at) {
            const auto nearest = std::ranges::min_element(
                bodies, {}, [&at](const Shape& body) { return lapilli::distance(body, at); });
            return Vec3(-lapilli::gradient(*nearest, at));
          }};
}

template <int Dim>
bool holds_averaged(const Grid<Dim>& grid, const CellState<Dim>& state,
                    const std::vector<Facet<Dim>>& facets) {
  return std::any_of(facets.begin(), facets.end(), [&](const Facet<Dim>& facet) {
    return state.mean.of_cell(grid.cell_index(facet.cell)) != nullptr;
  });
}

/// Whether no wall ever moves, or pushes bodies, farther than points may go before a reset, m.
bool walls_stay(const std::vector<SupportSettings>& walls, double far) {
  const auto stays = [far](const Value& way) { return way.largest() < far && way.least() > -far; };
  return std::ranges::all_of(walls, [&](const SupportSettings& wall) {
    return stays(wall.advance) && std::ranges::all_of(wall.displacement, stays);
  });
}

/// Walls that go on beyond bodies at rest would hold and push where there is nothing: let their
/// facets end with the bodies, where they lie on them.
template <int Dim, class Cut>
void end_with_bodies(const std::vector<Shape>& bodies, std::vector<Facet<Dim>>& facets,
                     const Cut& cut, double cell_size) {
  constexpr double exact = 1e-9, in = 0.05, most = 0.9;
  if (bodies.empty()) {
    return;
  }
  double covered = 0.0;
  for (const Facet<Dim>& facet : facets) {
    for (const SurfacePoint<Dim>& point : facet.points) {
      const Vec<Dim> inside = point.position + in * cell_size * point.normal;
      covered += distance_to(bodies, in_space<Dim>(inside)) < 0.0 ? point.weight : 0.0;
    }
  }
  std::vector<Facet<Dim>> ended = cut(on_bodies(bodies, exact * cell_size));
  if (total_area(ended) > most * covered && !ended.empty()) {
    facets = std::move(ended);
  }
}

}  // namespace

template <int Dim>
std::vector<Vec<Dim>> values_at(const std::vector<Value>& law, const std::vector<Vec3>& places,
                                double time) {
  std::vector<Vec<Dim>> vectors(places.size(), Vec<Dim>::Zero());
  std::vector<double> values(places.size());
  for (std::size_t axis = 0; axis < law.size(); ++axis) {
    law[axis].evaluate(places, {}, time, values);
    for (std::size_t k = 0; k < places.size(); ++k) {
      vectors[k][static_cast<int>(axis)] = values[k];
    }
  }
  return vectors;
}

template <int Dim>
Boundary<Dim>::Boundary(const QuasiStaticSettings& settings, std::vector<Shape> bodies)
    : settings_(settings), bodies_(std::move(bodies)) {
  for (const Shape& body : bodies_) {
    check(body, Dim);
  }
  for (const SupportSettings& wall : settings.supports) {
    names_.push_back(wall.name.empty() ? message(names_.size() + 1) : wall.name);
    kinds_.push_back(wall.kind);
    walls_.emplace_back(wall.surface, wall.displacement, "support '" + names_.back() + "'",
                        wall.advance);
  }
  for (const TractionSettings& traction : settings.tractions) {
    require(traction.traction.size() <= Dim, "traction '", traction.name, "' has ",
            traction.traction.size(), " values, the scene has ", Dim, " axes");
    require(!traction.traction.empty() || !traction.pressure.is_constant() ||
                traction.pressure.at(0.0) != 0.0,
            "traction '", traction.name, "' needs a traction or a pressure");
    tractions_.emplace_back(traction.surface, std::vector<Value>{},
                            "traction '" + traction.name + "'");
  }
}

template <int Dim>
std::vector<Facet<Dim>> Boundary<Dim>::cut_walls(const Grid<Dim>& grid, CellState<Dim>& state,
                                                 double time) const {
  const std::vector<char> near = cells_near_material(grid, state);
  std::vector<const MovingSurface<Dim>*> solids;
  for (const auto& wall : walls_) {
    solids.push_back(&wall);
  }
  std::vector<Facet<Dim>> all;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    std::vector<Facet<Dim>> facets = walls_[w].cut(grid, near, static_cast<int>(w), time, solids);
    if (time == 0.0 && settings_.hold_empty_cells) {
      reach_from_bodies(grid, state, bodies_, facets);
    }
    facets = facets_at_material(grid, state, std::move(facets), settings_.hold_empty_cells);
    if (facets.empty()) {
      throw RunError(message(walls_[w].what(), " cuts no material",
                             settings_.hold_empty_cells ? "" : " (hold_empty_cells is off)",
                             ": move it to the body's surface, or check on which side of it the "
                             "material is"));
    }
    const bool ends = settings_.enforcement != Enforcement::literal &&
                      walls_stay(settings_.supports, 0.1 * grid.cell_size());
    if (time == 0.0 && (ends || holds_averaged(grid, state, facets))) {
      end_with_bodies(
          bodies_, facets,
          [&](const LevelSet& on_a_body) {
            return facets_at_material(
                grid, state,
                walls_[w].cut(grid, near, static_cast<int>(w), time, solids, on_a_body),
                settings_.hold_empty_cells);
          },
          grid.cell_size());
    }
    all.insert(all.end(), facets.begin(), facets.end());
  }
  return all;
}

template <int Dim>
std::vector<LoadedSurface<Dim>> Boundary<Dim>::cut_tractions(const Grid<Dim>& grid,
                                                             const CellState<Dim>& state) const {
  // Surfaces of shapes may go on beyond a body, and end there. One that is not quite on the body,
  // a circle on a polygon, still counts this far off it (cells).
  constexpr double exact = 1e-9, slack = 1e-3, most = 0.9;
  const double h = grid.cell_size();
  const std::vector<char> everywhere(grid.cell_count(), 1);
  const std::vector<char> near = cells_near_material(grid, state);
  std::vector<LoadedSurface<Dim>> surfaces;
  for (const MovingSurface<Dim>& traction : tractions_) {
    std::vector<Facet<Dim>> facets;
    if (!traction.is_solid()) {
      facets = traction.cut(grid, everywhere, 0, 0.0, {});
      traction.require_whole(facets);
    } else if (!bodies_.empty()) {
      facets = traction.cut(grid, near, 0, 0.0, {}, on_bodies(bodies_, exact * h));
      auto rough = traction.cut(grid, near, 0, 0.0, {}, on_bodies(bodies_, slack * h));
      if (total_area(facets) < most * total_area(rough)) {
        facets = std::move(rough);
      }
    } else {
      CellState<Dim> moduli = state;
      facets = facets_at_material(grid, moduli, traction.cut(grid, near, 0, 0.0, {}), true);
    }
    if (facets.empty()) {
      throw RunError(message(traction.what(), " meets no material: move it to the body's surface"));
    }
    const TractionSettings& law = settings_.tractions[surfaces.size()];
    if (!bodies_.empty() && (!law.pressure.is_constant() || law.pressure.at(0.0) != 0.0)) {
      require_pushes(bodies_, facets, h, law.surface, traction.what());
    }
    surfaces.emplace_back(traction.what());
    surfaces.back().start(facets);
  }
  return surfaces;
}

template <int Dim>
std::vector<SurfaceForce<Dim>> Boundary<Dim>::surface_forces(
    const std::vector<LoadedSurface<Dim>>& surfaces, double time) const {
  std::vector<SurfaceForce<Dim>> forces;
  for (std::size_t t = 0; t < surfaces.size(); ++t) {
    const std::vector<LoadedPoint<Dim>>& points = surfaces[t].points();
    std::vector<Vec3> places;
    for (const LoadedPoint<Dim>& point : points) {
      places.push_back(in_space<Dim>(point.position));
    }
    const TractionSettings& law = settings_.tractions[t];
    const std::vector<Vec<Dim>> tractions = values_at<Dim>(law.traction, places, time);
    std::vector<double> pressures(places.size());
    law.pressure.evaluate(places, {}, time, pressures);
    for (std::size_t q = 0; q < points.size(); ++q) {
      const Vec<Dim>& area = points[q].area;
      forces.push_back({points[q].cell, points[q].position,
                        Vec<Dim>(area.norm() * tractions[q] + pressures[q] * area)});
    }
  }
  return forces;
}

template <int Dim>
bool Boundary<Dim>::is_held_across(const Vec<Dim>& place, double time, double cell_size) const {
  constexpr double near = 0.02;  // cells
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    const auto gap = walls_[w].gap(in_space<Dim>(place), time);
    if (gap && std::abs(*gap) < near * cell_size && kinds_[w] != HeldMotion::tangent) {
      return true;
    }
  }
  return false;
}

template <int Dim>
std::string Boundary<Dim>::nearest_wall(const Vec<Dim>& place) const {
  std::string near = "no support";
  double least = std::numeric_limits<double>::infinity();
  for (const auto& wall : walls_) {
    const auto gap = wall.gap(in_space<Dim>(place), 0.0);
    if (gap && std::abs(*gap) < least) {
      least = std::abs(*gap);
      near = wall.what();
    }
  }
  return near;
}

template <int Dim>
void Boundary<Dim>::guard(const Grid<Dim>& grid, const Points& points, double time,
                          std::span<double> guarded) const {
  const double slack = 1e-9 * grid.cell_size();
  for (Index p = 0; p < points.size(); ++p) {
    const Vec3 place = in_space<Dim>(points.position<Dim>(p));
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      if (kinds_[w] == HeldMotion::tangent) {
        continue;  // free across its face
      }
      double& mark = guarded[p * walls_.size() + w];
      const auto gap = walls_[w].gap(place, time);
      mark = gap && (mark > 0.0 || *gap >= -slack) ? 1.0 : 0.0;
    }
  }
}

template <int Dim>
double Boundary<Dim>::deepest_penetration(const Grid<Dim>& grid, const Points& points,
                                          const std::vector<Vec<Dim>>& moves, double to,
                                          std::span<const double> guarded) const {
  const double limit = settings_.max_penetration * grid.cell_size();
  double deepest = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<Dim> after = points.position<Dim>(p) + moves[p];
    if (!grid.contains(after)) {
      throw LoadStepFailed(message("point ", points.id()[p], " leaves the grid at ",
                                   after.transpose(), " m: enlarge the grid or lower the load"));
    }
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      if (guarded[p * walls_.size() + w] == 0.0) {
        continue;
      }
      const auto gap = walls_[w].gap(in_space<Dim>(after), to);
      if (!gap || -*gap <= deepest) {
        continue;
      }
      deepest = -*gap;
      if (deepest > limit) {
        throw LoadStepFailed(message(
            "point ", points.id()[p], " is pushed ", deepest, " m through ", walls_[w].what(),
            " at ", after.transpose(), " m, more than max_penetration of ",
            settings_.max_penetration,
            " cells: take smaller load steps, more points per cell or gimp shape functions"));
      }
    }
  }
  return deepest;
}

template std::vector<Vec<2>> values_at<2>(const std::vector<Value>&, const std::vector<Vec3>&,
                                          double);
template std::vector<Vec<3>> values_at<3>(const std::vector<Value>&, const std::vector<Vec3>&,
                                          double);
template class Boundary<2>;
template class Boundary<3>;

}  // namespace lapilli
