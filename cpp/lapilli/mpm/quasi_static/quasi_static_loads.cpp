#include "lapilli/core/require.hpp"
#include "lapilli/mpm/quasi_static/quasi_static.hpp"
#include "lapilli/mpm/quasi_static/supports.hpp"

namespace lapilli {

template <int Dim>
Loads<Dim> QuasiStatic<Dim>::collect_loads(double to) const {
  Loads<Dim> loads;
  loads.since_reset = reference_.moved;
  std::vector<std::vector<Vec<Dim>>> motions;
  for (const Facet<Dim>& facet : reference_.facets) {
    motions.push_back(boundary_.wall(facet.surface).increments(facet, reference_.time, to));
    loads.walls.push_back(support_term<Dim>(grid_, *reference_.state, facet,
                                            boundary_.kinds()[facet.surface], motions.back(),
                                            reference_.scheme));
  }
  require_agreeing<Dim>(grid_, reference_.facets, motions, boundary_.kinds(), boundary_.names());
  require_held<Dim>(grid_, points_, reference_.weights, reference_.facets, boundary_.kinds());
  loads.ghost = ghost_;
  if (ghost_ > 0.0) {
    loads.ghost_pairs = ghost_pairs<Dim>(grid_, *reference_.state, reference_.facets);
  }
  if (!settings_.body_force.empty()) {
    add_hydrostatic(to, loads);
    std::vector<Vec3> places(points_.size(), Vec3::Zero());
    for (Index p = 0; p < points_.size(); ++p) {
      places[p].template head<Dim>() = points_.position<Dim>(p);
    }
    loads.body_force = values_at<Dim>(settings_.body_force, places, to);
    for (Index p = 0; p < points_.size(); ++p) {
      loads.body_force[p] *= start_volume_[p] / reference_.volume[p];
    }
  }
  loads.surface_forces = boundary_.surface_forces(reference_.loaded, to);
  return loads;
}

/// The pressure of a nearly incompressible cell rises linearly under a body force, which its mean
/// does not say: walls carry that part as they do the mean.
template <int Dim>
void QuasiStatic<Dim>::add_hydrostatic(double to, Loads<Dim>& loads) const {
  for (std::size_t f = 0; f < reference_.facets.size(); ++f) {
    const Facet<Dim>& facet = reference_.facets[f];
    const Index cell = grid_.cell_index(facet.cell);
    if (reference_.state->mean.of_cell(cell) == nullptr || !reference_.state->occupied[cell] ||
        boundary_.kinds()[facet.surface] == HeldMotion::tangent) {
      continue;
    }
    std::vector<Vec3> places(facet.points.size(), Vec3::Zero());
    for (std::size_t q = 0; q < facet.points.size(); ++q) {
      places[q].template head<Dim>() = facet.points[q].position;
    }
    const std::vector<Vec<Dim>> force = values_at<Dim>(settings_.body_force, places, to);
    for (std::size_t q = 0; q < facet.points.size(); ++q) {
      const SurfacePoint<Dim>& point = facet.points[q];
      const double pressure = force[q].dot(reference_.state->mean.arm(cell, point.position));
      loads.walls[f].push(grid_, point, Vec<Dim>(point.weight * pressure * point.normal));
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

#define LAPILLI_INSTANTIATE(Dim)                                              \
  template Loads<Dim> QuasiStatic<Dim>::collect_loads(double) const;          \
  template void QuasiStatic<Dim>::add_hydrostatic(double, Loads<Dim>&) const; \
  template void QuasiStatic<Dim>::require_loads_arrive(const Equilibrium<Dim>&) const;
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
