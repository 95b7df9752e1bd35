#include <algorithm>
#include <limits>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/quasi_static/quasi_static.hpp"
#include "lapilli/mpm/quasi_static/supports.hpp"

namespace lapilli {

template <int Dim>
Loads<Dim> QuasiStatic<Dim>::collect_loads(double to) const {
  Loads<Dim> loads;
  loads.since_reset = reference_.moved;
  loads.largest_before = largest_force_;
  std::vector<std::vector<Vec<Dim>>> motions;
  for (const Facet<Dim>& facet : reference_.facets) {
    motions.push_back(boundary_.wall(facet.surface).increments(facet, reference_.time, to));
    loads.walls.push_back(support_term<Dim>(grid_, *reference_.state, facet,
                                            boundary_.kinds()[facet.surface], motions.back(),
                                            reference_.scheme));
  }
  hold_ends(motions, loads);
  require_agreeing<Dim>(grid_, reference_.facets, motions, boundary_.kinds(), boundary_.names());
  require_held<Dim>(grid_, points_, reference_.weights, reference_.facets, boundary_.kinds());
  loads.ghost = ghost_;
  if (ghost_ > 0.0) {
    loads.ghost_pairs = ghost_pairs<Dim>(grid_, *reference_.state, reference_.facets);
    loads.stiffness_left = stiffness_left_after([](Index) { return SymmetricTensor{}; });
  }
  if (settings_.has_weight()) {
    std::vector<Vec3> places(points_.size(), Vec3::Zero());
    std::vector<double> densities(places.size());
    for (Index p = 0; p < points_.size(); ++p) {
      places[p].template head<Dim>() = points_.position<Dim>(p);
      densities[p] = solids_.elastic(points_.body()[p]).density;
    }
    loads.body_force = weight_at(places, densities, to);
    for (Index p = 0; p < points_.size(); ++p) {
      loads.body_force[p] *= start_volume_[p] / reference_.volume[p];
    }
    if (reference_.skin) {
      split_body_force(loads);
    }
    add_hydrostatic(to, loads);
  }
  loads.surface_forces = boundary_.surface_forces(reference_.loaded, to);
  return loads;
}

template <int Dim>
void QuasiStatic<Dim>::hold_ends(const std::vector<std::vector<Vec<Dim>>>& motions,
                                 Loads<Dim>& loads) const {
  const CellState<Dim>& state = *reference_.state;
  for (const SupportEnd& end : reference_.ends) {
    const HeldMotion kind = boundary_.kinds()[reference_.facets[end.next].surface];
    if (solids_.can_yield()) {
      std::vector<std::size_t> together(end.facets);
      together.push_back(end.next);
      loads.joint_gaps.push_back(joint_gap<Dim>(grid_, state, reference_.facets, together, kind,
                                                motions, reference_.scheme));
      for (const std::size_t f : together) {
        loads.walls[f].let_go();
      }
      continue;
    }
    for (const std::size_t f : end.facets) {
      const Facet<Dim>& facet = reference_.facets[f];
      const bool averaged = state.mean.of_cell(grid_.cell_index(facet.cell)) != nullptr;
      loads.walls[f] = support_term<Dim>(grid_, state, facet, kind, motions[f],
                                         reference_.scheme.at_end(averaged));
    }
  }
}

template <int Dim>
std::vector<double> QuasiStatic<Dim>::stiffness_left_after(
    const std::function<SymmetricTensor(Index)>& increment) const {
  return solids_.can_yield()
             ? stiffness_left(grid_, reference_.weights, std::as_const(reference_.volume).values(),
                              points_.body(), solids_, increment)
             : std::vector<double>();
}

template <int Dim>
std::vector<Vec<Dim>> QuasiStatic<Dim>::weight_at(const std::vector<Vec3>& places,
                                                  const std::vector<double>& densities,
                                                  double time) const {
  std::vector<Vec<Dim>> weight = values_at<Dim>(settings_.body_force, places, time);
  if (!settings_.gravity.empty()) {
    const std::vector<Vec<Dim>> gravity = values_at<Dim>(settings_.gravity, places, time);
    for (std::size_t k = 0; k < places.size(); ++k) {
      weight[k] += densities[k] * gravity[k];
    }
  }
  return weight;
}

/// Nearly incompressible bodies hardly move under the even part of a body force where they are
/// confined: what balances it is a pressure, and errors of its integration over cut cells would
/// move them by thousands of times as much. By the divergence theorem it acts as that pressure on
/// the free surface and the means of cells, which they hold exactly.
template <int Dim>
void QuasiStatic<Dim>::split_body_force(Loads<Dim>& loads) const {
  const auto is_averaged = [&](Index p) { return reference_.state->mean.of_point(p) != nullptr; };
  double volume = 0.0;
  Vec<Dim> force = Vec<Dim>::Zero();
  for (Index p = 0; p < points_.size(); ++p) {
    if (is_averaged(p)) {
      volume += reference_.volume[p];
      force += reference_.volume[p] * loads.body_force[p];
    }
  }
  HydrostaticPressure<Dim> pressure{force / volume, 0.0};
  std::vector<LoadedPoint<Dim>> open;
  for (const LoadedPoint<Dim>& point : reference_.skin->points()) {
    if (!boundary_.is_held_across(point.position, reference_.time, grid_.cell_size())) {
      open.push_back(point);
    }
  }
  // Zero at the highest free place.
  const auto& all = open.empty() ? reference_.skin->points() : open;
  pressure.level = std::numeric_limits<double>::infinity();
  for (const LoadedPoint<Dim>& point : all) {
    pressure.level = std::min(pressure.level, pressure.rise.dot(point.position));
  }
  Vec<Dim> arrived = Vec<Dim>::Zero();
  for (const LoadedPoint<Dim>& point : open) {
    loads.skin_forces.push_back(
        {point.cell, point.position, Vec<Dim>(-pressure.at(point.position) * point.area)});
    arrived += loads.skin_forces.back().force;
  }
  for (const Facet<Dim>& facet : reference_.facets) {
    Index cell = 0;
    if (cell_mean_share(facet, cell) >= 0.0) {
      for (const SurfacePoint<Dim>& point : facet.points) {
        arrived -= pressure.at(point.position) * point.weight * point.normal;
      }
    }
  }
  loads.hydrostatic = pressure;
  // What surfaces that do not close leave of the weight stays with the points.
  const Vec<Dim> even = pressure.rise - (force - arrived) / volume;
  for (Index p = 0; p < points_.size(); ++p) {
    loads.body_force[p] -= is_averaged(p) ? even : Vec<Dim>(Vec<Dim>::Zero());
  }
}

/// Share of the mean pressure of `cell` that the traction of a facet carries by itself; negative
/// for a facet that holds nothing averaged across its face.
template <int Dim>
double QuasiStatic<Dim>::cell_mean_share(const Facet<Dim>& facet, Index& cell) const {
  cell = grid_.cell_index(facet.cell);
  const bool occupied = reference_.state->occupied[cell];
  if (!occupied) {
    cell = inner_cell(grid_, facet);
  }
  if (boundary_.kinds()[facet.surface] == HeldMotion::tangent ||
      reference_.state->mean.of_cell(cell) == nullptr) {
    return -1.0;
  }
  return occupied ? reference_.scheme.consistency : 0.0;
}

/// Of the material in every cell, kg/m^3; 0 in those without, and everywhere without gravity.
template <int Dim>
std::vector<double> QuasiStatic<Dim>::cell_densities() const {
  std::vector<double> mass(static_cast<std::size_t>(grid_.cell_count()), 0.0);
  if (settings_.gravity.empty()) {
    return mass;
  }
  std::vector<double> volume(mass);
  for (Index p = 0; p < points_.size(); ++p) {
    const Index cell = grid_.cell_index(grid_.cell_containing(points_.position<Dim>(p)));
    mass[cell] += reference_.volume[p] * solids_.elastic(points_.body()[p]).density;
    volume[cell] += reference_.volume[p];
  }
  for (std::size_t cell = 0; cell < mass.size(); ++cell) {
    mass[cell] = volume[cell] > 0.0 ? mass[cell] / volume[cell] : 0.0;
  }
  return mass;
}

/// The pressure of a nearly incompressible cell rises linearly under a body force, which its mean
/// does not say: walls carry that part as they do the mean.
template <int Dim>
void QuasiStatic<Dim>::add_hydrostatic(double to, Loads<Dim>& loads) const {
  if (std::count(averaged_.begin(), averaged_.end(), 0) == std::ssize(averaged_)) {
    return;
  }
  const std::vector<double> densities = cell_densities();
  for (std::size_t f = 0; f < reference_.facets.size(); ++f) {
    const Facet<Dim>& facet = reference_.facets[f];
    Index cell = 0;
    const double share = cell_mean_share(facet, cell);
    if (share < 0.0) {
      continue;
    }
    const Vec<Dim>& middle = reference_.state->mean.middle_of_cell(cell);
    std::vector<Vec3> places(facet.points.size(), Vec3::Zero());
    for (std::size_t q = 0; q < facet.points.size(); ++q) {
      places[q].template head<Dim>() = facet.points[q].position;
    }
    const std::vector<Vec<Dim>> force =
        weight_at(places, std::vector<double>(places.size(), densities[cell]), to);
    for (std::size_t q = 0; q < facet.points.size(); ++q) {
      const SurfacePoint<Dim>& point = facet.points[q];
      const Vec<Dim> area = point.weight * point.normal;
      const Vec<Dim> even =
          loads.hydrostatic ? loads.hydrostatic->rise : Vec<Dim>(Vec<Dim>::Zero());
      const double rest = share * (force[q] - even).dot(point.position - middle);
      double on_nodes = rest, on_wall = rest;
      if (loads.hydrostatic) {
        const double mean = share * loads.hydrostatic->at(middle);
        on_nodes -= mean;
        on_wall += loads.hydrostatic->at(point.position) - mean;
      }
      loads.walls[f].push(grid_, point, Vec<Dim>(on_nodes * area));
      loads.walls[f].given += on_wall * area;
    }
  }
}

/// What was asked of the tractions and what the nodes get.
template <int Dim>
void QuasiStatic<Dim>::require_loads_arrive(const Equilibrium<Dim>& equilibrium) const {
  constexpr double most_lost = 1e-8;
  const double lost = equilibrium.lost_surface_force();
  if (lost > most_lost) {
    throw RunError(message("a share of ", lost,
                           " of the tractions acts on nodes that carry no "
                           "stiffness: use ghost stabilisation (ghost_penalty = 0.01)"));
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                                      \
  template Loads<Dim> QuasiStatic<Dim>::collect_loads(double) const;                  \
  template std::vector<double> QuasiStatic<Dim>::stiffness_left_after(                \
      const std::function<SymmetricTensor(Index)>&) const;                            \
  template void QuasiStatic<Dim>::split_body_force(Loads<Dim>&) const;                \
  template double QuasiStatic<Dim>::cell_mean_share(const Facet<Dim>&, Index&) const; \
  template void QuasiStatic<Dim>::add_hydrostatic(double, Loads<Dim>&) const;         \
  template void QuasiStatic<Dim>::require_loads_arrive(const Equilibrium<Dim>&) const;
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
