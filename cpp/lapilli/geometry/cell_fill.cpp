#include "lapilli/geometry/cell_fill.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "lapilli/core/symmetric_modes.hpp"
#include "lapilli/geometry/box_parts.hpp"
#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/random.hpp"

namespace lapilli {
namespace {

using FourPoints = std::array<Vec3, 4>;

// Below this share of a box it is cut by rounding alone.
constexpr double smallest_share = 1e-12;

// Turns of the four points to choose from: as they are, mirrored, and drawn ones (Shoemake 1992).
std::vector<Mat3> turns_to_try() {
  std::vector<Mat3> turns{Mat3::Identity(), -Mat3::Identity()};
  Random random(1);
  while (turns.size() < 64) {
    const double u = random.uniform(), a = 2.0 * std::numbers::pi * random.uniform(),
                 b = 2.0 * std::numbers::pi * random.uniform();
    const double p = std::sqrt(1.0 - u), q = std::sqrt(u);
    turns.push_back(
        Eigen::Quaterniond(q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b))
            .toRotationMatrix());
  }
  return turns;
}

// Four points of equal weight with the centroid c and the mean square M of a part: c + sqrt(M) Q v
// with the corners v of a tetrahedron, whose mean v v^T is the identity, and any turn Q.
FourPoints four_points(const Part& part, const Mat3& root, const Mat3& turn) {
  static const FourPoints corners{Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
  FourPoints points;
  for (std::size_t k = 0; k < 4; ++k) {
    points[k] = part.centroid + root * (turn * corners[k]);
  }
  return points;
}

Mat3 root_of_mean_square(const Part& part) {
  const SymmetricModes<3> axes = symmetric_modes<3>(part.spread / part.volume);
  const Vec3 lengths = axes.eigenvalues.cwiseMax(0.0).cwiseSqrt();
  return axes.eigenvectors * lengths.asDiagonal() * axes.eigenvectors.transpose();
}

// How far the points lie out of the box, at most; 0 where none does.
double beyond(const FourPoints& points, const Vec3& lower, double side) {
  double most = 0.0;
  for (const Vec3& x : points) {
    most = std::max({most, (lower - x).maxCoeff(), (x - lower).maxCoeff() - side});
  }
  return most;
}

double farthest_outside(const FourPoints& points, const Shape& shape, const Sites& cells) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& x : points) {
    most = std::max(most, distance(shape, cells.to_scene(x)));
  }
  return most;
}

// The turn that keeps the points in the cell and deepest in the shape. (Of 1,500 cells cut by one
// to three random planes all had such a turn.) Should there be none, the points are drawn together.
FourPoints points_in_cell(const Part& part, const Shape& shape, const Sites& cells,
                          const Vec3& lower) {
  static const std::vector<Mat3> turns = turns_to_try();
  const double side = cells.spacing(), slack = 1e-12 * side;
  Mat3 root = root_of_mean_square(part);
  for (int shrunk = 0; shrunk < 60; ++shrunk, root *= 0.9) {
    FourPoints best;
    double least = std::numeric_limits<double>::infinity();
    for (const Mat3& turn : turns) {
      const FourPoints points = four_points(part, root, turn);
      if (beyond(points, lower, side) > slack) {
        continue;
      }
      const double outside = farthest_outside(points, shape, cells);
      if (outside < least) {
        least = outside;
        best = points;
      }
      if (outside <= 0.0) {
        break;
      }
    }
    if (least < std::numeric_limits<double>::infinity()) {
      return best;
    }
  }
  return {part.centroid, part.centroid, part.centroid, part.centroid};
}

void append(FilledPoints& points, const Vec3& at, double volume) {
  points.position.insert(points.position.end(), at.data(), at.data() + 3);
  points.volume.push_back(volume);
}

void append_lattice(FilledPoints& points, const Vec3& lower, double spacing, int per_axis) {
  for (int k = 0; k < per_axis * per_axis * per_axis; ++k) {
    const Vec3 steps(k % per_axis, k / per_axis % per_axis, k / (per_axis * per_axis));
    append(points, lower + spacing * (steps + Vec3::Constant(0.5)), spacing * spacing * spacing);
  }
}

}  // namespace

FilledPoints fill_cells(const Shape& shape, const Lattice& lattice, const FillOptions& options,
                        int dimension) {
  FillOptions exact = options;
  exact.clip = true;
  exact.smallest_volume = smallest_share;
  if (dimension < 3) {
    return fill(shape, lattice, exact, dimension);
  }
  Lattice whole_cells = lattice;
  whole_cells.points_per_axis = 1;
  const Shape body = ready_to_fill(shape, whole_cells, exact, dimension);
  const Sites cells(body, whole_cells, exact, dimension);
  FilledPoints points;
  points.dimension = dimension;
  points.spacing = lattice.spacing();
  for (const BoxPart& cell : parts_of(body, cells)) {
    const Vec3 lower = cells.corner(cell.site);
    if (cell.part.is_whole) {
      append_lattice(points, lower, lattice.spacing(), lattice.points_per_axis);
    } else if (cell.part.volume > smallest_share * cells.box_volume()) {
      for (const Vec3& at : points_in_cell(cell.part, body, cells, lower)) {
        append(points, at, 0.25 * cell.part.volume);
      }
    }
  }
  require(points.size() > 0, kind_of(shape), ": no part of a cell of ", lattice.cell,
          " m lies inside: choose smaller cells");
  return points;
}

}  // namespace lapilli
