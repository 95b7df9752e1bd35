#include "lapilli/mpm/heat/strong_ends.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/mpm/heat/meeting_conditions.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"
#include "lapilli/mpm/surface/surface_regions.hpp"

namespace lapilli {
namespace {

constexpr double held_reach = 0.19;    // cells
constexpr double thin_reach = 0.31;    // behind the thinner layer of materials that vary
constexpr double half_reach_at = 1.3;  // conductivities / cell, beside nobody
constexpr double half_between = 9.5;   // the same beside another that is strong
constexpr double weakest = 13.0;       // times that, and weaker: as drawn
constexpr double most_lost = 0.5;      // of the surface of a condition
constexpr double is_beyond = 0.05;     // cells; regions that end nearer below a face are to have it

}  // namespace

template <int Dim>
StrongEnds<Dim>::StrongEnds(const HeatProblem<Dim>& problem, std::size_t body,
                            SurfaceDivision<Dim>& division)
    : problem_(problem),
      body_(problem.bodies[body]),
      division_(division),
      parts_(problem.settings.boundaries.size()) {
  const auto& laws = problem.settings.boundaries;
  for (const HeatBoundary& law : laws) {
    coefficient_.push_back(largest_coefficient(law, 0.0, absolute_zero(problem.settings)));
  }
  const bool divided =
      std::ranges::any_of(laws, [](const HeatBoundary& law) { return region_of(law) != nullptr; });
  cell_ = divided && Dim > 1 ? problem.grid.cell_size() : 0.0;
}

/// How much longer a condition acts at an end, beside another (none: below 0), m. Found on faces
/// and disks for coefficients from 1 to 120 conductivities / cell, and held.
template <int Dim>
double StrongEnds<Dim>::reach(int law, int beside, const Vec<Dim>& normal) const {
  const auto coefficient = [&](int one) {
    return one < 0 ? 0.0 : coefficient_[static_cast<std::size_t>(one)];
  };
  if (!(coefficient(law) > 0.0)) {
    return 0.0;
  }
  const Mat<Dim> k = body_.material.conductivity.largest().template block<Dim>();
  const double unit = normal.dot(k * normal) / problem_.grid.cell_size();
  const double strength =
      coefficient(beside) > 0.0 ? 1.0 / (1.0 + unit / coefficient(beside)) : 0.0;
  const double half = half_reach_at + (half_between - half_reach_at) * strength;
  const double weak = half * unit / coefficient(law);
  const double held = weak == 0.0 && is_nonlinear(problem_) ? thin_reach : held_reach;
  return weak < weakest ? held * cell_ / (1.0 + weak) : 0.0;
}

/// Who is beside a piece of a condition, and how wide a strip that one has of it, m.
template <int Dim>
typename StrongEnds<Dim>::Strip StrongEnds<Dim>::strip_of(int law, const SurfacePiece<Dim>& piece) {
  const Vec<Dim> middle = piece.middle();
  const double own = reach(law, SurfaceDivision<Dim>::nobody, piece.normal);
  double size = 0.0;
  for (const Vec<Dim>& corner : piece.corners) {
    size = std::max(size, (corner - middle).norm());
  }
  if (!(own > 0.0) || !division_.may_end_near(law, middle, own + size)) {
    return {};
  }
  for (const Vec<Dim>& corner : piece.corners) {
    const Vec<Dim> at = corner + 1e-3 * (middle - corner);
    if (const std::optional<int> other = division_.beside(law, at, piece.normal, own)) {
      if (*other >= 0 && std::isinf(coefficient_[static_cast<std::size_t>(law)]) &&
          std::isinf(coefficient_[static_cast<std::size_t>(*other)])) {
        parts_[static_cast<std::size_t>(law)].held_beside = *other;
      }
      const bool takes = *other >= 0 && coefficient_[static_cast<std::size_t>(*other)] > 0.0;
      return {takes ? *other : SurfaceDivision<Dim>::nobody, *other,
              reach(law, *other, piece.normal) - reach(*other, law, piece.normal)};
    }
  }
  return {};
}

template <int Dim>
void StrongEnds<Dim>::add(int law, const SurfacePiece<Dim>& piece) {
  Parts& parts = parts_[static_cast<std::size_t>(law)];
  if (const Shape* region =
          region_of(problem_.settings.boundaries[static_cast<std::size_t>(law)])) {
    Vec3 middle = Vec3::Zero();
    middle.template head<Dim>() = piece.middle();
    const bool outside = distance(*region, middle) > is_beyond * problem_.grid.cell_size();
    parts.beyond += outside ? piece.area() : 0.0;
  }
  const Strip found = cell_ > 0.0 ? strip_of(law, piece) : Strip();
  if (!(found.width > 0.0)) {
    parts.kept.push_back(piece);
    return;
  }
  const auto side = [&](double sign) {
    return SurfacePiece<Dim>{
        trim_straight<Dim>(
            piece.corners,
            [&](const Vec<Dim>& at) {
              return division_.beside(law, at, piece.normal, found.width) ? -sign : sign;
            },
            0.0),
        piece.normal};
  };
  const auto is_there = [](const SurfacePiece<Dim>& one) {
    return one.corners.size() >= static_cast<std::size_t>(Dim);
  };
  if (const SurfacePiece<Dim> kept = side(1.0); is_there(kept)) {
    parts.kept.push_back(kept);
  }
  if (const SurfacePiece<Dim> strip = side(-1.0); is_there(strip)) {
    parts.lost.emplace_back(found.heir, strip);
    if (found.beside >= 0) {
      parts.lost_beside.resize(parts_.size(), 0.0);
      parts.lost_beside[static_cast<std::size_t>(found.beside)] +=
          found.width / (held_reach * cell_) * strip.area();
    }
  }
}

template <int Dim>
std::vector<std::vector<SurfacePiece<Dim>>> StrongEnds<Dim>::pieces(SurfaceFound& found) const {
  std::vector<std::vector<SurfacePiece<Dim>>> all;
  for (const Parts& parts : parts_) {
    all.push_back(parts.kept);
  }
  found.ends.resize(parts_.size());
  for (std::size_t law = 0; law < parts_.size(); ++law) {
    SurfaceFound::Ends& ends = found.ends[law];
    ends.held_beside = parts_[law].held_beside;
    ends.lost_beside = parts_[law].lost_beside;
    ends.beyond = parts_[law].beyond;
    for (const SurfacePiece<Dim>& piece : parts_[law].kept) {
      ends.area += piece.area();
    }
    for (const auto& [heir, piece] : parts_[law].lost) {
      ends.area += piece.area();
      ends.lost += piece.area();
    }
    for (const auto& [heir, piece] : parts_[law].lost) {
      const int owner = ends.lost < most_lost * ends.area ? heir : static_cast<int>(law);
      if (owner >= 0) {
        all[static_cast<std::size_t>(owner)].push_back(piece);
      }
    }
  }
  found.meetings = find_meetings<Dim>(all, coefficient_, problem_.grid.cell_size());
  return all;
}

std::vector<Note> narrow_holds(std::span<const SurfaceFound> found, const HeatSettings& settings) {
  std::vector<Note> all;
  for (std::size_t law = 0; law < settings.boundaries.size(); ++law) {
    const double area = on_all_bodies(found, law, &SurfaceFound::Ends::area);
    const double lost = on_all_bodies(found, law, &SurfaceFound::Ends::lost);
    // Found on patches of .3 to 5 cells: 3 % at 4 cells, 10 % at one.
    const double off = area > 0.0 ? (lost < most_lost * area ? 0.3 : 0.5) * lost / area : 0.0;
    if (off > 0.03) {
      all.push_back(note("heat.narrow-hold", "heat.boundaries.", law, " (",
                         name_of_law(settings.boundaries[law], law),
                         ") all but holds a strip of the surface a few cells wide, at whose "
                         "ends heat crowds: its heat may be off by ",
                         std::lround(100.0 * off), " %; halve grid.cell to halve that"));
    }
  }
  return all;
}

std::vector<Note> regions_below(std::span<const SurfaceFound> found, const HeatSettings& settings,
                                double cell_size) {
  constexpr double told = 0.02;
  std::vector<Note> all;
  for (std::size_t law = 0; law < settings.boundaries.size(); ++law) {
    const double area = on_all_bodies(found, law, &SurfaceFound::Ends::area);
    const double outside = on_all_bodies(found, law, &SurfaceFound::Ends::beyond);
    if (outside > told * area) {
      all.push_back(note("heat.region-below", "heat.boundaries.", law, " (",
                         name_of_law(settings.boundaries[law], law),
                         "): ", std::lround(100.0 * outside / area),
                         " % of its surface lies outside of its region, which ends less than ",
                         region_slack * cell_size,
                         " m below and so has it; let the region end beyond that surface if it is "
                         "meant, further below if not"));
    }
  }
  return all;
}

std::vector<Note> steps_between(std::span<const SurfaceFound> found, const HeatSettings& settings) {
  std::vector<Note> all;
  for (const SurfaceFound& body : found) {
    for (std::size_t law = 0; law < body.ends.size() && all.empty(); ++law) {
      const int other = body.ends[law].held_beside;
      if (other < 0) {
        continue;
      }
      const auto beside = static_cast<std::size_t>(other);
      const Value &one = *surroundings_of(settings.boundaries[law]),
                  &two = *surroundings_of(settings.boundaries[beside]);
      if (one.is_constant() && two.is_constant() && one.at(0.0) == two.at(0.0)) {
        continue;
      }
      // Found on an ellipse of 10 cells, conductivity .4 to 1: 25 %, at twice the cells too.
      all.push_back(note("heat.held-side-by-side", "heat.boundaries.", std::min(law, beside),
                         " and .", std::max(law, beside),
                         " hold temperatures side by side, on materials that vary: where they "
                         "meet, cells may stray beyond both by a quarter of their difference; "
                         "let one end a cell before the other"));
    }
  }
  return all;
}

template class StrongEnds<1>;
template class StrongEnds<2>;
template class StrongEnds<3>;

}  // namespace lapilli
