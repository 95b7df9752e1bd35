#include "lapilli/scene/bearable_k0.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lapilli {
namespace {

constexpr double noticed = 1e-3, rounding = 1e-6;  // of the largest stress
constexpr double largest_k0 = 1e3;                 // beyond, no bound is looked for

double largest(const SymmetricTensor& stress) {
  double most = 0.0;
  for (const double one : stress.components) {
    most = std::max(most, std::abs(one));
  }
  return most;
}

}  // namespace

bool BearableK0::bears(const SymmetricTensor& stress, double slack) const {
  std::array<double, most_state_variables> state{};
  const SymmetricTensor returned = return_stress(law_, stress, state.data());
  SymmetricTensor change;
  for (int c = 0; c < 6; ++c) {
    change[c] = returned[c] - stress[c];
  }
  return largest(change) <= slack * largest(stress);
}

/// Level ground bears all sides alike; a slope may bear another ratio only.
std::optional<double> BearableK0::borne(const Stress& stress) const {
  constexpr int tries = 16;
  for (int k = 0; k <= tries; ++k) {
    const double ratio = std::pow(1.25, k);
    for (const double one : {ratio, 1.0 / ratio}) {
      if (bears(stress(one), rounding)) {
        return one;
      }
    }
  }
  return std::nullopt;
}

double BearableK0::edge(const Stress& stress, double inside, double outside) const {
  constexpr int halvings = 40;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (inside + outside);
    (bears(stress(middle), rounding) ? inside : outside) = middle;
  }
  return inside;
}

std::optional<double> BearableK0::nearest(const Stress& stress, double k0) const {
  if (!yields(law_) || !has_tangent(law_) || bears(stress(k0), noticed)) {
    return k0;
  }
  const std::optional<double> inside = borne(stress);
  return inside ? std::optional(edge(stress, *inside, k0)) : std::nullopt;
}

std::optional<BearableK0::Range> BearableK0::range(const Stress& stress) const {
  const std::optional<double> inside = borne(stress);
  if (!inside) {
    return std::nullopt;
  }
  const auto end = [&](double outermost) {
    return bears(stress(outermost), rounding) ? outermost : edge(stress, *inside, outermost);
  };
  return Range{end(0.0), end(largest_k0)};
}

}  // namespace lapilli
