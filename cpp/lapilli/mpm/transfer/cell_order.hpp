#pragma once

#include <type_traits>
#include <utility>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/geometry/grid.hpp"

namespace lapilli {

/// Keeps the points sorted by the lowest node they touch and cut in strips: a few layers of nodes
/// across the slowest axis. Two strips of the same parity never share a node, not even after their
/// points have drifted one layer out of them, so a scatter over even strips and then odd ones has a
/// fixed order for any number of threads.
template <int Dim>
class CellOrder {
 public:
  /// `support`: nodes an axis of the shape function, 2 or 3.
  CellOrder(const Grid<Dim>& grid, int support);

  /// Check every point; sort as soon as one has drifted more than a layer out of its strip.
  /// Throws RunError naming a point that left the grid or is not finite.
  void update(Points& points);

  /// Sort in any case; every point must lie inside the grid.
  void sort(Points& points);

  /// Whether no point has been removed since the last sort.
  bool covers(const Points& points) const { return begin_.back() == points.size(); }

  Index strip_count() const { return static_cast<Index>(begin_.size()) - 1; }

  /// Call body(begin, end), or body(begin, end, strip), for the rows of every strip: even strips in
  /// parallel, then odd ones.
  template <class Body>
  void for_each_strip(const Body& body) const {
    for (Index parity = 0; parity < 2; ++parity) {
      parallel_tasks((strip_count() + 1 - parity) / 2, [&](Index task) {
        const Index strip = 2 * task + parity;
        if (begin_[strip] == begin_[strip + 1]) {
          return;
        }
        if constexpr (std::is_invocable_v<const Body&, Index, Index, Index>) {
          body(begin_[strip], begin_[strip + 1], strip);
        } else {
          body(begin_[strip], begin_[strip + 1]);
        }
      });
    }
  }

  /// First and one-past-last layer of nodes that any point can touch, a row of four included.
  std::pair<int, int> node_layers() const;

  void save(Archive& archive, const std::string& name) const;
  void load(const Archive& archive, const std::string& name);

 private:
  bool still_valid(const Points& points) const;
  /// How far, in cells, the lowest node of a point lies below its cell.
  double shift() const { return support_ == 3 ? 0.5 : 0.0; }

  Grid<Dim> grid_;
  int support_;
  int layers_;                          // of a strip
  std::vector<Index> begin_;            // first row of each strip, and one past the last
  Index version_ = -1, ordering_ = -1;  // of the points that were checked last
};

/// Throws RunError naming the first point (by id) outside the grid or not finite.
template <int Dim>
void require_inside(const Grid<Dim>& grid, const Points& points);

}  // namespace lapilli
