#include "lapilli/mpm/quasi_static/cut_fill.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/flat.hpp"
#include "lapilli/mpm/quasi_static/cut_moments.hpp"

namespace lapilli {
namespace {

constexpr double smallest = 1e-12;  // of a box; below it a box is cut by rounding alone

struct Cube {
  Vec3 low;
  double size;

  Vec3 middle() const { return low + Vec3::Constant(0.5 * size); }
  /// Distance from the nearest face, negative outside.
  double depth(const Vec3& at) const {
    return std::min((at - low).minCoeff(), (low - at).minCoeff() + size);
  }
};

void put(const Vec3& at, double volume, FilledPoints& points) {
  points.position.insert(points.position.end(), at.data(), at.data() + 3);
  points.volume.push_back(volume);
}

/// Rotations spread over all, the identity first.
const std::vector<Mat3>& trial_rotations() {
  static const std::vector<Mat3> rotations = [] {
    std::vector<Mat3> all{Mat3::Identity()};
    const Vec3 axes[] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},  {1, 1, 0},  {1, 0, 1},
                         {0, 1, 1},  {1, -1, 0}, {1, 0, -1}, {0, 1, -1}, {1, 1, 1},
                         {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};
    for (const Vec3& axis : axes) {
      for (const double degrees : {-90.0, -60.0, -30.0, 30.0, 60.0, 90.0}) {
        all.push_back(
            Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, axis.normalized()).matrix());
      }
    }
    return all;
  }();
  return rotations;
}

/// Four points of equal volume with these moments, as deep in the cell as a turn of them allows.
/// Adds nothing and returns false when one would lie outside.
bool put_four(const SecondMoments& moments, const Cube& cell, FilledPoints& points) {
  const Vec3 centre = moments.first / moments.volume;
  const Mat3 spread = moments.second / moments.volume - centre * centre.transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
  const Mat3 root = axes.eigenvectors() *
                    axes.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal().toDenseMatrix();
  Eigen::Matrix<double, 3, 4> corners;  // of a tetrahedron with the identity as second moments
  corners << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
  double deepest = 0.0;
  std::optional<Eigen::Matrix<double, 3, 4>> best;
  for (const Mat3& turn : trial_rotations()) {
    Eigen::Matrix<double, 3, 4> trial = root * turn * corners;
    trial.colwise() += moments.about + centre;
    double depth = cell.size;
    for (int k = 0; k < 4; ++k) {
      depth = std::min(depth, cell.depth(trial.col(k)));
    }
    if (depth > deepest * (1.0 + 1e-9)) {
      deepest = depth;
      best = trial;
    }
  }
  for (int k = 0; best && k < 4; ++k) {
    put(best->col(k), 0.25 * moments.volume, points);
  }
  return best.has_value();
}

/// What the gradients of trilinear functions are made of.
Eigen::Matrix<double, 7, 1> functions_at(const Vec3& x) {
  Eigen::Matrix<double, 7, 1> values;
  values << 1.0, x[0], x[1], x[2], x[0] * x[1], x[1] * x[2], x[2] * x[0];
  return values;
}

/// Seven or fewer of the points of a rule, with weights that integrate the same functions: along
/// the null space of eight points one weight after the other goes to zero (Caratheodory).
void put_few(std::vector<QuadraturePoint<3>> rule, const Cube& cell, FilledPoints& points) {
  while (rule.size() > 7) {
    Eigen::Matrix<double, 7, 8> values;
    for (int k = 0; k < 8; ++k) {
      values.col(k) = functions_at((rule[k].position - cell.middle()) / cell.size);
    }
    const Eigen::Matrix<double, 8, 1> change =
        Eigen::FullPivLU<Eigen::Matrix<double, 7, 8>>(values).kernel().col(0);
    int emptied = -1;
    double step = 0.0;
    for (int k = 0; k < 8; ++k) {
      // Either sign of the change will do: it has entries of both, the first function being one.
      const double until = change[k] > 0.0 ? rule[k].weight / change[k] : -1.0;
      if (until >= 0.0 && (emptied < 0 || until < step)) {
        emptied = k;
        step = until;
      }
    }
    for (int k = 0; k < 8; ++k) {
      rule[k].weight -= step * change[k];
    }
    rule.erase(rule.begin() + emptied);
  }
  for (const QuadraturePoint<3>& point : rule) {
    if (point.weight > 0.0) {
      put(point.position, point.weight, points);
    }
  }
}

/// Fills the cells of a grid one after the other.
class CellFill {
 public:
  CellFill(const Shape& shape, const Lattice& lattice)
      : shape_(shape),
        cuts_(cuts_of(shape)),
        per_axis_(lattice.points_per_axis),
        boxes_(lattice.points_per_axis <= 2 ? 1 : lattice.points_per_axis) {}

  void fill(const Cube& cell, FilledPoints& points) const {
    const Where where = place_of(cell);
    if (where == Where::outside) {
      return;
    }
    if (where == Where::inside) {
      put_lattice(cell, per_axis_, points);
      return;
    }
    std::vector<Cube> cut;
    for_each_box(cell, boxes_, [&](const Cube& box) {
      const Where at = place_of(box);
      if (at == Where::inside) {
        put(box.middle(), box.size * box.size * box.size, points);
      } else if (at == Where::cut) {
        cut.push_back(box);
      }
    });
    put_cut(cell, cut, points);
  }

 private:
  enum class Where { outside, cut, inside };

  Where place_of(const Cube& box) const {
    constexpr double half_diagonal = 0.8660254037844387;
    const double off = distance(shape_, box.middle());
    if (off > half_diagonal * box.size) {
      return Where::outside;
    }
    if (!cuts_) {
      return off > -half_diagonal * box.size ? Where::cut : Where::inside;
    }
    const double slack = 1e-12 * box.size;
    for (const Cut<3>& cut : *cuts_) {
      if (cut.normal.dot(box.middle()) + 0.5 * box.size * cut.normal.lpNorm<1>() >
          cut.offset + slack) {
        return Where::cut;
      }
    }
    return Where::inside;
  }

  template <class Visit>
  static void for_each_box(const Cube& cell, int per_axis, const Visit& visit) {
    const double side = cell.size / per_axis;
    for (int k = 0; k < per_axis * per_axis * per_axis; ++k) {
      visit(Cube{cell.low + side * Vec3(k % per_axis, (k / per_axis) % per_axis,
                                        k / (per_axis * per_axis)),
                 side});
    }
  }

  static void put_lattice(const Cube& cell, int per_axis, FilledPoints& points) {
    for_each_box(cell, per_axis, [&](const Cube& box) {
      put(box.middle(), box.size * box.size * box.size, points);
    });
  }

  void put_cut(const Cube& cell, const std::vector<Cube>& boxes, FilledPoints& points) const {
    SecondMoments moments;
    moments.about = cell.middle();
    for (const Cube& box : boxes) {
      if (cuts_) {
        for (const Tetrahedron& part : parts_of_box(*cuts_, box.low, box.size)) {
          moments.add(part);
        }
      } else {
        moments.add(moved(moments_of_box(shape_, box.low, box.size), moments.about));
      }
    }
    const double whole = cell.size * cell.size * cell.size;
    if (moments.volume <= smallest * whole || put_four(moments, cell, points)) {
      return;
    }
    std::vector<Tetrahedron> parts;
    for (const Cube& box : boxes) {
      const auto of_box = cuts_ ? parts_of_box(*cuts_, box.low, box.size)
                                : parts_of_box(shape_, box.low, box.size, 4);
      parts.insert(parts.end(), of_box.begin(), of_box.end());
    }
    put_few(quadrature(parts), cell, points);
  }

  /// The same moments about another point.
  static SecondMoments moved(const SecondMoments& from, const Vec3& about) {
    const Vec3 by = from.about - about;
    SecondMoments to = from;
    to.about = about;
    to.first += from.volume * by;
    to.second += from.first * by.transpose() + by * from.first.transpose() +
                 from.volume * by * by.transpose();
    return to;
  }

  const Shape& shape_;
  std::optional<std::vector<Cut<3>>> cuts_;
  int per_axis_, boxes_;
};

}  // namespace

FilledPoints fill_exactly(const Shape& shape, const Lattice& lattice, int dimension) {
  if (dimension < 3) {
    FillOptions options;
    options.clip = true;
    options.smallest_volume = smallest;
    return fill(shape, lattice, options, dimension);
  }
  check(shape, 3);
  const Bounds ends = bounds(shape);
  require(ends.lower.allFinite() && ends.upper.allFinite(),
          "fill: the shape has no end along every axis");
  FilledPoints points;
  points.dimension = 3;
  points.spacing = lattice.spacing();
  std::array<Index, 3> first, last;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] =
        static_cast<Index>(std::floor((ends.lower[axis] - lattice.lower[axis]) / lattice.cell));
    last[axis] =
        static_cast<Index>(std::ceil((ends.upper[axis] - lattice.lower[axis]) / lattice.cell));
  }
  const CellFill cells(shape, lattice);
  for (Index k = first[2]; k <= last[2]; ++k) {
    for (Index j = first[1]; j <= last[1]; ++j) {
      for (Index i = first[0]; i <= last[0]; ++i) {
        const Vec3 step(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        cells.fill({lattice.lower + lattice.cell * step, lattice.cell}, points);
      }
    }
  }
  require(!points.volume.empty(), "fill: no point of the lattice lies in the shape");
  return points;
}

}  // namespace lapilli
