#include "lapilli/scene/few_cells.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/pair_entries.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/core/symmetric_modes.hpp"

namespace lapilli {
namespace {

// Of 49 drawn scenes with bodies of 6 to 10 cells, 17 to 21 changed by 2 to 11 % when they were
// turned, moved by a part of a cell, or ran past the grid.
constexpr double enough = 8.0;  // cells

/// Moments of the points of a body.
template <int Dim>
struct Moments {
  double volume = 0.0;
  Index points = 0;
  Vec<Dim> first = Vec<Dim>::Zero();
  Mat<Dim> second = Mat<Dim>::Zero();

  /// Of a plate with these moments, m; points stand for boxes about them.
  double thickness() const {
    const Vec<Dim> middle = first / volume;
    const Mat<Dim> spread = second / volume - middle * middle.transpose();
    const double least = symmetric_modes<Dim>(spread).eigenvalues[0];
    const double spacing = std::pow(volume / static_cast<double>(points), 1.0 / Dim);
    return std::sqrt(12.0 * std::max(0.0, least) + spacing * spacing);
  }
};

template <int Dim>
std::vector<Note> few_cells_of(const Scene& scene, const Points& points) {
  std::vector<Moments<Dim>> all(scene.bodies.size());
  const Vec<Dim> origin = Eigen::Map<const Vec<Dim>>(scene.grid.lower.data());
  for (Index row = 0; row < points.size(); ++row) {
    const auto number = static_cast<std::size_t>(points.body()[row]);
    if (number >= all.size()) {
      continue;  // of a stage to come
    }
    Moments<Dim>& body = all[number];
    const Vec<Dim> at = points.position<Dim>(row) - origin;
    const double volume = points.volume()[row];
    body.volume += volume;
    body.first += volume * at;
    body.second += volume * at * at.transpose();
    ++body.points;
  }
  std::vector<Note> notes;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double thickness = all[k].points > 0 ? all[k].thickness() : 0.0;
    if (all[k].points == 0 || thickness > (enough - 0.1) * scene.grid.cell) {
      continue;
    }
    notes.push_back(note("dynamics.few-cells", name_or_number(scene.bodies[k].name, k), " is ",
                         0.1 * std::round(10.0 * thickness / scene.grid.cell),
                         " cells across: its place and angle on the grid may change its motion "
                         "by some percent; compare with grid.cell = ",
                         thickness / enough, " or less"));
  }
  return notes;
}

}  // namespace

std::vector<Note> few_cells(const Scene& scene, const Points& points) {
  if (!scene.dynamics) {
    return {};
  }
  return points.dimension() == 2 ? few_cells_of<2>(scene, points) : few_cells_of<3>(scene, points);
}

}  // namespace lapilli
