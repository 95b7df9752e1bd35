#include "lapilli/mpm/quasi_static/surface_piece.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

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

/// Share of the way where a function that is positive at its start ceases to be. Bisection: regions
/// bounded by several surfaces are all but zero on one side, which misleads secants.
template <class Function>
double last_inside(const Function& function) {
  double low = 0.0, high = 1.0;
  for (int round = 0; round < 52; ++round) {
    const double middle = 0.5 * (low + high);
    (function(middle) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

template <int Dim>
Piece<Dim> trim(const Piece<Dim>& piece, const std::function<double(const Vec3&)>& region,
                double slack) {
  const std::size_t count = piece.size();
  std::vector<double> value(count);
  for (std::size_t k = 0; k < count; ++k) {
    value[k] = region(in_space<Dim>(piece[k]));
    value[k] = std::abs(value[k]) <= slack ? 0.0 : value[k];
  }
  Piece<Dim> kept;
  const std::size_t sides = Dim == 2 ? count - 1 : count;
  for (std::size_t k = 0; k < count; ++k) {
    if (value[k] >= 0.0) {
      kept.push_back(piece[k]);
    }
    const std::size_t next = (k + 1) % count;
    if (k < sides && value[k] * value[next] < 0.0) {
      const Vec<Dim> along = piece[next] - piece[k];
      kept.push_back(piece[k] + last_inside([&](double share) {
                                  return region(in_space<Dim>(piece[k] + share * along)) *
                                         (value[k] < 0.0 ? -1.0 : 1.0);
                                }) * along);
    }
  }
  return kept;
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

template Piece<2> trim<2>(const Piece<2>&, const std::function<double(const Vec3&)>&, double);
template Piece<3> trim<3>(const Piece<3>&, const std::function<double(const Vec3&)>&, double);
template void add_points<2>(const Piece<2>&, const Vec<2>&, std::vector<SurfacePoint<2>>&);
template void add_points<3>(const Piece<3>&, const Vec<3>&, std::vector<SurfacePoint<3>>&);

}  // namespace lapilli
