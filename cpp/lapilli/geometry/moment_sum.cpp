#include "lapilli/geometry/moment_sum.hpp"

#include <cmath>

namespace lapilli {
namespace {

// Of a simplex of `size` with corners x: int x x^T = size / ((n+1)(n+2)) (sum x x^T + s s^T), with
// the sum s of its n + 1 corners.
template <std::size_t Corners>
MomentSum of_simplex(double size, const std::array<Vec3, Corners>& corners) {
  MomentSum sum;
  Vec3 total = Vec3::Zero();
  for (const Vec3& corner : corners) {
    total += corner;
    sum.second += corner * corner.transpose();
  }
  constexpr double count = Corners;
  sum.volume = size;
  sum.first = size / count * total;
  sum.second = size / (count * (count + 1.0)) * (sum.second + total * total.transpose());
  return sum;
}

}  // namespace

Part MomentSum::part(const Vec3& origin, double least) const {
  Part part;
  if (volume > least) {
    const Vec3 middle = first / volume;
    part.volume = volume;
    part.centroid = origin + middle;
    part.spread = second - volume * middle * middle.transpose();
  }
  return part;
}

MomentSum moments_of_box(double side, int dimension) {
  MomentSum sum;
  sum.volume = std::pow(side, dimension);
  Vec3 middle = Vec3::Zero();
  for (int axis = 0; axis < dimension; ++axis) {
    middle[axis] = 0.5 * side;
    sum.second(axis, axis) = sum.volume * side * side / 12.0;
  }
  sum.first = sum.volume * middle;
  sum.second += sum.volume * middle * middle.transpose();
  return sum;
}

MomentSum moment_sum(const Outline& polygon, const Vec<2>& origin) {
  const auto from_origin = [&](const Vec<2>& x) {
    return Vec3(x[0] - origin[0], x[1] - origin[1], 0);
  };
  MomentSum sum;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const Vec<2> a = polygon[k] - polygon[0], b = polygon[k + 1] - polygon[0];
    const double area = 0.5 * (a[0] * b[1] - a[1] * b[0]);
    sum.add(1.0, of_simplex<3>(area, {from_origin(polygon[0]), from_origin(polygon[k]),
                                      from_origin(polygon[k + 1])}));
  }
  return sum;
}

MomentSum moment_sum(const Polyhedron& body, const Vec3& origin) {
  MomentSum sum;
  for (const Tetrahedron& part : tetrahedra(body)) {
    sum.add(1.0, of_simplex<4>(volume(part), {part[0] - origin, part[1] - origin, part[2] - origin,
                                              part[3] - origin}));
  }
  return sum;
}

}  // namespace lapilli
