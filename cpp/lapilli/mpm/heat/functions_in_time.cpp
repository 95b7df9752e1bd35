#include "lapilli/mpm/heat/functions_in_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lapilli {
namespace {

constexpr std::size_t most_places = 4096;

/// Every so many of a list, so that not too many are left.
template <class T>
std::vector<T> thinned(std::span<const T> all) {
  const std::size_t stride = (all.size() + most_places - 1) / most_places;
  std::vector<T> some;
  for (std::size_t k = 0; k < all.size(); k += stride) {
    some.push_back(all[k]);
  }
  return some;
}

}  // namespace

void FunctionsInTime::ask(const Value& value, std::span<const Vec3> position,
                          std::span<const double> state) {
  if (changes_ || !value.is_function() || position.empty() || !std::isfinite(end_)) {
    return;
  }
  const std::vector<Vec3> places = thinned(position);
  const std::vector<double> states = thinned(state);
  std::vector<double> first(places.size()), values(places.size());
  value.evaluate(places, states, 0.0, first);
  for (int k = 0; k < instants && !changes_; ++k) {
    // Not evenly, or what repeats itself with them would look constant.
    constexpr double golden = 0.6180339887498949;
    const double within = std::fmod(golden * k, 1.0);
    value.evaluate(places, states, (k + within) * spacing(), values);
    changes_ = values != first;
  }
}

double FunctionsInTime::step() const {
  return changes_ ? spacing() : std::numeric_limits<double>::infinity();
}

}  // namespace lapilli
