#include "lapilli/mpm/quasi_static/support_ends.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "lapilli/core/in_space.hpp"
#include "lapilli/mpm/quasi_static/on_bodies.hpp"
#include "lapilli/mpm/quasi_static/support_terms.hpp"

namespace lapilli {
namespace {

constexpr double off_the_face = 0.25;  // cells, that a curved face leaves its tangent within one
constexpr double below = 2.0;          // cells, where the material goes on that is not at a corner

/// Unit vectors along a face.
template <int Dim>
std::vector<Vec<Dim>> directions_along(const Vec<Dim>& normal) {
  if constexpr (Dim == 2) {
    const Vec<2> along = tangents<2>(normal)[0];
    return {along, Vec<2>(-along)};
  } else {
    const auto [first, second] = tangents<3>(normal);
    std::vector<Vec<3>> all;
    for (int k = 0; k < 8; ++k) {
      const double angle = 0.25 * k * std::numbers::pi;
      all.push_back(std::cos(angle) * first + std::sin(angle) * second);
    }
    return all;
  }
}

template <int Dim>
struct Ends {
  const Grid<Dim>& grid;
  const Boundary<Dim>& boundary;
  double time;

  bool is_held(const Vec<Dim>& place) const {
    for (std::size_t w = 0; w < boundary.walls(); ++w) {
      const auto gap = boundary.wall(w).gap(in_space<Dim>(place), time);
      if (gap && std::abs(*gap) < off_the_face * grid.cell_size()) {
        return true;
      }
    }
    return false;
  }

  /// Bodies are known as they were at the start: those at a wall move with it.
  bool is_material(const Vec<Dim>& place, int wall) const {
    const Vec<Dim> at_start = place - boundary.wall(wall).offset(time);
    return distance_to(boundary.bodies(), in_space<Dim>(at_start)) < 0.0;
  }

  /// From a facet towards what of its wall is not at an end; zero for one that is there.
  Vec<Dim> inwards(const Facet<Dim>& facet) const {
    const double h = grid.cell_size();
    const Vec<Dim> centre = facet.centre(), normal = facet.normal();
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (const Vec<Dim>& along : directions_along<Dim>(normal)) {
      const Vec<Dim> next = centre + h * along;
      if (!is_held(next) && is_material(Vec<Dim>(next + below * h * normal), facet.surface)) {
        sum -= along;
      }
    }
    return sum.norm() > 0.5 ? Vec<Dim>(sum.normalized()) : Vec<Dim>(Vec<Dim>::Zero());
  }
};

}  // namespace

template <int Dim>
std::vector<SupportEnd> support_ends(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                     std::span<const Facet<Dim>> facets, double time) {
  constexpr double same_face = 0.8, farthest = 2.5;  // cosine; cells
  const Ends<Dim> ends{grid, boundary, time};
  if (boundary.bodies().empty()) {
    return {};
  }
  std::vector<Vec<Dim>> inwards, centre;
  for (const Facet<Dim>& facet : facets) {
    const bool can_end = boundary.kinds()[facet.surface] != HeldMotion::tangent;
    inwards.push_back(can_end ? ends.inwards(facet) : Vec<Dim>(Vec<Dim>::Zero()));
    centre.push_back(facet.centre());
  }
  std::map<std::size_t, SupportEnd> by_partner;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    if (inwards[f].isZero(0.0)) {
      continue;
    }
    // The nearest facet further in that is not at the end itself.
    std::size_t partner = facets.size();
    double least = farthest * grid.cell_size();
    for (std::size_t other = 0; other < facets.size(); ++other) {
      const Vec<Dim> way = centre[other] - centre[f];
      const double beside = (way - way.dot(inwards[f]) * inwards[f]).norm();
      if (facets[other].surface == facets[f].surface && inwards[other].isZero(0.0) &&
          facets[other].normal().dot(facets[f].normal()) > same_face &&
          way.dot(inwards[f]) > beside && way.norm() < least) {
        least = way.norm();
        partner = other;
      }
    }
    if (partner < facets.size()) {
      by_partner[partner].facets.push_back(f);
    }
  }
  std::vector<SupportEnd> all;
  for (auto& [partner, end] : by_partner) {
    end.next = partner;
    all.push_back(std::move(end));
  }
  return all;
}

#define LAPILLI_INSTANTIATE(Dim)                                                        \
  template std::vector<SupportEnd> support_ends(const Grid<Dim>&, const Boundary<Dim>&, \
                                                std::span<const Facet<Dim>>, double);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
