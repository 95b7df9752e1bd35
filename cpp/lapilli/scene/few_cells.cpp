#include "lapilli/scene/few_cells.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/pair_entries.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/core/symmetric_modes.hpp"

namespace lapilli {
namespace {

// 147 drawn impacts of elastic disks, boxes and hexagons, each turned by 31 degrees, moved by a
// part of a cell, and past the grid: one in ten changes its velocity and spin by more than 5 % of
// the speed of impact at 8 to 14 cells, by 2 to 3 % at 14 to 24, whatever the transfer.
constexpr double enough = 8.0, enough_to_bounce = 27.5;  // cells
constexpr double one_in_ten = 0.55;                      // changes by this over the cells across

/// Whether it is elastic and there is something that it may hit and that does not yield.
bool may_bounce(const Scene& scene, const Body& body) {
  const auto is = [](const auto& all, const auto& kind) {
    return std::ranges::any_of(all, [&](const auto& one) {
      return std::holds_alternative<std::remove_cvref_t<decltype(kind)>>(one);
    });
  };
  const DynamicsSettings& dynamics = *scene.dynamics;
  const auto elastic = std::ranges::count_if(
      scene.bodies, [&](const Body& one) { return is(one.material, LinearElastic{}); });
  return is(body.material, LinearElastic{}) && (!dynamics.obstacles.empty() || elastic > 1 ||
                                                is(dynamics.grid_boundaries, FrictionalBoundary{}));
}

/// Diameter of a disk or ball, m; 0 of what is none.
double diameter(const Body& body) {
  const Shape* shape = body.shape ? &*body.shape : nullptr;
  while (shape != nullptr) {
    if (const auto* turned = std::get_if<Rotated>(shape)) {
      shape = &*turned->shape;
    } else if (const auto* moved = std::get_if<Translated>(shape)) {
      shape = &*moved->shape;
    } else {
      break;
    }
  }
  const auto* disk = shape ? std::get_if<Disk>(shape) : nullptr;
  const auto* ball = shape ? std::get_if<Sphere>(shape) : nullptr;
  return disk ? 2.0 * disk->radius : ball ? 2.0 * ball->radius : 0.0;
}

/// What few cells cost a disk or ball that rolls on an obstacle. Nodes carry the mass of points
/// farther out than it is, by 3/8 of a squared cell; and it meets obstacles as the polygon of its
/// points, which bears ahead of its middle by .03 to .04 cells, whatever its size.
std::string of_rolling(const Scene& scene, const Body& body) {
  constexpr double arm = 0.035;  // cells
  const double cells = diameter(body) / scene.grid.cell;
  if (!(cells > 0.0) || scene.dynamics->obstacles.empty()) {
    return {};
  }
  const auto tenths = [](double value) { return 0.1 * std::round(10.0 * value); };
  return message("; where it rolls it turns ", tenths(100.0 / (cells * cells)),
                 " % slower than a round body, and ", tenths(200.0 * arm / cells),
                 " % of its weight hold it back");
}

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
    const bool bounces = may_bounce(scene, scene.bodies[k]);
    const double least = bounces ? enough_to_bounce : enough;
    const double cells = thickness / scene.grid.cell;
    if (all[k].points == 0 || cells > least - 0.1) {
      continue;
    }
    const std::string change =
        bounces ? message("velocity and spin after an impact, in one of ten by more than ",
                          std::round(100.0 * one_in_ten / cells), " % of the speed",
                          of_rolling(scene, scene.bodies[k]))
                : "motion by some percent";
    notes.push_back(note("dynamics.few-cells", name_or_number(scene.bodies[k].name, k), " is ",
                         0.1 * std::round(10.0 * cells),
                         " cells across: its place and angle on the grid may change its ", change,
                         "; compare with grid.cell = ", thickness / least, " or less"));
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
