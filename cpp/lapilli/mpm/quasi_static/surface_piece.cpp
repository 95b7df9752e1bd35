#include "lapilli/mpm/quasi_static/surface_piece.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "lapilli/mpm/surface/cube_parts.hpp"
#include "lapilli/mpm/surface/trim_straight.hpp"

namespace lapilli {
namespace {

struct FlatPoint {
  std::array<double, 3> share;  // of the corners
  double weight;                // of the area
};

/// Three Gauss points on a segment; seven of degree 5 on a triangle (Radon 1948).
template <int Dim>
const std::vector<FlatPoint>& flat_rule() {
  static const std::vector<FlatPoint> rule = [] {
    std::vector<FlatPoint> points;
    if constexpr (Dim == 2) {
      const double off = std::sqrt(0.15);
      for (const auto& [x, w] : {std::pair(0.5 - off, 5.0 / 18.0), std::pair(0.5, 8.0 / 18.0),
                                 std::pair(0.5 + off, 5.0 / 18.0)}) {
        points.push_back({{1.0 - x, x, 0.0}, w});
      }
    } else {
      const double root = std::sqrt(15.0);
      points.push_back({{1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}, 9.0 / 40.0});
      for (const double sign : {1.0, -1.0}) {
        const double b = (6.0 + sign * root) / 21.0, w = (155.0 + sign * root) / 1200.0;
        for (int corner = 0; corner < 3; ++corner) {
          FlatPoint point{{b, b, b}, w};
          point.share[corner] = 1.0 - 2.0 * b;
          points.push_back(point);
        }
      }
    }
    return points;
  }();
  return rule;
}

/// The parts of a piece in a region as the planes of its faces tell it.
template <int Dim>
std::vector<Piece<Dim>> clip_to_planes(const Piece<Dim>& piece, PlaneFit<Dim> fit, double slack) {
  for (Cut<Dim>& plane : fit.planes) {
    plane.offset += slack;
  }
  std::vector<Piece<Dim>> parts;
  Piece<Dim> rest = piece;
  for (const Cut<Dim>& plane : fit.planes) {
    if (fit.join == PlaneFit<Dim>::Join::any) {
      parts.push_back(rest);
      clip_piece<Dim>(parts.back(), plane);
      clip_piece<Dim>(rest, {-plane.normal, -plane.offset});
    } else {
      clip_piece<Dim>(rest, plane);
    }
  }
  if (fit.join == PlaneFit<Dim>::Join::all) {
    parts.push_back(rest);
  }
  std::erase_if(parts, [](const Piece<Dim>& part) { return part.size() < Dim; });
  return parts;
}

/// A cube around a piece.
template <int Dim>
Cube<Dim> around(const Piece<Dim>& piece) {
  Vec<Dim> low = piece.front(), high = piece.front();
  for (const Vec<Dim>& corner : piece) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const double side = (high - low).maxCoeff();
  return {0.5 * (low + high) - Vec<Dim>::Constant(0.5 * side), side};
}

/// Whether corners and middle of a piece lie at least so deep in a region.
template <int Dim>
bool is_inside(const Piece<Dim>& piece, const LevelSet& outside, double least) {
  const auto is_in = [&](const Vec<Dim>& place) {
    return -outside.distance(in_space<Dim>(place)) >= least;
  };
  return is_in(SurfacePiece<Dim>{piece, Vec<Dim>::Zero()}.middle()) &&
         std::ranges::all_of(piece, is_in);
}

/// Add the parts of a piece in one region to `kept`. `outside`: the region, negative inside;
/// `size` (m): of the piece at first.
template <int Dim>
void trim_finely(const Piece<Dim>& piece, const LevelSet& outside, double size, double slack,
                 int halvings, std::vector<Piece<Dim>>& kept) {
  using State = typename PlaneFit<Dim>::State;
  constexpr double flat = 1e-9, smooth = 1e-3;  // of the size: how near planes are
  const SurfacePiece<Dim> whole{piece, Vec<Dim>::Zero()};
  double radius = 0.0;
  for (const Vec<Dim>& corner : piece) {
    radius = std::max(radius, (corner - whole.middle()).norm());
  }
  // Without a normal it is no distance: what lies above a flat piece may be twice as far.
  const double reach = outside.normal ? radius : 2.0 * radius;
  const double at_middle = -outside.distance(in_space<Dim>(whole.middle()));
  if (at_middle > reach) {
    kept.push_back(piece);
    return;
  }
  if (at_middle < -reach || !(radius > 0.0)) {
    return;
  }
  bool is_curve = false;
  if (!outside.normal && is_inside<Dim>(piece, outside, -slack)) {
    kept.push_back(piece);
    return;
  }
  if (outside.normal) {
    const PlaneFit<Dim> fit = fit_planes<Dim>(outside, around<Dim>(piece), flat * radius, false);
    if (fit.state == State::full || fit.state == State::empty) {
      if (fit.state == State::full) {
        kept.push_back(piece);
      }
      return;
    }
    if (fit.state == State::cut) {
      const std::vector<Piece<Dim>> parts = clip_to_planes<Dim>(piece, fit, slack);
      // A face that no sample was nearest to would have cut them.
      const double least = -10.0 * flat * radius - slack;
      if (std::ranges::all_of(
              parts, [&](const auto& part) { return is_inside<Dim>(part, outside, least); })) {
        kept.insert(kept.end(), parts.begin(), parts.end());
        return;
      }
    }
    const PlaneFit<Dim> near = fit_planes<Dim>(outside, around<Dim>(piece), smooth * size, false);
    is_curve = near.state == State::cut && near.planes.size() == 1;
  }
  if (!is_curve && halvings > 0) {
    for (const SurfacePiece<Dim>& part : whole.parts()) {
      trim_finely<Dim>(part.corners, outside, size, slack, halvings - 1, kept);
    }
    return;
  }
  Piece<Dim> part = trim_straight<Dim>(
      piece, [&](const Vec<Dim>& x) { return -outside.distance(in_space<Dim>(x)); }, slack);
  if (part.size() >= Dim) {
    kept.push_back(std::move(part));
  }
}

}  // namespace

template <int Dim>
std::vector<Piece<Dim>> trim_to(Trims regions, const Piece<Dim>& piece, double slack) {
  std::vector<Piece<Dim>> pieces{piece};
  for (const LevelSet& region : regions) {
    LevelSet outside{[&](const Vec3& x) { return -region.distance(x); }, {}};
    if (region.normal) {
      outside.normal = [&](const Vec3& x) { return Vec3(-region.normal(x)); };
    }
    std::vector<Piece<Dim>> kept;
    for (const Piece<Dim>& one : pieces) {
      const double size = around<Dim>(one).side;
      trim_finely<Dim>(one, outside, size, slack, region.normal ? 6 : 2, kept);
    }
    pieces = std::move(kept);
  }
  return pieces;
}

template <int Dim>
void add_points(const Piece<Dim>& piece, const Vec<Dim>& normal,
                std::vector<SurfacePoint<Dim>>& points) {
  if constexpr (Dim == 2) {
    if (piece.size() < 2) {
      return;
    }
    const Vec<2> along = piece.back() - piece.front();
    for (const FlatPoint& rule : flat_rule<2>()) {
      points.push_back({piece.front() + rule.share[1] * along, normal, rule.weight * along.norm()});
    }
  } else {
    for (std::size_t k = 1; k + 1 < piece.size(); ++k) {
      const double area = 0.5 * (piece[k] - piece[0]).cross(piece[k + 1] - piece[0]).norm();
      for (const FlatPoint& rule : flat_rule<3>()) {
        points.push_back(
            {rule.share[0] * piece[0] + rule.share[1] * piece[k] + rule.share[2] * piece[k + 1],
             normal, rule.weight * area});
      }
    }
  }
}

template std::vector<Piece<2>> trim_to<2>(Trims, const Piece<2>&, double);
template std::vector<Piece<3>> trim_to<3>(Trims, const Piece<3>&, double);
template void add_points<2>(const Piece<2>&, const Vec<2>&, std::vector<SurfacePoint<2>>&);
template void add_points<3>(const Piece<3>&, const Vec<3>&, std::vector<SurfacePoint<3>>&);

}  // namespace lapilli
