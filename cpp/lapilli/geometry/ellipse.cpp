#include "lapilli/geometry/ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/geometry/checks.hpp"

namespace lapilli {
namespace {

constexpr double tiny = std::numeric_limits<double>::min();

// The first Dim coordinates count.
template <int Dim>
class Quadric {
 public:
  Quadric(const std::vector<double>& center, const std::vector<double>& semi_axes) {
    for (int axis = 0; axis < Dim; ++axis) {
      center_[axis] = center[static_cast<std::size_t>(axis)];
      half_[axis] = semi_axes[static_cast<std::size_t>(axis)];
    }
    half_.minCoeff(&shortest_);
  }

  // The nearest place of the surface lies at y_i a_i^2 / (t + a_i^2) for the largest root t of
  // S(t) = sum (a_i y_i / (t + a_i^2))^2 = 1 (Eberly 2013); if y is zero along the shortest axis, t
  // may stop at minus its square, and the place leaves that plane.
  Vec<Dim> nearest(const Vec3& x) const {
    const Vec<Dim> y = x.head<Dim>() - center_;
    const Vec<Dim> squares = half_.cwiseAbs2();
    if (y[shortest_] == 0.0 && beyond_at_least(y, squares) <= 0.0) {
      return center_ + in_middle_plane(y, squares);
    }
    // Measured from minus the least square, so that no digits are lost near it. 1 / sqrt(S) is
    // nearly straight and concave: Newton's steps from below stay below and are few.
    const Vec<Dim> beyond_least = squares.array() - squares[shortest_];
    // No term of S may be above 1; two axes may be the shortest.
    double above = std::max(0.0, (half_.cwiseProduct(y.cwiseAbs()) - beyond_least).maxCoeff());
    for (int step = 0; step < 60; ++step) {
      double sum = 0.0, slope = 0.0;
      for (int axis = 0; axis < Dim; ++axis) {
        if (y[axis] != 0.0) {
          const double denominator = std::max(above, tiny) + beyond_least[axis];
          const double share = half_[axis] * y[axis] / denominator;
          sum += share * share;
          slope += share * share / denominator;
        }
      }
      const double change = sum * (std::sqrt(sum) - 1.0) / slope;
      above += change;
      if (!(change > 1e-16 * above)) {
        break;
      }
    }
    Vec<Dim> place = Vec<Dim>::Zero();
    for (int axis = 0; axis < Dim; ++axis) {
      if (y[axis] != 0.0) {
        place[axis] = y[axis] * squares[axis] / (std::max(above, tiny) + beyond_least[axis]);
      }
    }
    return center_ + place;
  }

  double level(const Vec3& x) const {
    return (x.head<Dim>() - center_).cwiseQuotient(half_).squaredNorm() - 1.0;
  }

  double distance(const Vec3& x) const {
    const double away = (x.head<Dim>() - nearest(x)).norm();
    return level(x) > 0.0 ? away : -away;
  }

  // The surface's own normal at the nearest place: also where the distance is zero.
  Vec3 gradient(const Vec3& x) const {
    Vec3 normal = Vec3::Zero();
    normal.head<Dim>() = (nearest(x) - center_).cwiseQuotient(half_.cwiseAbs2());
    return normal.normalized();
  }

  Bounds bounds() const {
    Bounds all;
    all.lower.head<Dim>() = center_ - half_;
    all.upper.head<Dim>() = center_ + half_;
    return all;
  }

 private:
  double beyond_at_least(const Vec<Dim>& y, const Vec<Dim>& squares) const {
    double sum = -1.0;
    for (int axis = 0; axis < Dim; ++axis) {
      if (y[axis] != 0.0) {
        const double share = half_[axis] * y[axis] / (squares[axis] - squares[shortest_]);
        sum += share * share;
      }
    }
    return sum;
  }

  // Near the middle of the longer axes the nearest place lies off the plane, on either side.
  Vec<Dim> in_middle_plane(const Vec<Dim>& y, const Vec<Dim>& squares) const {
    Vec<Dim> place = Vec<Dim>::Zero();
    double left = 1.0;
    for (int axis = 0; axis < Dim; ++axis) {
      if (y[axis] != 0.0) {
        place[axis] = y[axis] * squares[axis] / (squares[axis] - squares[shortest_]);
        left -= place[axis] * place[axis] / squares[axis];
      }
    }
    place[shortest_] = half_[shortest_] * std::sqrt(std::max(0.0, left));
    return place;
  }

  Vec<Dim> center_, half_;
  int shortest_ = 0;
};

void check_numbers(const std::vector<double>& center, const std::vector<double>& semi_axes,
                   std::size_t count, const char* kind) {
  require_numbers(center, count, count, kind, "center");
  require_numbers(semi_axes, count, count, kind, "semi_axes");
  for (const double half : semi_axes) {
    require_positive(half, kind, "semi_axes");
  }
}

}  // namespace

double Ellipse::distance(const Vec3& x) const { return Quadric<2>(center, semi_axes).distance(x); }
Vec3 Ellipse::gradient(const Vec3& x) const { return Quadric<2>(center, semi_axes).gradient(x); }
Bounds Ellipse::bounds() const { return Quadric<2>(center, semi_axes).bounds(); }

void Ellipse::check(int dimension) const {
  require_dimension(dimension, 2, kind, "a box");
  check_numbers(center, semi_axes, 2, kind);
}

double Ellipsoid::distance(const Vec3& x) const {
  return Quadric<3>(center, semi_axes).distance(x);
}
Vec3 Ellipsoid::gradient(const Vec3& x) const { return Quadric<3>(center, semi_axes).gradient(x); }
Bounds Ellipsoid::bounds() const { return Quadric<3>(center, semi_axes).bounds(); }

void Ellipsoid::check(int dimension) const {
  require_dimension(dimension, 3, kind, "an ellipse");
  check_numbers(center, semi_axes, 3, kind);
}

}  // namespace lapilli
