// Points inside of obstacles, at the start and later.
#include <cmath>
#include <limits>

#include "lapilli/core/in_space.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/dynamics/obstacles/obstacles.hpp"

namespace lapilli {
namespace {

constexpr double told_depth = 0.5;  // cells; what is pushed hard comes a quarter deep

}  // namespace

template <int Dim>
typename ObstacleContacts<Dim>::Inside ObstacleContacts<Dim>::inside(const DynamicsData<Dim>& data,
                                                                     double depth,
                                                                     double travelled) const {
  Inside found{0, -1, depth};
  for (Index row = 0; row < data.points.size(); ++row) {
    if (memory_[row * kept] - travelled > -depth) {
      continue;
    }
    const double here = -clearance(in_space<Dim>(data.points.template position<Dim>(row)));
    if (here > depth) {
      ++found.count;
    }
    if (here > found.depth) {
      found.depth = here;
      found.row = row;
    }
  }
  return found;
}

template <int Dim>
void ObstacleContacts<Dim>::require_nothing_inside(const DynamicsData<Dim>& data) const {
  const Inside found =
      inside(data, 1e-6 * data.grid.cell_size(), std::numeric_limits<double>::infinity());
  require(found.row < 0, "dynamics.obstacles: ", name_, " starts inside body ",
          found.row < 0 ? 0 : data.points.body()[found.row], ": its point ",
          found.row < 0 ? 0 : data.points.id()[found.row], " lies ", found.depth, " m deep in it");
}

template <int Dim>
std::vector<Note> Obstacles<Dim>::warnings(const DynamicsData<Dim>& data) const {
  const double h = data.grid.cell_size();
  std::vector<Note> all;
  for (const auto& one : each_) {
    const auto found = one->inside(data, told_depth * h, travelled_);
    if (found.row < 0) {
      continue;
    }
    const Vec3 at = in_space<Dim>(data.points.template position<Dim>(found.row));
    all.push_back(note("dynamics.inside-obstacle", one->name(), ": ", found.count,
                       " points lie more than ", told_depth, " cells inside it, the deepest ",
                       std::round(100.0 * found.depth / h) / 100.0, " cells, at (", at[0], ", ",
                       at[1], Dim == 3 ? message(", ", at[2]) : std::string(),
                       "): what holds them there, or a wedge between it and a face that it runs "
                       "along, leaves them behind; a roller face or one of less friction does so "
                       "less"));
  }
  return all;
}

#define LAPILLI_INSTANTIATE(Dim)                                                               \
  template typename ObstacleContacts<Dim>::Inside ObstacleContacts<Dim>::inside(               \
      const DynamicsData<Dim>&, double, double) const;                                         \
  template void ObstacleContacts<Dim>::require_nothing_inside(const DynamicsData<Dim>&) const; \
  template std::vector<Note> Obstacles<Dim>::warnings(const DynamicsData<Dim>&) const;
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
