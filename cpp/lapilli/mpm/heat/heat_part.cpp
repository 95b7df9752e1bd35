#include "lapilli/mpm/heat/heat_part.hpp"

#include <algorithm>
#include <span>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/cut_bodies.hpp"
#include "lapilli/mpm/heat/drawn_gaps.hpp"
#include "lapilli/mpm/heat/part_assembly.hpp"
#include "lapilli/mpm/surface/shape_areas.hpp"

namespace lapilli {
namespace {

/// The contacts with a resistance, each between bodies of two groups.
template <int Dim>
std::vector<ResistingContact> contacts_of(const HeatProblem<Dim>& problem,
                                          const PairEntries& resisting,
                                          const std::vector<CutBody<Dim>>& cut,
                                          std::span<const SurfaceFound> surfaces,
                                          const std::vector<std::vector<std::size_t>>& groups) {
  std::vector<ResistingContact> found;
  for (std::size_t a = 0; a < cut.size(); ++a) {
    for (std::size_t b = a + 1; b < cut.size(); ++b) {
      if (cut[a].resisting.contains(b)) {
        found.push_back({a, b, static_cast<std::size_t>(resisting.of(a, b))});
        require(std::none_of(groups.begin(), groups.end(),
                             [&](const auto& group) {
                               return std::count(group.begin(), group.end(), a) > 0 &&
                                      std::count(group.begin(), group.end(), b) > 0;
                             }),
                "heat.contacts.", found.back().entry, ": bodies ", a, " and ", b,
                " are also joined through others without resistance; give these pairs an entry");
      }
    }
  }
  for (std::size_t entry = 0; entry < problem.settings.contacts.size(); ++entry) {
    const auto& bodies = problem.settings.contacts[entry].bodies;
    if (std::ranges::none_of(found, [&](const auto& one) { return one.entry == entry; })) {
      require(!bodies.empty(), "heat.contacts.", entry, ": no bodies touch");
      require(false, "heat.contacts.", entry, ": ", bodies[0], " and ", bodies[1], " do not touch",
              gap_between(bodies, surfaces, problem.bodies, problem.grid.cell_size()));
    }
  }
  return found;
}

}  // namespace

template <int Dim>
std::vector<HeatPart<Dim>> make_parts(const Points& points, const HeatProblem<Dim>& problem,
                                      std::vector<SurfaceFound>& found,
                                      std::vector<ResistingContact>* contacts) {
  std::vector<Shape> shapes;
  for (const HeatBody& body : problem.bodies) {
    check(body.material);
    shapes.push_back(*body.shape);
    check(shapes.back(), Dim);
  }
  const auto& laws = problem.settings.boundaries;
  check_regions(laws, Dim);
  found.assign(shapes.size(), {});
  const PairEntries resisting = resisting_pairs(problem.bodies, problem.settings.contacts);
  std::vector<CutBody<Dim>> cut;
  std::vector<std::vector<std::size_t>> touching;
  for (std::size_t body = 0; body < shapes.size(); ++body) {
    cut.push_back(cut_body<Dim>(problem, shapes, body, resisting, found[body]));
    touching.push_back(cut.back().touching);
  }
  for (std::size_t law = 0; law < laws.size(); ++law) {
    require_surface(laws, law, std::ranges::any_of(cut, [&](const CutBody<Dim>& body) {
                      return !body.pieces[law].empty();
                    }));
  }
  const std::vector<std::vector<std::size_t>> groups = groups_of(touching);
  std::vector<ResistingContact> touch = contacts_of<Dim>(problem, resisting, cut, found, groups);
  std::vector<HeatPart<Dim>> parts;
  with_shape(problem.shape, resting_half_width, [&](auto function) {
    for (const auto& bodies : groups) {
      parts.push_back(
          PartAssembly<Dim, decltype(function)>(points, problem, cut, touch, bodies, function)
              .make(found));
    }
  });
  if (contacts != nullptr) {
    *contacts = std::move(touch);
  }
  return parts;
}

#define LAPILLI_INSTANTIATE(Dim)                                                         \
  template std::vector<HeatPart<Dim>> make_parts(const Points&, const HeatProblem<Dim>&, \
                                                 std::vector<SurfaceFound>&,             \
                                                 std::vector<ResistingContact>*);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
