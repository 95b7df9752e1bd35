#pragma once

#include <array>

#include "lapilli/core/simd.hpp"

namespace lapilli {

/// A number with its derivatives to `size` variables (forward differentiation), as another `Real`
/// of the laws.
template <int size>
struct Dual {
  double value = 0.0;
  std::array<double, size> slope{};

  /// The variable number k.
  static Dual variable(double value, int k) {
    Dual one{value, {}};
    one.slope[static_cast<std::size_t>(k)] = 1.0;
    return one;
  }

  /// value, with the derivatives of a and b by their factors.
  static Dual mix(double value, double factor_a, const Dual& a, double factor_b, const Dual& b) {
    Dual mixed{value, {}};
    for (std::size_t k = 0; k < size; ++k) {
      mixed.slope[k] = factor_a * a.slope[k] + factor_b * b.slope[k];
    }
    return mixed;
  }
  static Dual scaled(double value, double factor, const Dual& a) {
    Dual result{value, {}};
    for (std::size_t k = 0; k < size; ++k) {
      result.slope[k] = factor * a.slope[k];
    }
    return result;
  }

  friend Dual operator+(const Dual& a, const Dual& b) {
    return mix(a.value + b.value, 1.0, a, 1.0, b);
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return mix(a.value - b.value, 1.0, a, -1.0, b);
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return mix(a.value * b.value, b.value, a, a.value, b);
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double ratio = a.value / b.value;
    return mix(ratio, 1.0 / b.value, a, -ratio / b.value, b);
  }
  friend Dual operator+(const Dual& a, double b) { return {a.value + b, a.slope}; }
  friend Dual operator-(const Dual& a, double b) { return {a.value - b, a.slope}; }
  friend Dual operator*(const Dual& a, double b) { return scaled(a.value * b, b, a); }
  friend Dual operator/(const Dual& a, double b) { return scaled(a.value / b, 1.0 / b, a); }
  friend Dual operator+(double a, const Dual& b) { return b + a; }
  friend Dual operator-(double a, const Dual& b) { return scaled(a - b.value, -1.0, b); }
  friend Dual operator*(double a, const Dual& b) { return b * a; }
  Dual& operator+=(const Dual& other) { return *this = *this + other; }

  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
  friend bool operator<(const Dual& a, double b) { return a.value < b; }
  friend bool operator>(const Dual& a, double b) { return a.value > b; }
  friend bool operator>=(const Dual& a, double b) { return a.value >= b; }

  /// Without a slope at zero, where it has none.
  friend Dual square_root(const Dual& a) {
    const double root = std::sqrt(a.value);
    return scaled(root, root > 0.0 ? 0.5 / root : 0.0, a);
  }
};

template <>
inline Dual<3> as<Dual<3>>(double value) {
  return {value, {}};
}
template <>
inline Dual<6> as<Dual<6>>(double value) {
  return {value, {}};
}

}  // namespace lapilli
