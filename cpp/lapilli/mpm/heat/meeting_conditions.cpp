#include "lapilli/mpm/heat/meeting_conditions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr double least_share = 0.03;  // of the heat of a condition that is said
constexpr double same_place = 1e-3;   // cells

/// Places that are alike but for rounding.
template <int Dim>
class Places {
 public:
  explicit Places(double cell_size) : unit_(same_place * cell_size) {}

  void add(const Vec<Dim>& place) { known_.insert(key(place, 0)); }
  bool has(const Vec<Dim>& place) const {
    bool found = false;
    for (int corner = 0; corner < power && !found; ++corner) {
      found = known_.contains(key(place, corner));
    }
    return found;
  }

 private:
  static constexpr int power = Dim == 1 ? 3 : Dim == 2 ? 9 : 27;
  using Key = std::array<long long, Dim>;

  /// Of the place, and of those around.
  Key key(const Vec<Dim>& place, int which) const {
    Key all;
    for (int axis = 0; axis < Dim; ++axis, which /= 3) {
      all[static_cast<std::size_t>(axis)] =
          std::llround(place[axis] / unit_) + (which % 3 == 2 ? -1 : which % 3);
    }
    return all;
  }

  double unit_;
  std::set<Key> known_;
};

/// Of the edges of a piece that lie on known places and on none that was met, m; in the plane, how
/// many of its ends do.
template <int Dim>
double length_on(const SurfacePiece<Dim>& piece, const Places<Dim>& places, Places<Dim>& met) {
  double sum = 0.0;
  const std::size_t count = piece.corners.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec<Dim>& here = piece.corners[k];
    const Vec<Dim>& next = Dim < 3 ? here : piece.corners[(k + 1) % count];
    const Vec<Dim> middle = 0.5 * (here + next);
    if (places.has(here) && places.has(next) && !met.has(middle)) {
      met.add(middle);
      sum += Dim < 3 ? 1.0 : (next - here).norm();
    }
  }
  return sum;
}

/// How much too much passes, in conductivity x difference / pi: found for 1 to 120 on faces, where
/// two of one coefficient meet (.17 at 1.25, 1.7 at 12, 5.7 at 125) and where they differ tenfold.
double excess(double biot) { return 0.16 * biot / (1.0 + biot / 45.0); }

double shared_biot(double one, double other) {
  return std::isinf(one) || std::isinf(other) ? 2.0 * std::min(one, other)
                                              : 2.0 * one * other / (one + other);
}

}  // namespace

template <int Dim>
std::vector<SurfaceFound::Meeting> find_meetings(
    const std::vector<std::vector<SurfacePiece<Dim>>>& pieces, std::span<const double> coefficient,
    double cell_size) {
  std::vector<SurfaceFound::Meeting> all;
  const auto exchanging = std::ranges::count_if(coefficient, [](double one) { return one > 0.0; });
  for (std::size_t a = 0; a < pieces.size() && exchanging > 1 && Dim > 1; ++a) {
    if (!(coefficient[a] > 0.0)) {
      continue;
    }
    Places<Dim> places(cell_size);
    for (const SurfacePiece<Dim>& piece : pieces[a]) {
      for (const Vec<Dim>& corner : piece.corners) {
        places.add(corner);
      }
    }
    for (std::size_t b = a + 1; b < pieces.size(); ++b) {
      double length = 0.0;
      Places<Dim> met(cell_size);
      for (const SurfacePiece<Dim>& piece : pieces[b]) {
        length += coefficient[b] > 0.0 ? length_on(piece, places, met) : 0.0;
      }
      if (length > 0.0) {
        all.push_back(
            {static_cast<int>(a), static_cast<int>(b), length, coefficient[a], coefficient[b]});
      }
    }
  }
  return all;
}

std::vector<Note> crossing_heat(std::span<const SurfaceFound> found,
                                const std::vector<HeatBody>& bodies, const HeatSettings& settings,
                                const ConditionAccount& heat, double cell_size, double time) {
  std::vector<Note> all;
  for (std::size_t body = 0; body < found.size(); ++body) {
    for (const SurfaceFound::Meeting& one : found[body].meetings) {
      const auto a = static_cast<std::size_t>(one.first), b = static_cast<std::size_t>(one.second);
      const Value *first = surroundings_of(settings.boundaries[a]),
                  *second = surroundings_of(settings.boundaries[b]);
      if (first == nullptr || second == nullptr || first->is_function() || second->is_function()) {
        continue;
      }
      const double apart = std::abs(first->mean(0.0, time) - second->mean(0.0, time));
      const double conductivity = largest_conductivity(bodies[body].material);
      const double per_biot = cell_size / conductivity;
      const double biot =
          shared_biot(one.first_coefficient * per_biot, one.second_coefficient * per_biot);
      const bool held = std::isinf(biot);
      const double crossed = conductivity * apart * time * one.length / std::numbers::pi;
      const double least = std::min(std::abs(heat.heat(a)), std::abs(heat.heat(b)));
      const double off = crossed * (held ? 1.0 : excess(biot)) / least;
      if (!(off > least_share)) {
        continue;
      }
      const std::string consequence =
          held ? message(
                     "the heat that passes from one to the other at their edge has no limit, so "
                     "that of each alone depends on grid.cell, by ",
                     std::lround(100.0 * off), " % or more; their sum does not")
               : message(
                     "what passes straight from one to the other at their edge, within less "
                     "than a cell, may make the heat of each alone ",
                     std::lround(100.0 * std::min(1.0, off)),
                     " % too much, not their sum; halve grid.cell to halve that");
      all.push_back(note("heat.crossing", "heat.boundaries.", a, " (",
                         name_of_law(settings.boundaries[a], a), ") and .", b, " (",
                         name_of_law(settings.boundaries[b], b),
                         ") meet at different temperatures: ", consequence));
    }
  }
  return all;
}

std::vector<Note> fluxes_beside(std::span<const SurfaceFound> found, const HeatSettings& settings,
                                const ConditionAccount& heat) {
  // Of the strip that is lost, .19 cells where the surface is held. Disks and boxes of 8 to 32
  // cells, times of .02 to .4, anywhere on the grid: .08 cells of the flux off, .21 at worst.
  constexpr double known_to = 0.7;
  const std::size_t laws = settings.boundaries.size();
  std::vector<Note> all;
  for (std::size_t law = 0; law < laws; ++law) {
    double worst = 0.0;
    std::size_t beside = laws;
    for (std::size_t flux = 0; flux < laws; ++flux) {
      double lost = 0.0;
      for (const SurfaceFound& body : found) {
        const bool ends = law < body.ends.size() && !body.ends[law].lost_beside.empty();
        lost += ends ? body.ends[law].lost_beside[flux] : 0.0;
      }
      if (!(lost > 0.0) || surroundings_of(settings.boundaries[flux]) != nullptr) {
        continue;
      }
      // What all leaves by the other in the end does so whatever the way.
      const double kept =
          std::min(std::abs(heat.heat(flux)), std::abs(heat.heat(flux) + heat.heat(law)));
      if (const double off =
              known_to * lost / on_all_bodies(found, flux, &SurfaceFound::Ends::area) * kept;
          off > worst) {
        worst = off;
        beside = flux;
      }
    }
    const double off = worst / std::abs(heat.heat(law));
    if (off > least_share) {
      all.push_back(
          note("heat.flux-beside", "heat.boundaries.", beside, " (",
               name_of_law(settings.boundaries[beside], beside), ") is a flux that ends beside .",
               law, " (", name_of_law(settings.boundaries[law], law),
               "), and part of it passes straight there: the heat of the latter may be ", "off by ",
               std::lround(100.0 * std::min(1.0, off)), " %; halve grid.cell to halve that"));
    }
  }
  return all;
}

template std::vector<SurfaceFound::Meeting> find_meetings<1>(
    const std::vector<std::vector<SurfacePiece<1>>>&, std::span<const double>, double);
template std::vector<SurfaceFound::Meeting> find_meetings<2>(
    const std::vector<std::vector<SurfacePiece<2>>>&, std::span<const double>, double);
template std::vector<SurfaceFound::Meeting> find_meetings<3>(
    const std::vector<std::vector<SurfacePiece<3>>>&, std::span<const double>, double);

}  // namespace lapilli
