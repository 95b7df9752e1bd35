#pragma once

#include <array>
#include <string>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/geometry/grid.hpp"

namespace lapilli {

/// The nodes that bodies which move as one share: a window of the grid, and its place in the nodal
/// arrays.
template <int Dim>
struct NodeField {
  Grid<Dim> grid;
  std::array<int, Dim> corner{};  // which node of the whole grid its first node is
  Index offset = 0;               // of its first node in the nodal arrays

  Index end() const { return offset + grid.node_count(); }
};

/// Velocity fields of the nodes. Bodies in contact have one each, so that a node near both carries
/// two velocities; a window around a field's points holds all of its nodes. Bodies that are one, or
/// bonded, share one, and a scene without contact has the whole grid for its only field.
template <int Dim>
class NodeFields {
 public:
  explicit NodeFields(const Grid<Dim>& grid);

  /// Give every body the field of this number, counted from 0.
  void split(std::vector<int> field_of_body);
  /// Put the windows around the points; they hold while no point drifts farther than a cell.
  void place(const Points& points);

  bool is_single() const { return fields_.size() == 1; }
  int count() const { return static_cast<int>(fields_.size()); }
  const NodeField<Dim>& operator[](int field) const { return fields_[field]; }
  int index_of(Index body) const { return is_single() ? 0 : field_of_body_[body]; }
  const NodeField<Dim>& of_body(Index body) const { return fields_[index_of(body)]; }
  /// Number that a node of the whole grid has in a field; below 0: outside of its window.
  Index node_in(int field, Index node) const;
  Index node_count() const { return fields_.back().end(); }  // of all

  /// Call action(field, begin, end) for runs of rows [begin, end) whose points have one field.
  /// `body`: of every row.
  template <class Action>
  void for_each_run(const Index* body, Index begin, Index end, const Action& action) const {
    if (is_single()) {
      action(fields_.front(), begin, end);
      return;
    }
    for (Index first = begin; first < end;) {
      const int field = field_of_body_[body[first]];
      Index last = first + 1;
      while (last < end && field_of_body_[body[last]] == field) {
        ++last;
      }
      action(fields_[field], first, last);
      first = last;
    }
  }

  void save(Archive& archive, const std::string& name) const;
  void load(const Archive& archive, const std::string& name);

 private:
  void set_window(int field, const std::array<int, Dim>& lowest, const std::array<int, Dim>& cells);

  Grid<Dim> whole_;
  std::vector<int> field_of_body_;
  std::vector<NodeField<Dim>> fields_;
};

}  // namespace lapilli
