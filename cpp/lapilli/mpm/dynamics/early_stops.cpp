#include "lapilli/mpm/dynamics/early_stops.hpp"

#include <cmath>
#include <limits>

#include "lapilli/core/in_brackets.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/geometry/bounds.hpp"

namespace lapilli {
namespace {

constexpr double touching = 0.1, reach = 1.25;  // cells; beyond, no node of a face feels a point

/// The box of the points of a body with half of their width, cells from the lower corner of the
/// grid.
template <int Dim>
struct Extent {
  Vec<Dim> lower = Vec<Dim>::Constant(std::numeric_limits<double>::infinity());
  Vec<Dim> upper = -lower;
};

template <int Dim>
std::vector<Extent<Dim>> extents(const DynamicsData<Dim>& data) {
  std::vector<Extent<Dim>> all(data.half_widths.size());
  for (Index row = 0; row < data.points.size(); ++row) {
    const Index body = data.points.body()[row];
    const Vec<Dim> at =
        (data.points.template position<Dim>(row) - data.grid.lower()) / data.grid.cell_size();
    all[body].lower = all[body].lower.cwiseMin(at);
    all[body].upper = all[body].upper.cwiseMax(at);
  }
  for (std::size_t body = 0; body < all.size(); ++body) {
    all[body].lower.array() -= data.half_widths[body];
    all[body].upper.array() += data.half_widths[body];
  }
  return all;
}

/// Whether what is free falls towards a face: no axis pulls more.
bool pulls_towards(const Vec3& gravity, int axis, bool upper) {
  const double pull = upper ? gravity[axis] : -gravity[axis];
  return pull > 0.0 && pull == gravity.cwiseAbs().maxCoeff();
}

/// Whether a prescribed motion takes an obstacle along a face across an axis.
bool moves_along(const Obstacle& obstacle, int axis) {
  Vec3 along = place(obstacle.velocity);
  along[axis] = 0.0;
  return !obstacle.mass && !along.isZero(0.0);
}

/// Obstacles that move along a face of the grid and end just before it.
template <int Dim>
void note_ends(const DynamicsData<Dim>& data, int face, std::vector<Note>& all) {
  const double h = data.grid.cell_size();
  const int axis = face / 2;
  for (std::size_t k = 0; k < data.settings.obstacles.size(); ++k) {
    const Obstacle& one = data.settings.obstacles[k];
    if (!moves_along(one, axis)) {
      continue;
    }
    const Bounds box = bounds(one.shape);
    const double gap = face % 2 == 1 ? data.grid.upper()[axis] - box.upper[axis]
                                     : box.lower[axis] - data.grid.lower()[axis];
    if (gap > touching * h && gap < h) {
      all.push_back(note("dynamics.obstacle-end", "dynamics.obstacles.", k, in_brackets(one.name),
                         " moves along the grid boundary ", name_of(static_cast<GridFace>(face)),
                         " and ends ", std::round(100.0 * gap / h) / 100.0,
                         " cells from it: what passes between them is left behind anywhere, and in "
                         "it; draw it onto the face or through it, or leave two cells"));
    }
  }
}

}  // namespace

template <int Dim>
std::vector<Note> early_stops(const DynamicsData<Dim>& data,
                              const std::vector<DynamicsBody>& bodies) {
  std::vector<Note> all;
  const std::vector<Extent<Dim>> boxes = extents(data);
  const Vec<Dim> size = (data.grid.upper() - data.grid.lower()) / data.grid.cell_size();
  for (int face = 0; face < 2 * Dim; ++face) {
    if (data.walls[face].is_open()) {
      continue;
    }
    const int axis = face / 2;
    const bool upper = face % 2 == 1;
    const char* name = name_of(static_cast<GridFace>(face));
    note_ends(data, face, all);
    for (std::size_t body = 0; body < boxes.size(); ++body) {
      const double gap = upper ? size[axis] - boxes[body].upper[axis] : boxes[body].lower[axis];
      if (!(gap > touching) || !std::isfinite(gap)) {
        continue;
      }
      if (gap < reach) {
        all.push_back(
            note("dynamics.near-grid-face", bodies[body].label, " starts about ",
                 std::round(10.0 * gap) / 10.0, " cells from the grid boundary ", name,
                 ", whose nodes hold it already: let it touch, or take an obstacle (half_space)"));
      } else if (boxes.size() == 1 && pulls_towards(place(data.settings.gravity), axis, upper)) {
        all.push_back(note(
            "dynamics.falls-on-grid-face", bodies[body].label, " falls onto the grid boundary ",
            name, ", whose nodes stop it up to a cell early; an obstacle (half_space) does not"));
      }
    }
  }
  return all;
}

template std::vector<Note> early_stops(const DynamicsData<2>&, const std::vector<DynamicsBody>&);
template std::vector<Note> early_stops(const DynamicsData<3>&, const std::vector<DynamicsBody>&);

}  // namespace lapilli
