#pragma once

#include <memory>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/mpm/dynamics/dynamics_data.hpp"

namespace lapilli {

/// The state in which another run left points that this one goes on with.
struct PointStart {
  std::shared_ptr<const Archive> state;  // of the other run
  std::vector<Index> row;  // in it, by id of the point here; -1 for points that start anew
  bool same_transfer;      // whether what points carry of the velocity means the same

  /// Gives the points mass, velocity, stress and state variables. Throws std::invalid_argument
  /// where the other run had no dynamics of this dimension.
  template <int Dim>
  void apply(DynamicsData<Dim>& data) const;
};

}  // namespace lapilli
