#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "lapilli/core/value.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"

namespace lapilli {

/// Whether a condition or a source is a function, which may depend on the place and on the time.
template <int Dim>
bool has_functions(const HeatProblem<Dim>& problem) {
  return std::ranges::any_of(problem.settings.boundaries, has_function) ||
         std::ranges::any_of(problem.bodies,
                             [](const HeatBody& body) { return body.source.is_function(); });
}

/// Whether functions change in the course of a run: each is asked at instants spread over it, with
/// the places and temperatures of the start. What is over within two of their spacings may pass
/// between them.
class FunctionsInTime {
 public:
  static constexpr int instants = 512;

  /// `end`: s, of the run; nothing is asked where it is not finite.
  explicit FunctionsInTime(double end) : end_(end) {}

  void ask(const Value& value, std::span<const Vec3> position, std::span<const double> state);

  /// How far apart the instants are, s.
  double spacing() const { return end_ / instants; }
  /// Steps that meet what was found, s; infinite where nothing changes.
  double step() const;

 private:
  double end_;
  bool changes_ = false;
};

}  // namespace lapilli
