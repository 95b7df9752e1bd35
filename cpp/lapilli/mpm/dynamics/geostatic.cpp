#include "lapilli/mpm/dynamics/geostatic.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"

namespace lapilli {

namespace {

/// The direction of gravity; zero without.
Vec3 along(const Vec3& gravity) {
  return gravity.norm() > 0.0 ? Vec3(gravity.normalized()) : Vec3(Vec3::Zero());
}

}  // namespace

SymmetricTensor stress_under(const GeostaticStress& rest, double weight, const Vec3& gravity) {
  const Vec3 down = along(gravity);
  const Mat3 level = Mat3::Identity() - down * down.transpose();
  return symmetric_part(
      Mat3(-(weight + rest.surcharge) * (down * down.transpose() + rest.k0 * level)));
}

SymmetricTensor stress_at(const GeostaticStress& rest, const Vec3& place, const Vec3& gravity,
                          double density) {
  const auto vector = [](const std::vector<double>& numbers) {
    Vec3 full = Vec3::Zero();
    std::copy(numbers.begin(), numbers.end(), full.data());
    return full;
  };
  const Vec3 outward = rest.normal.empty() ? Vec3(-gravity) : vector(rest.normal);
  require(outward.norm() > 0.0, "geostatic needs gravity, or a normal with a length above 0");
  const Vec3 normal = outward.normalized();
  const double depth = std::max(0.0, (vector(rest.surface) - place).dot(normal));
  const Vec3 traction = density * depth * gravity + rest.surcharge * along(gravity);
  const double across = traction.dot(normal);
  const Vec3 shear = traction - across * normal;
  const Mat3 plane = Mat3::Identity() - normal * normal.transpose();
  return symmetric_part(Mat3(across * (normal * normal.transpose() + rest.k0 * plane) +
                             shear * normal.transpose() + normal * shear.transpose()));
}

}  // namespace lapilli
