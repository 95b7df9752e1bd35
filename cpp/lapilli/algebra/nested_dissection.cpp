#include "lapilli/algebra/nested_dissection.hpp"

#include <algorithm>
#include <numeric>

namespace lapilli {
namespace {

constexpr std::size_t smallest_part = 24;  // nodes; smaller sets are eliminated as they come

class Dissection {
 public:
  Dissection(const NodeGraph& graph, std::span<const std::array<int, 3>> place)
      : graph_(graph), place_(place), part_(place.size(), 0) {
    elimination_.order.reserve(place.size());
    elimination_.part_start.push_back(0);
  }

  void cut(std::vector<int> nodes) {
    if (nodes.size() <= smallest_part) {
      finish(nodes);
      return;
    }
    const int axis = longest_axis(nodes);
    const int middle = separating_plane(nodes, axis);
    const int mark = ++marks_;
    std::vector<int> left, right, separator;
    for (int node : nodes) {
      const int at = place_[node][axis];
      (at < middle ? left : at > middle ? right : separator).push_back(node);
      if (at > middle) {
        part_[node] = mark;
      }
    }
    if (left.empty() || right.empty()) {
      finish(nodes);
      return;
    }
    // Couplings that jump over the plane: their left ends join the separator.
    std::erase_if(left, [&](int node) {
      const auto neighbours = graph_.of(node);
      const bool jumps = std::any_of(neighbours.begin(), neighbours.end(),
                                     [&](int other) { return part_[other] == mark; });
      if (jumps) {
        separator.push_back(node);
      }
      return jumps;
    });
    nodes = {};
    cut(std::move(left));
    cut(std::move(right));
    finish(separator);
  }

  Elimination take() { return std::move(elimination_); }

 private:
  int longest_axis(const std::vector<int>& nodes) const {
    std::array<int, 3> low = place_[nodes[0]], high = low;
    for (int node : nodes) {
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], place_[node][axis]);
        high[axis] = std::max(high[axis], place_[node][axis]);
      }
    }
    int longest = 0;
    for (int axis = 1; axis < 3; ++axis) {
      if (high[axis] - low[axis] > high[longest] - low[longest]) {
        longest = axis;
      }
    }
    return longest;
  }

  /// Among the planes that leave at least 2/5 on either side, the one with the fewest nodes.
  int separating_plane(const std::vector<int>& nodes, int axis) const {
    const auto [low, high] = std::minmax_element(nodes.begin(), nodes.end(), [&](int a, int b) {
      return place_[a][axis] < place_[b][axis];
    });
    const int first = place_[*low][axis];
    std::vector<std::size_t> count(static_cast<std::size_t>(place_[*high][axis] - first + 1), 0);
    for (int node : nodes) {
      ++count[place_[node][axis] - first];
    }
    std::size_t below = 0, best = 0, best_cost = nodes.size() + 1;
    for (std::size_t k = 0; k < count.size(); ++k) {
      const std::size_t above = nodes.size() - below - count[k];
      // Imbalance counts a little, so that equal planes are cut in the middle.
      const std::size_t imbalance = below > above ? below - above : above - below;
      const std::size_t cost = count[k] + imbalance / 16;
      if (count[k] > 0 && 5 * std::min(below, above) >= nodes.size() && cost < best_cost) {
        best = k;
        best_cost = cost;
      }
      below += count[k];
    }
    if (best_cost > nodes.size()) {
      std::size_t half = 0;
      while (half + count[best] < nodes.size() / 2) {
        half += count[best++];
      }
    }
    return first + static_cast<int>(best);
  }

  void finish(const std::vector<int>& nodes) {
    if (nodes.empty()) {
      return;
    }
    elimination_.order.insert(elimination_.order.end(), nodes.begin(), nodes.end());
    elimination_.part_start.push_back(static_cast<int>(elimination_.order.size()));
  }

  const NodeGraph& graph_;
  std::span<const std::array<int, 3>> place_;
  std::vector<int> part_;
  int marks_ = 0;
  Elimination elimination_;
};

}  // namespace

Elimination nested_dissection(const NodeGraph& graph, std::span<const std::array<int, 3>> place) {
  Dissection dissection(graph, place);
  std::vector<int> all(place.size());
  std::iota(all.begin(), all.end(), 0);
  if (!all.empty()) {
    dissection.cut(std::move(all));
  }
  return dissection.take();
}

}  // namespace lapilli
