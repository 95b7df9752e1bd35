#pragma once

#include <array>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// A symmetric tensor of second rank as its components xx, yy, zz, xy, yz, xz (the order ParaView
/// reads). Plane strain keeps the first four. Shear components are tensor components: no factor 2.
struct SymmetricTensor {
  std::array<double, 6> components{};

  constexpr SymmetricTensor() = default;
  /// A number is that multiple of the identity.
  constexpr SymmetricTensor(double scalar)
      : components{scalar, scalar, scalar, 0.0, 0.0, 0.0} {}  // NOLINT
  constexpr SymmetricTensor(double xx, double yy, double zz, double xy, double yz, double xz)
      : components{xx, yy, zz, xy, yz, xz} {}

  constexpr double& operator[](int k) { return components[static_cast<std::size_t>(k)]; }
  constexpr double operator[](int k) const { return components[static_cast<std::size_t>(k)]; }
  constexpr bool operator==(const SymmetricTensor&) const = default;

  /// Whether it is a multiple of the identity.
  constexpr bool is_scalar() const { return *this == SymmetricTensor(components[0]); }
  constexpr double trace() const { return components[0] + components[1] + components[2]; }

  Mat3 matrix() const {
    const auto& c = components;
    Mat3 full;
    full << c[0], c[3], c[5], c[3], c[1], c[4], c[5], c[4], c[2];
    return full;
  }
  /// The leading Dim x Dim block.
  template <int Dim>
  Mat<Dim> block() const {
    return matrix().topLeftCorner<Dim, Dim>();
  }
};

/// The symmetric part of a 3 x 3 matrix.
inline SymmetricTensor symmetric_part(const Mat3& m) {
  return {m(0, 0),
          m(1, 1),
          m(2, 2),
          0.5 * (m(0, 1) + m(1, 0)),
          0.5 * (m(1, 2) + m(2, 1)),
          0.5 * (m(0, 2) + m(2, 0))};
}

}  // namespace lapilli
