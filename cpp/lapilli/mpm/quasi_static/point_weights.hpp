#pragma once

#include <span>
#include <vector>

#include "lapilli/geometry/cell_box.hpp"

namespace lapilli {

/// Shape functions of all material points at the nodes their domains reach, and the points grouped
/// by the box of cells they touch, so that assembly works on one small matrix a group.
template <int Dim>
class PointWeights {
 public:
  /// Points of one box: rows order()[begin .. end).
  struct Group {
    CellBox<Dim> box;
    Index begin = 0, end = 0;
  };

  /// Linear shape functions of points at `position` (rows x Dim, m), or GIMP with one half-width
  /// (m) a point and axis when `half_width` is not empty (rows x Dim). Throws RunError when a point
  /// lies outside the grid.
  void build(const Grid<Dim>& grid, std::span<const double> position,
             std::span<const double> half_width);

  Index size() const { return static_cast<Index>(box_.size()); }
  const CellBox<Dim>& box(Index point) const { return box_[point]; }
  int node_count(Index point) const { return static_cast<int>(start_[point + 1] - start_[point]); }
  const double* value(Index point) const { return value_.data() + start_[point]; }
  const Vec<Dim>* gradient(Index point) const { return gradient_.data() + start_[point]; }

  std::span<const Group> groups() const { return groups_; }
  std::span<const Index> order() const { return order_; }

  /// Call body(group) for every group, in parallel; groups that share a node run one after the
  /// other in fixed order, so sums into nodes are the same bytes for any number of threads.
  template <class Body>
  void for_each_group(const Body& body) const;

 private:
  void evaluate_linear(const Grid<Dim>& grid, std::span<const double> position);
  void evaluate_gimp(const Grid<Dim>& grid, std::span<const double> position,
                     std::span<const double> half_width);
  void group_by_box(const Grid<Dim>& grid);

  std::vector<CellBox<Dim>> box_;
  std::vector<Index> start_;
  std::vector<double> value_;
  std::vector<Vec<Dim>> gradient_;
  std::vector<Index> order_;
  std::vector<Group> groups_;
  std::vector<Index> bundle_start_;          // groups with the same first cell
  std::vector<std::vector<Index>> colours_;  // bundles without common nodes
};

}  // namespace lapilli

#include "lapilli/core/parallel.hpp"

namespace lapilli {

template <int Dim>
template <class Body>
void PointWeights<Dim>::for_each_group(const Body& body) const {
  constexpr Index chunk = 32;
  for (const std::vector<Index>& bundles : colours_) {
    const Index count = static_cast<Index>(bundles.size());
    parallel_tasks((count + chunk - 1) / chunk, [&](Index task) {
      for (Index k = task * chunk; k < std::min(count, (task + 1) * chunk); ++k) {
        for (Index g = bundle_start_[bundles[k]]; g < bundle_start_[bundles[k] + 1]; ++g) {
          body(groups_[g]);
        }
      }
    });
  }
}

}  // namespace lapilli
