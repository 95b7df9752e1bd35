#include "lapilli/mpm/corner_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "lapilli/core/parallel.hpp"

namespace lapilli {
namespace {

// Tuned on squares, L-shapes, polygons, cubes, rings, discs and holes of two cells radius upwards.
constexpr double near_radius = 2.5, far_radius = 4.5;       // cells
constexpr double ramp_from = 40.0, ramp_to = 60.0;          // degrees of turn
constexpr double growth_from = 1.3, growth_to = 1.7;        // turn far / turn near
constexpr double least_turn = 20.0;                         // degrees
constexpr double closed_turn = 140.0, closed_width = 12.0;  // degrees; small bodies are near 180
constexpr double regularisation = 0.02, longest = 2.0;
constexpr int sweeps = 3;

double smoothstep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double eighth_power(double x) {
  const double square = x * x;
  return square * square * square * square;
}

/// Turning angle, in degrees, of two faces whose area vectors add up to `sum` out of `length`.
double turn_of(double sum, double length) {
  const double coherence = length > 0.0 ? std::clamp(sum / length, 0.0, 1.0) : 1.0;
  return 2.0 * std::acos(coherence) * 180.0 / std::numbers::pi;
}

/// Area vectors and what the fit asks of them: those around a node, smoothed or as they are.
template <int Dim>
class AreaVectors {
 public:
  AreaVectors(const Grid<Dim>& grid, const std::vector<Vec<Dim>>& raw) : grid_(grid), raw_(raw) {
    const int reach = static_cast<int>(far_radius), width = 2 * reach + 1;
    for (int b = 0; b < (Dim == 2 ? width * width : width * width * width); ++b) {
      Offset offset;
      double square = 0.0;
      for (int axis = 0, rest = b; axis < Dim; ++axis, rest /= width) {
        offset.step[axis] = rest % width - reach;
        square += offset.step[axis] * offset.step[axis];
        offset.nodes += offset.step[axis] * grid.node_stride(axis);
      }
      offset.distance = std::sqrt(square);
      if (offset.distance <= far_radius) {
        offsets_.push_back(offset);
      }
    }
    std::stable_sort(offsets_.begin(), offsets_.end(),
                     [](const Offset& a, const Offset& b) { return a.distance < b.distance; });
    std::vector<double> scratch;
    length_.assign(raw.size(), 0.0);
    for (int axis = 0; axis < Dim; ++axis) {
      smoothed_[axis].resize(raw.size());
      parallel_for(static_cast<Index>(raw.size()),
                   [&](Index node) { smoothed_[axis][node] = raw[node][axis]; });
      smooth_nodes(grid, smoothed_[axis], scratch);
    }
    parallel_for(grid.node_count(), [&](Index node) { length_[node] = smoothed(node).norm(); });
  }

  /// Call body(node, distance in cells) for the nodes of the grid within `radius`, nearest first.
  template <class Body>
  void around(Index node, double radius, const Body& body) const {
    const auto at = grid_.node_at(node);
    int margin = grid_.nodes(0);
    for (int axis = 0; axis < Dim; ++axis) {
      margin = std::min({margin, at[axis], grid_.nodes(axis) - 1 - at[axis]});
    }
    const bool whole = margin >= static_cast<int>(radius);
    for (const Offset& offset : offsets_) {
      if (offset.distance > radius) {
        return;
      }
      bool inside = true;
      for (int axis = 0; axis < Dim && !whole; ++axis) {
        const int to = at[axis] + offset.step[axis];
        inside = inside && to >= 0 && to < grid_.nodes(axis);
      }
      if (inside) {
        body(node + offset.nodes, offset.distance);
      }
    }
  }

  const Vec<Dim>& raw(Index node) const { return raw_[node]; }
  /// Smoothed once by 1/4, 1/2, 1/4 along every axis.
  Vec<Dim> smoothed(Index node) const {
    Vec<Dim> a;
    for (int axis = 0; axis < Dim; ++axis) {
      a[axis] = smoothed_[axis][node];
    }
    return a;
  }
  double smoothed_length(Index node) const { return length_[node]; }

 private:
  struct Offset {
    std::array<int, Dim> step;
    Index nodes = 0;
    double distance;
  };

  const Grid<Dim>& grid_;
  const std::vector<Vec<Dim>>& raw_;
  std::vector<Offset> offsets_;
  std::array<std::vector<double>, Dim> smoothed_;
  std::vector<double> length_;
};

/// One where the surface turns within the near ball as a corner does, zero on curves and on small
/// closed bodies, whose turn grows with the distance looked at.
template <int Dim>
double guard(const AreaVectors<Dim>& vectors, Index node) {
  Vec<Dim> inner = Vec<Dim>::Zero(), outer = Vec<Dim>::Zero();
  double inner_length = 0.0, outer_length = 0.0;
  vectors.around(node, far_radius, [&](Index at, double distance) {
    (distance <= near_radius ? inner : outer) += vectors.smoothed(at);
    (distance <= near_radius ? inner_length : outer_length) += vectors.smoothed_length(at);
  });
  const double turn_in = turn_of(inner.norm(), inner_length);
  const double turn_out = turn_of(outer.norm(), outer_length);
  const double turn_all = turn_of((inner + outer).norm(), inner_length + outer_length);
  const double growth = turn_out / std::max(turn_in, least_turn);
  return smoothstep((growth_to - growth) / (growth_to - growth_from)) *
         std::clamp((closed_turn - turn_all) / closed_width, 0.0, 1.0);
}

}  // namespace

template <int Dim>
void fit_corners(const Grid<Dim>& grid, const NodalSums<Dim>& sums, NodalAreas<Dim>& areas) {
  const AreaVectors<Dim> vectors(grid, sums.area_vector);
  const auto count = static_cast<Index>(areas.node.size());
  const auto row_of = [&](Index node) -> Index {
    const auto found = std::lower_bound(areas.node.begin(), areas.node.end(), node);
    return found != areas.node.end() && *found == node ? found - areas.node.begin() : -1;
  };

  // Coherence of the area vectors on each node's own side, and the ramp it gives.
  std::vector<double> trust(areas.node.size()), ramp(areas.node.size()), target(areas.node.size());
  parallel_for(count, [&](Index k) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    double length = 0.0;
    vectors.around(areas.node[k], near_radius, [&](Index at, double) {
      const Vec<Dim> a = vectors.smoothed(at);
      if (a.dot(areas.normal[k]) > 0.0) {
        sum += a;
        length += vectors.smoothed_length(at);
      }
    });
    trust[k] = length > 0.0 ? eighth_power(std::min(1.0, sum.norm() / length)) : 0.0;
    ramp[k] = smoothstep((turn_of(sum.norm(), length) - ramp_from) / (ramp_to - ramp_from));
    target[k] = vectors.raw(areas.node[k]).norm();
  });
  std::vector<Index> corners;
  for (Index k = 0; k < count; ++k) {
    if (ramp[k] > 0.0) {
      corners.push_back(k);
    }
  }

  std::vector<Vec<Dim>> fitted(areas.node.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (const Index k : corners) {
      Mat<Dim> matrix = Mat<Dim>::Zero();
      Vec<Dim> right = Vec<Dim>::Zero();
      vectors.around(areas.node[k], near_radius, [&](Index at, double distance) {
        const Vec<Dim>& a = vectors.raw(at);
        const Index row = row_of(at);
        if (distance > 0.0 && row >= 0 && a.dot(areas.normal[k]) > 0.0) {
          const double weight = trust[row] / a.norm();
          matrix += weight * a * a.transpose();
          right += weight * target[row] * a;
        }
      });
      const double lambda = regularisation * matrix.trace();
      if (!(lambda > 0.0)) {
        fitted[k] = areas.normal[k];
        continue;
      }
      matrix += lambda * Mat<Dim>::Identity();
      Vec<Dim> w = matrix.ldlt().solve(right + lambda * areas.normal[k]);
      w *= std::min(1.0, longest / w.norm());
      fitted[k] = areas.normal[k] + ramp[k] * (w - areas.normal[k]);
    }
    for (const Index k : corners) {
      const Vec<Dim>& a = vectors.raw(areas.node[k]);
      target[k] = std::max(a.norm(), fitted[k].dot(a));
    }
  }
  for (const Index k : corners) {
    const Vec<Dim> w =
        areas.normal[k] + guard(vectors, areas.node[k]) * (fitted[k] - areas.normal[k]);
    areas.area[k] = w.dot(vectors.raw(areas.node[k]));
  }
}

template <>
void fit_corners(const Grid<1>&, const NodalSums<1>&, NodalAreas<1>&) {}  // a line has no corners
template void fit_corners(const Grid<2>&, const NodalSums<2>&, NodalAreas<2>&);
template void fit_corners(const Grid<3>&, const NodalSums<3>&, NodalAreas<3>&);

}  // namespace lapilli
