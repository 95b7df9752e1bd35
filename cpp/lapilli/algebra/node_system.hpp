#pragma once

#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "lapilli/algebra/nested_dissection.hpp"
#include "lapilli/geometry/cell_box.hpp"

namespace lapilli {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

/// The symmetric matrix of the nodes that carry stiffness: its lower triangle, with nodes numbered
/// in the order in which a direct solver eliminates them. Unknown `Dim * row + axis` belongs to
/// node `nodes()[row]`.
template <int Dim>
class NodeSystem {
 public:
  /// Lay out the matrix for couplings within each of `boxes` (any order, repeats allowed). Returns
  /// whether anything changed; if not, numbering and pattern stand.
  bool lay_out(const Grid<Dim>& grid, std::vector<CellBox<Dim>> boxes);

  /// Where each part of the elimination begins in the unknowns, with the end of the last.
  std::span<const int> part_start() const { return part_start_; }

  Index unknowns() const { return Dim * static_cast<Index>(nodes_.size()); }
  std::span<const Index> nodes() const { return nodes_; }
  /// Row of a grid node, -1 if it carries nothing.
  int row(Index node) const { return row_[node]; }
  /// Rows of the nodes of a box; `rows` has room for them.
  void rows(const Grid<Dim>& grid, const CellBox<Dim>& box, int* rows) const {
    for_each_node(grid, box, [&](int k, Index node) { rows[k] = row_[node]; });
  }

  void clear() { std::fill_n(lower_.valuePtr(), lower_.nonZeros(), 0.0); }
  /// Add a symmetric matrix of the unknowns of `count` nodes, node by node; only its pairs are read
  /// that fall in the lower triangle.
  void add(const int* rows, int count, const double* matrix);

  /// Take unknowns whose diagonal is below `least` out of the system: nodes that only a wall
  /// reaches have no stiffness along it. Their rows become `pivot` times the identity.
  void drop_unknowns(double least, double pivot);
  bool is_dropped(Index unknown) const { return dropped_[unknown]; }

  const SparseMatrix& lower() const { return lower_; }

 private:
  NodeGraph couple(const Grid<Dim>& grid);
  void number(const Grid<Dim>& grid, NodeGraph graph);

  std::vector<CellBox<Dim>> boxes_;
  std::vector<Index> nodes_;
  std::vector<int> row_;      // of every grid node
  std::vector<Index> start_;  // of the rows below and on the diagonal of each node
  std::vector<int> below_;    //
  std::vector<int> part_start_;
  SparseMatrix lower_;
  std::vector<char> dropped_;
};

}  // namespace lapilli
