#include "lapilli/mpm/surface/corner_fit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/simd.hpp"

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

/// Length of the sum of area vectors over the sum of their lengths: one where they agree.
template <int Dim>
double coherence(const Double4& sum) {
  double squares = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    squares += sum[axis] * sum[axis];
  }
  return sum[Dim] > 0.0 ? std::min(1.0, std::sqrt(squares) / sum[Dim]) : 1.0;
}

/// Turning angle, in degrees, of two faces whose area vectors add up with this coherence.
double turn_of(double coherence) { return 2.0 * std::acos(coherence) * 180.0 / std::numbers::pi; }

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
    const auto count = static_cast<Index>(raw.size());
    std::vector<double> component(raw.size()), scratch;
    smoothed_.assign(4 * raw.size(), 0.0);
    for (int axis = 0; axis < Dim; ++axis) {
      parallel_for(
          count, [&](Index node) { component[node] = raw[node][axis]; }, Work::light);
      smooth_nodes(grid, component, scratch);
      parallel_for(
          count, [&](Index node) { smoothed_[4 * node + axis] = component[node]; }, Work::light);
    }
    parallel_for(
        count,
        [&](Index node) {
          Eigen::Map<Eigen::Vector4d> a(smoothed_.data() + 4 * node);
          a[Dim] = a.template head<Dim>().norm();
        },
        Work::light);
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
  /// Smoothed once by 1/4, 1/2, 1/4 along every axis, followed by its length.
  Double4 smoothed(Index node) const { return load_quad(smoothed_.data() + 4 * node); }

 private:
  struct Offset {
    std::array<int, Dim> step;
    Index nodes = 0;
    double distance;
  };

  const Grid<Dim>& grid_;
  const std::vector<Vec<Dim>>& raw_;
  std::vector<Offset> offsets_;
  std::vector<double> smoothed_;
};

/// One where the surface turns within the near ball as a corner does, zero on curves and on small
/// closed bodies, whose turn grows with the distance looked at.
template <int Dim>
double guard(const AreaVectors<Dim>& vectors, Index node) {
  Double4 inner{}, outer{};
  vectors.around(node, far_radius, [&](Index at, double distance) {
    (distance <= near_radius ? inner : outer) += vectors.smoothed(at);
  });
  const double turn_in = turn_of(coherence<Dim>(inner));
  const double turn_out = turn_of(coherence<Dim>(outer));
  const double turn_all = turn_of(coherence<Dim>(inner + outer));
  const double growth = turn_out / std::max(turn_in, least_turn);
  return smoothstep((growth_to - growth) / (growth_to - growth_from)) *
         std::clamp((closed_turn - turn_all) / closed_width, 0.0, 1.0);
}

/// What one node asks of its neighbours: w with w . a = target for the faces on its own side.
template <int Dim>
struct Fit {
  struct Neighbour {
    int row;
    Vec<Dim> pull;  // of its target on the right-hand side
  };

  std::vector<Neighbour> neighbours;
  Mat<Dim> inverse = Mat<Dim>::Zero();
  double lambda = 0.0;

  Fit() = default;
  /// `row_of` gives the row of a node in `areas`, or -1.
  Fit(const AreaVectors<Dim>& vectors, const NodalAreas<Dim>& areas,
      const std::vector<double>& trust, std::span<const int> row_of, Index k) {
    Mat<Dim> matrix = Mat<Dim>::Zero();
    vectors.around(areas.node[k], near_radius, [&](Index at, double distance) {
      const Vec<Dim>& a = vectors.raw(at);
      if (distance > 0.0 && row_of[at] >= 0 && a.dot(areas.normal[k]) > 0.0) {
        const Vec<Dim> pull = trust[row_of[at]] / a.norm() * a;
        matrix += pull * a.transpose();
        neighbours.push_back({row_of[at], pull});
      }
    });
    lambda = regularisation * matrix.trace();
    if (lambda > 0.0) {
      matrix += lambda * Mat<Dim>::Identity();
      inverse = matrix.inverse();
    }
  }

  Vec<Dim> solve(const std::vector<double>& target, const Vec<Dim>& normal) const {
    if (!(lambda > 0.0)) {
      return normal;
    }
    Vec<Dim> right = lambda * normal;
    for (const Neighbour& neighbour : neighbours) {
      right += target[neighbour.row] * neighbour.pull;
    }
    const Vec<Dim> w = inverse * right;
    return std::min(1.0, longest / w.norm()) * w;
  }
};

/// What the area vectors on each node's own side say: how far they agree, and the ramp it gives.
struct Agreement {
  std::vector<double> trust, ramp;
};

template <int Dim>
Agreement agreement_of(const AreaVectors<Dim>& vectors, const NodalAreas<Dim>& areas) {
  Agreement found{std::vector<double>(areas.node.size()), std::vector<double>(areas.node.size())};
  parallel_for(static_cast<Index>(areas.node.size()), [&](Index k) {
    Double4 normal{}, sum{};
    for (int axis = 0; axis < Dim; ++axis) {
      normal[axis] = areas.normal[k][axis];
    }
    vectors.around(areas.node[k], near_radius, [&](Index at, double) {
      const Double4 a = vectors.smoothed(at), along = a * normal;
      if ((along[0] + along[1]) + along[2] > 0.0) {
        sum += a;
      }
    });
    const double agreement = coherence<Dim>(sum);
    found.trust[k] = sum[Dim] > 0.0 ? eighth_power(agreement) : 0.0;
    found.ramp[k] = smoothstep((turn_of(agreement) - ramp_from) / (ramp_to - ramp_from));
  });
  return found;
}

}  // namespace

template <int Dim>
void fit_corners(const Grid<Dim>& grid, const NodalSums<Dim>& sums, NodalAreas<Dim>& areas) {
  const AreaVectors<Dim> vectors(grid, sums.area_vector);
  const auto count = static_cast<Index>(areas.node.size());
  Agreement agreement = agreement_of(vectors, areas);
  const std::vector<double>& ramp = agreement.ramp;
  areas.corner.assign(areas.node.size(), 0.0);
  std::vector<int> row_of(sums.area_vector.size(), -1);
  std::vector<double> target(areas.node.size());
  std::vector<Index> corners;
  for (Index k = 0; k < count; ++k) {
    target[k] = vectors.raw(areas.node[k]).norm();
    row_of[areas.node[k]] = static_cast<int>(k);
    if (ramp[k] > 0.0) {
      corners.push_back(k);
    }
  }
  const auto for_each_corner = [&](const auto& body) {
    constexpr Index chunk = 64;
    const auto all = static_cast<Index>(corners.size());
    parallel_tasks((all + chunk - 1) / chunk, [&](Index task) {
      for (Index c = task * chunk; c < std::min(all, (task + 1) * chunk); ++c) {
        body(c, corners[c]);
      }
    });
  };
  std::vector<Fit<Dim>> fits(corners.size());
  for_each_corner([&](Index c, Index k) {
    fits[c] = {vectors, areas, agreement.trust, row_of, k};
  });

  std::vector<Vec<Dim>> fitted(corners.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for_each_corner([&](Index c, Index k) {
      const Vec<Dim> w = fits[c].solve(target, areas.normal[k]);
      fitted[c] = areas.normal[k] + ramp[k] * (w - areas.normal[k]);
    });
    for_each_corner([&](Index c, Index k) {
      const Vec<Dim>& a = vectors.raw(areas.node[k]);
      target[k] = std::max(a.norm(), fitted[c].dot(a));
    });
  }
  for_each_corner([&](Index c, Index k) {
    const double guarded = guard(vectors, areas.node[k]);
    areas.weight[k] = areas.normal[k] + guarded * (fitted[c] - areas.normal[k]);
    areas.area[k] = areas.weight[k].dot(areas.vector[k]);
    areas.corner[k] = guarded * ramp[k];
  });
  areas.trust = std::move(agreement.trust);
}

template <>
void fit_corners(const Grid<1>&, const NodalSums<1>&, NodalAreas<1>&) {}  // a line has no corners
template void fit_corners(const Grid<2>&, const NodalSums<2>&, NodalAreas<2>&);
template void fit_corners(const Grid<3>&, const NodalSums<3>&, NodalAreas<3>&);

}  // namespace lapilli
