#pragma once

#include <limits>

#include "lapilli/mpm/dynamics/dynamics_data.hpp"

namespace lapilli {

/// Moves points: walls hold them at the face, elsewhere they may leave and are reported.
template <int Dim>
class Mover {
 public:
  Mover(const DynamicsData<Dim>& data, double span) : span_(span) {
    const double slack = 1e-9 * data.grid.cell_size();
    for (int axis = 0; axis < Dim; ++axis) {
      lower_[axis] = data.grid.lower()[axis] - slack;
      upper_[axis] = data.grid.upper()[axis] + slack;
      const double far = std::numeric_limits<double>::infinity();
      const bool held_below = !data.walls[2 * axis].is_open();
      const bool held_above = !data.walls[2 * axis + 1].is_open();
      least_[axis] = held_below ? data.grid.lower()[axis] : -far;
      most_[axis] = held_above ? data.grid.upper()[axis] : far;
    }
  }

  /// Whether the point is still inside the grid and finite.
  bool operator()(double* position, const double* velocity) const {
    bool inside = true;
    for (int axis = 0; axis < Dim; ++axis) {
      double x = position[axis] + span_ * velocity[axis];
      x = x < least_[axis] ? least_[axis] : x;
      x = x > most_[axis] ? most_[axis] : x;
      position[axis] = x;
      inside = inside & (x >= lower_[axis]) & (x <= upper_[axis]);
    }
    return inside;
  }

  /// The same for the first half of a step: what would leave waits at the face for the second.
  void drift(double* position, const double* velocity) const {
    for (int axis = 0; axis < Dim; ++axis) {
      double x = position[axis] + span_ * velocity[axis];
      x = x < lower_[axis] ? lower_[axis] : x;
      position[axis] = x > upper_[axis] ? upper_[axis] : x;
    }
  }

 private:
  double span_;
  double lower_[Dim], upper_[Dim], least_[Dim], most_[Dim];
};

}  // namespace lapilli
