#include "lapilli/geometry/weld.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>

namespace lapilli {
namespace {

// Vertices by the cells of a grid as fine as the tolerance, so that those near a place lie in the
// cells around it.
class Vertices {
 public:
  Vertices(std::vector<Vec3>& vertices, double tolerance)
      : vertices_(vertices), tolerance_(tolerance) {}

  int number_of(const Vec3& at) {
    const auto [entry, is_new] = known_.try_emplace({at[0], at[1], at[2]}, 0);
    if (is_new) {
      const int near = tolerance_ > 0.0 ? nearest(at) : -1;
      entry->second = near >= 0 ? near : append(at);
    }
    return entry->second;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  struct Hash {
    std::size_t operator()(const Cell& cell) const {
      std::uint64_t mixed = 0;
      for (const std::int64_t index : cell) {
        mixed = (mixed ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15ULL;
        mixed ^= mixed >> 29;
      }
      return mixed;
    }
  };

  Cell cell_of(const Vec3& at) const {
    Cell cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      cell[axis] = static_cast<std::int64_t>(std::floor(at[static_cast<int>(axis)] / tolerance_));
    }
    return cell;
  }

  int nearest(const Vec3& at) const {
    int best = -1;
    double least = tolerance_ * tolerance_;
    const Cell middle = cell_of(at);
    for (int k = 0; k < 27; ++k) {
      const Cell cell{middle[0] + k % 3 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k / 9 - 1};
      const auto found = in_cell_.find(cell);
      if (found == in_cell_.end()) {
        continue;
      }
      for (const int vertex : found->second) {
        const double squared = (vertices_[static_cast<std::size_t>(vertex)] - at).squaredNorm();
        if (squared < least) {
          least = squared;
          best = vertex;
        }
      }
    }
    return best;
  }

  int append(const Vec3& at) {
    const int number = static_cast<int>(vertices_.size());
    vertices_.push_back(at);
    if (tolerance_ > 0.0) {
      in_cell_[cell_of(at)].push_back(number);
    }
    return number;
  }

  std::vector<Vec3>& vertices_;
  double tolerance_;
  std::map<std::array<double, 3>, int> known_;
  std::unordered_map<Cell, std::vector<int>, Hash> in_cell_;
};

}  // namespace

Triangles welded(const std::vector<std::array<Vec3, 3>>& triangles, double tolerance) {
  Triangles all;
  Vertices vertices(all.vertices, tolerance);
  all.rows.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    const int first = vertices.number_of(a), second = vertices.number_of(b);
    all.rows.push_back({first, second, vertices.number_of(c)});
  }
  return all;
}

}  // namespace lapilli
