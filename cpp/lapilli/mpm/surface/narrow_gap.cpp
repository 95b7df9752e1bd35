#include "lapilli/mpm/surface/narrow_gap.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "lapilli/core/in_space.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/geometry/checks.hpp"

namespace lapilli {
namespace {

/// All bodies as one.
struct Bodies {
  const std::vector<Shape>& shapes;

  const Shape& nearest(const Vec3& at) const {
    return *std::ranges::min_element(
        shapes, {}, [&](const Shape& shape) { return lapilli::distance(shape, at); });
  }
  double distance(const Vec3& at) const { return lapilli::distance(nearest(at), at); }
  Vec3 normal(const Vec3& at) const { return lapilli::gradient(nearest(at), at); }
};

/// Width of the gap in front of a place of the surface, where another surface faces it within
/// `most`, m.
std::optional<double> width_before(const Bodies& bodies, const Vec3& foot, const Vec3& out,
                                   double least, double most) {
  constexpr double facing = -0.99;  // cosine between the normals
  constexpr int steps = 64;
  const double close = 0.01 * least;
  double along = least;
  for (int k = 0; k < steps && along < most; ++k) {
    const Vec3 at = foot + along * out;
    const double free = bodies.distance(at);
    if (free < close) {
      const bool meets = along > least && bodies.normal(at).dot(out) < facing;
      return meets ? std::optional(along) : std::nullopt;
    }
    along += free;
  }
  return std::nullopt;
}

template <int Dim>
bool share_a_node(const Grid<Dim>& grid, const Vec3& one, const Vec3& other) {
  const auto a = grid.cell_containing(one.head<Dim>());
  const auto b = grid.cell_containing(other.head<Dim>());
  for (int axis = 0; axis < Dim; ++axis) {
    if (std::abs(a[axis] - b[axis]) > 1) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::string NarrowGap::in_words(int axes) const {
  return message("a gap of ", width, " m at ", text_of(middle, axes),
                 " m is bridged, since its sides share nodes: cells of at most ", 0.5 * width,
                 " m keep it open");
}

template <int Dim>
std::optional<NarrowGap> narrowest_gap(const Grid<Dim>& grid, std::span<const char> cells,
                                       const std::vector<Shape>& shapes) {
  constexpr int samples = Dim == 2 ? 4 : 2;  // along an edge of a cell
  constexpr double touching = 0.05;          // cells
  const double h = grid.cell_size(), inside = 1e-6 * h, spacing = h / samples;
  const Bodies bodies{shapes};
  std::optional<NarrowGap> narrowest;
  double most = 2.0 * std::sqrt(double{Dim}) * h;
  for (Index cell = 0; !shapes.empty() && cell < grid.cell_count(); ++cell) {
    const Vec<Dim> corner = grid.node_position(grid.node_index(grid.cell_at(cell)));
    const Vec3 middle = in_space<Dim>(corner + Vec<Dim>::Constant(0.5 * h));
    if (!cells[cell] || std::abs(bodies.distance(middle)) > std::sqrt(double{Dim}) * h) {
      continue;
    }
    for (int k = 0; k < (Dim == 2 ? samples * samples : samples * samples * samples); ++k) {
      Vec<Dim> at = corner;
      for (int axis = 0, rest = k; axis < Dim; ++axis, rest /= samples) {
        at[axis] += (rest % samples + 0.5) * spacing;
      }
      const Vec3 place = in_space<Dim>(at);
      const double away = bodies.distance(place);
      if (std::abs(away) > spacing) {
        continue;
      }
      const Vec3 foot = project(bodies.nearest(place), place);
      const Vec3 out = bodies.normal(place);
      const auto width = width_before(bodies, foot, out, touching * h, most);
      if (width && share_a_node(grid, foot - inside * out, foot + (*width + inside) * out)) {
        most = *width;
        narrowest = NarrowGap{*width, foot + 0.5 * *width * out};
      }
    }
  }
  return narrowest;
}

template std::optional<NarrowGap> narrowest_gap(const Grid<2>&, std::span<const char>,
                                                const std::vector<Shape>&);
template std::optional<NarrowGap> narrowest_gap(const Grid<3>&, std::span<const char>,
                                                const std::vector<Shape>&);

}  // namespace lapilli
