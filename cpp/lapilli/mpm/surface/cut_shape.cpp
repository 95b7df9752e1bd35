#include "lapilli/mpm/surface/cut_shape.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/parallel.hpp"

namespace lapilli {
namespace {

// Of a cell, by dimension: how near planes follow a curved surface, and how often a cube is halved.
constexpr double tolerance[] = {0.0, 1e-9, 1e-3, 2e-2};
constexpr int halvings[] = {0, 12, 4, 2};
// Longest piece of surface in three dimensions, where a piece has one point.
constexpr double longest_piece = 0.55;

constexpr int power(int base, int exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

/// Whether pieces lie on the surface all along: a face that no sample of a cube was nearest to, as
/// the end of a plate, would have cut them.
template <int Dim>
bool on_surface(const Shape& shape, const std::vector<SurfacePiece<Dim>>& pieces, double slack) {
  const auto is_on = [&](const Vec<Dim>& place) {
    Vec3 at = Vec3::Zero();
    at.template head<Dim>() = place;
    return std::abs(distance(shape, at)) <= slack;
  };
  return std::all_of(pieces.begin(), pieces.end(), [&](const SurfacePiece<Dim>& piece) {
    return std::all_of(piece.corners.begin(), piece.corners.end(), is_on) && is_on(piece.middle());
  });
}

/// In space turn the plane of a curved piece to the tangent at its middle, and move it to the mean
/// of the surface: that leaves the tangent as the square of the way along it, on average over the
/// piece a third of what its ends show.
template <int Dim>
void follow_curve(const Shape& shape, double cell_size, const Cube<Dim>& cube, PlaneFit<Dim>& fit,
                  std::vector<SurfacePiece<Dim>>& pieces) {
  const auto in_space = [](const Vec<Dim>& place) {
    Vec3 at = Vec3::Zero();
    at.template head<Dim>() = place;
    return at;
  };
  const auto rise = [&](const SurfacePiece<Dim>& piece) {
    double sum = 0.0;
    for (const Vec<Dim>& corner : piece.corners) {
      sum += distance(shape, in_space(corner)) / static_cast<double>(piece.corners.size());
    }
    return sum;
  };
  if (Dim < 3 || pieces.size() != 1 || fit.planes.size() != 1 ||
      std::abs(rise(pieces.front())) < 1e-9 * cell_size) {
    return;
  }
  const Vec3 foot = project(shape, in_space(pieces.front().middle()));
  const Vec<Dim> normal = gradient(shape, foot).template head<Dim>();
  if (normal.dot(fit.planes.front().normal) < 0.9) {
    return;
  }
  fit.planes.front() = cut_through<Dim>(foot.template head<Dim>(), normal);
  pieces = surface_pieces<Dim>(cube, fit);
  if (!pieces.empty()) {
    fit.planes.front().offset -= rise(pieces.front()) / 3.0;
    pieces = surface_pieces<Dim>(cube, fit);
  }
}

template <int Dim>
void add_cube(const Shape& shape, const Cube<Dim>& cube, double cell_size, int halvings_left,
              CellCut<Dim>& cell) {
  using State = typename PlaneFit<Dim>::State;
  PlaneFit<Dim> fit = fit_planes<Dim>(shape, cube, tolerance[Dim] * cell_size, halvings_left == 0);
  if (fit.state == State::empty) {
    return;
  }
  std::vector<SurfacePiece<Dim>> pieces;
  if (!fit.planes.empty()) {
    pieces = surface_pieces<Dim>(cube, fit);
    follow_curve<Dim>(shape, cell_size, cube, fit, pieces);
  }
  const bool rough = fit.state == State::rough ||
                     !on_surface<Dim>(shape, pieces, 1.5 * tolerance[Dim] * cell_size);
  // In space a piece has one point: it is kept small.
  const bool large = Dim == 3 && !pieces.empty() && cube.side > longest_piece * cell_size;
  if ((rough || large) && halvings_left > 0) {
    for (int which = 0; which < (1 << Dim); ++which) {
      add_cube(shape, cube.part(which), cell_size, halvings_left - 1, cell);
    }
    return;
  }
  const auto points = volume_points<Dim>(cube, fit);
  cell.points.insert(cell.points.end(), points.begin(), points.end());
  std::move(pieces.begin(), pieces.end(), std::back_inserter(cell.pieces));
}

/// The shape inside the grid: cut there only where it reaches beyond.
template <int Dim>
Shape within_grid(const Shape& shape, const Grid<Dim>& grid) {
  const Bounds ends = bounds(shape);
  const double slack = 1e-9 * grid.cell_size();
  Box inside;
  bool beyond = false;
  for (int axis = 0; axis < Dim; ++axis) {
    const double upper =
        grid.lower()[axis] + (grid.cells(axis) - 2 * Grid<Dim>::padding) * grid.cell_size();
    inside.lower.push_back(grid.lower()[axis]);
    inside.upper.push_back(upper);
    beyond =
        beyond || ends.lower[axis] < grid.lower()[axis] - slack || ends.upper[axis] > upper + slack;
  }
  return beyond ? Shape(Intersection{{shape, Shape(inside)}}) : shape;
}

}  // namespace

CubeLayout::CubeLayout(ShapeFunction shape)
    : shift(shape == ShapeFunction::linear    ? 0.0
            : shape == ShapeFunction::bspline ? 0.5
                                              : resting_half_width),
      per_axis(shape == ShapeFunction::gimp ? 2 : 1) {}

template <int Dim>
Cube<Dim> cube_of(const Grid<Dim>& grid, const CubeLayout& layout,
                  const typename Grid<Dim>::Cell& node, int which) {
  const double h = grid.cell_size();
  Cube<Dim> cube{Vec<Dim>::Zero(), h / layout.per_axis};
  for (int axis = 0; axis < Dim; ++axis, which /= layout.per_axis) {
    cube.low[axis] =
        grid.origin()[axis] + (node[axis] - layout.shift) * h + which % layout.per_axis * cube.side;
  }
  return cube;
}

template <int Dim>
std::vector<CellCut<Dim>> cut_shape(const Shape& whole, const Grid<Dim>& grid,
                                    const CubeLayout& layout) {
  const Shape shape = within_grid<Dim>(whole, grid);
  const double h = grid.cell_size(), reach = (0.5 * std::sqrt(static_cast<double>(Dim)) + 1e-8) * h;
  const Bounds ends = bounds(shape);
  typename Grid<Dim>::Cell first, count;
  Index cells = 1;
  for (int axis = 0; axis < Dim; ++axis) {
    const double origin = grid.origin()[axis];
    const double low = std::max(ends.lower[axis], grid.lower()[axis]);
    const double most = grid.origin()[axis] + grid.cells(axis) * h;
    const double high = std::min(ends.upper[axis], most - Grid<Dim>::padding * h);
    first[axis] = static_cast<int>(std::floor((low - origin) / h + layout.shift)) - 1;
    count[axis] =
        static_cast<int>(std::floor((high - origin) / h + layout.shift)) + 2 - first[axis];
    cells *= count[axis];
  }
  const int cubes = power(layout.per_axis, Dim);
  constexpr Index row = 64;  // cells worked on as one piece
  std::vector<std::vector<CellCut<Dim>>> found(static_cast<std::size_t>((cells + row - 1) / row));
  parallel_tasks(static_cast<Index>(found.size()), [&](Index task) {
    for (Index k = task * row; k < std::min(cells, (task + 1) * row); ++k) {
      CellCut<Dim> cell;
      Index rest = k;
      Vec3 middle = Vec3::Zero();
      for (int axis = 0; axis < Dim; ++axis) {
        cell.node[axis] = first[axis] + static_cast<int>(rest % count[axis]);
        rest /= count[axis];
        middle[axis] = grid.origin()[axis] + (cell.node[axis] + 0.5 - layout.shift) * h;
      }
      const double depth = distance(shape, middle);
      if (depth >= reach) {
        continue;
      }
      if (depth <= -reach) {
        cell.full = (1U << cubes) - 1;
      } else {
        for (int which = 0; which < cubes; ++which) {
          const Cube<Dim> cube = cube_of<Dim>(grid, layout, cell.node, which);
          Vec3 at = Vec3::Zero();
          at.template head<Dim>() = cube.middle();
          if (distance(shape, at) <= -reach / layout.per_axis) {
            cell.full |= 1U << which;
          } else {
            add_cube<Dim>(shape, cube, h, halvings[Dim], cell);
          }
        }
      }
      if (cell.full != 0 || !cell.points.empty() || !cell.pieces.empty()) {
        found[task].push_back(std::move(cell));
      }
    }
  });
  std::vector<CellCut<Dim>> all;
  for (auto& some : found) {
    std::move(some.begin(), some.end(), std::back_inserter(all));
  }
  return all;
}

#define LAPILLI_INSTANTIATE(Dim)                                                                   \
  template Cube<Dim> cube_of(const Grid<Dim>&, const CubeLayout&, const typename Grid<Dim>::Cell&, \
                             int);                                                                 \
  template std::vector<CellCut<Dim>> cut_shape(const Shape&, const Grid<Dim>&, const CubeLayout&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
