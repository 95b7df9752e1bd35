#include "lapilli/mpm/quasi_static/cut_moments.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace lapilli {
namespace {

constexpr double reach = 0.8660254037844387;  // of a unit box from its middle

/// The part of one tetrahedron in which the linear interpolant of `value` is negative.
void add_part(const Tetrahedron& corner, const std::array<double, 4>& value,
              std::vector<Tetrahedron>& parts) {
  std::array<int, 4> order{0, 1, 2, 3};
  std::sort(order.begin(), order.end(), [&](int a, int b) { return value[a] < value[b]; });
  const auto inside =
      std::count_if(value.begin(), value.end(), [](double one) { return one < 0.0; });
  const auto at = [&](int k) { return corner[order[k]]; };
  const auto crossing = [&](int a, int b) {
    const double low = value[order[a]], high = value[order[b]];
    return Vec3(at(a) + (at(b) - at(a)) * (low / (low - high)));
  };
  const auto keep = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const double size = (b - a).dot((c - a).cross(d - a));
    if (size > 0.0) {
      parts.push_back({a, b, c, d});
    } else if (size < 0.0) {
      parts.push_back({b, a, c, d});
    }
  };
  if (inside == 4) {
    keep(at(0), at(1), at(2), at(3));
  } else if (inside == 1) {
    keep(at(0), crossing(0, 1), crossing(0, 2), crossing(0, 3));
  } else if (inside == 2) {
    // A wedge between the triangles at corner 0 and at corner 1.
    const Vec3 a = crossing(0, 2), b = crossing(0, 3), c = crossing(1, 2), d = crossing(1, 3);
    keep(at(0), a, b, at(1));
    keep(a, b, at(1), d);
    keep(a, at(1), c, d);
  } else if (inside == 3) {
    const Vec3 a = crossing(0, 3), b = crossing(1, 3), c = crossing(2, 3);
    keep(at(0), at(1), at(2), a);
    keep(at(1), at(2), a, b);
    keep(at(2), a, b, c);
  }
}

/// The six tetrahedra of a box (Kuhn).
template <class Visit>
void for_each_tetrahedron(const Vec3& low, double size, const Visit& visit) {
  std::array<int, 3> axes{0, 1, 2};
  do {
    Tetrahedron corner;
    corner[0] = low;
    for (int k = 0; k < 3; ++k) {
      corner[k + 1] = corner[k] + size * Vec3(Vec3::Unit(axes[k]));
    }
    visit(corner);
  } while (std::next_permutation(axes.begin(), axes.end()));
}

}  // namespace

void SecondMoments::add(const Tetrahedron& part) {
  Vec3 sum = Vec3::Zero();
  Mat3 squares = Mat3::Zero();
  for (const Vec3& corner : part) {
    const Vec3 arm = corner - about;
    sum += arm;
    squares += arm * arm.transpose();
  }
  const double size = lapilli::volume(part);
  volume += size;
  first += 0.25 * size * sum;
  second += size / 20.0 * (squares + sum * sum.transpose());
}

void SecondMoments::add(const SecondMoments& part, double share) {
  volume += share * part.volume;
  first += share * part.first;
  second += share * part.second;
}

std::vector<Tetrahedron> parts_of_box(std::span<const Cut<3>> cuts, const Vec3& low, double size) {
  return tetrahedra(clip_polyhedron(cuboid(low, low + Vec3::Constant(size)), cuts));
}

std::vector<Tetrahedron> parts_of_box(const Shape& shape, const Vec3& low, double size,
                                      int halves) {
  const double side = size / halves;
  std::vector<Tetrahedron> parts;
  for (int k = 0; k < halves * halves * halves; ++k) {
    const Vec3 corner = low + side * Vec3(k % halves, (k / halves) % halves, k / (halves * halves));
    const double depth = distance(shape, corner + Vec3::Constant(0.5 * side));
    if (depth > reach * side) {
      continue;
    }
    for_each_tetrahedron(corner, side, [&](const Tetrahedron& ends) {
      std::array<double, 4> value{-1.0, -1.0, -1.0, -1.0};
      for (int end = 0; end < 4 && depth > -reach * side; ++end) {
        value[end] = distance(shape, ends[end]);
      }
      add_part(ends, value, parts);
    });
  }
  return parts;
}

SecondMoments moments_of_box(const Shape& shape, const Vec3& low, double size) {
  SecondMoments sum;
  sum.about = low + Vec3::Constant(0.5 * size);
  SecondMoments fine = sum, coarse = sum;
  for (const Tetrahedron& part : parts_of_box(shape, low, size, 4)) {
    fine.add(part);
  }
  for (const Tetrahedron& part : parts_of_box(shape, low, size, 2)) {
    coarse.add(part);
  }
  // Chords of a smooth surface leave an error of second order. Where the two are far apart the
  // surface is not smooth, and the finer one stands.
  if (std::abs(fine.volume - coarse.volume) > 0.1 * fine.volume) {
    return fine;
  }
  sum.add(fine, 4.0 / 3.0);
  sum.add(coarse, -1.0 / 3.0);
  return sum;
}

}  // namespace lapilli
