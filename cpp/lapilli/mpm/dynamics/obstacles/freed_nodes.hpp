#pragma once

#include <functional>
#include <vector>

#include "lapilli/mpm/dynamics/dynamics_data.hpp"
#include "lapilli/mpm/dynamics/obstacles/contact.hpp"

namespace lapilli {

/// What faces of the grid let go of along themselves, so that an obstacle that moves along a rough
/// face takes material with it: nodes inside of obstacles, and nodes that hold points which an
/// obstacle has overtaken, the more of them the deeper.
template <int Dim>
class FreedNodes {
 public:
  explicit FreedNodes(const DynamicsData<Dim>& data);

  /// Share of its hold along the face that a node is let go of, 0 to 1.
  double share(Index node) const { return shares_.empty() ? 0.0 : shares_[node]; }

  void clear();
  /// Those that `contacts` with one obstacle reach; `gap` is how far a place is from it, m.
  void add(const DynamicsData<Dim>& data, const std::vector<Contact<Dim>>& contacts,
           const std::function<double(const Vec3&)>& gap);

 private:
  bool any_ = false;            // face that holds along itself
  std::vector<double> shares_;  // over the nodes; empty: none
  std::vector<Index> nodes_;    // where it is not 0
};

}  // namespace lapilli
