#pragma once

#include <array>
#include <span>
#include <vector>

#include "lapilli/geometry/grid.hpp"

namespace lapilli {

/// Storage for the active nodes of a grid, row by row (a row runs along the first axis), padded so
/// that every neighbour within `reach` of an active node has a place. Memory follows the body, not
/// the grid around it; within a row and between two rows the distance of neighbours is constant.
template <int Dim>
class NodeRows {
 public:
  struct Row {
    Index grid_row;  // number of the row in the grid
    int begin, end;  // active span along the first axis; may be empty
    Index shift;     // place of node (i, row) is shift + i
  };

  /// `active`: one flag a node of the grid.
  NodeRows(const Grid<Dim>& grid, std::span<const unsigned char> active, int reach);

  Index size() const { return size_; }
  const std::vector<Row>& rows() const { return rows_; }
  int reach() const { return reach_; }
  /// Grid rows in one layer of the grid (3D).
  Index rows_in_layer() const { return Dim == 3 ? grid_.nodes(1) : 0; }
  /// Place of a node of the grid that lies in reach of an active one.
  Index place(Index node) const {
    const Index row = node / grid_.nodes(0);
    return shift_[row] + (node - row * grid_.nodes(0));
  }
  /// Coordinates on the grid of active nodes, given by their places.
  std::vector<std::array<int, 3>> coordinates(std::span<const Index> places) const;
  /// Distance in places from nodes of `row` to their neighbours `rows_away` grid rows away.
  Index distance(const Row& row, Index rows_away) const {
    return shift_[row.grid_row + rows_away] - row.shift;
  }

 private:
  Grid<Dim> grid_;
  int reach_;
  Index size_ = 0;
  std::vector<Row> rows_;     // those with active nodes, in order
  std::vector<Index> shift_;  // by grid row
};

}  // namespace lapilli
