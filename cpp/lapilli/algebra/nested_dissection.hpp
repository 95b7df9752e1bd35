#pragma once

#include <array>
#include <span>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Who is coupled to whom: neighbours of node k are neighbour[start[k] .. start[k + 1]), sorted,
/// k itself included.
struct NodeGraph {
  std::vector<Index> start;
  std::vector<int> neighbour;

  int size() const { return static_cast<int>(start.size()) - 1; }
  std::span<const int> of(int node) const {
    return {neighbour.data() + start[node], neighbour.data() + start[node + 1]};
  }
};

/// An order of elimination: nodes, and where each part that is eliminated at once begins in it
/// (with the end of the last).
struct Elimination {
  std::vector<int> order;
  std::vector<int> part_start;
};

/// Order of elimination for grid nodes: the grid is cut in halves along its longest side, the nodes
/// of the cut come last, and each half is cut again (George 1973). `place` holds the integer
/// coordinates of each node; the graph may couple any of them, but the order is good only when
/// couplings are short.
Elimination nested_dissection(const NodeGraph& graph, std::span<const std::array<int, 3>> place);

}  // namespace lapilli
