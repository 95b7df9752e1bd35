#include "lapilli/algebra/symmetric_factor.hpp"

namespace lapilli {

void SymmetricFactor::analyse(const SparseMatrix& matrix,
                              std::span<const std::array<int, 3>> place) {
  const int size = static_cast<int>(matrix.cols());
  NodeGraph graph;
  graph.start.assign(matrix.outerIndexPtr(), matrix.outerIndexPtr() + size + 1);
  graph.neighbour.assign(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros());
  Elimination elimination = nested_dissection(graph, place);
  order_ = std::move(elimination.order);
  std::vector<int> rank(static_cast<std::size_t>(size));
  for (int k = 0; k < size; ++k) {
    rank[order_[k]] = k;
  }
  // The numbers of entries are ordered along with them.
  lower_.resize(size, size);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(matrix.nonZeros() / 2 + size));
  for (int column = 0; column < size; ++column) {
    for (int k = matrix.outerIndexPtr()[column]; k < matrix.outerIndexPtr()[column + 1]; ++k) {
      const int row = matrix.innerIndexPtr()[k];
      if (rank[row] >= rank[column]) {
        entries.emplace_back(rank[row], rank[column], static_cast<double>(k));
      }
    }
  }
  lower_.setFromTriplets(entries.begin(), entries.end());
  entry_of_.resize(static_cast<std::size_t>(lower_.nonZeros()));
  for (Index k = 0; k < lower_.nonZeros(); ++k) {
    entry_of_[k] = static_cast<Index>(lower_.valuePtr()[k]);
  }
  solver_.analyse(lower_, elimination.part_start);
}

PivotReport SymmetricFactor::factorise(const SparseMatrix& matrix) {
  for (std::size_t k = 0; k < entry_of_.size(); ++k) {
    lower_.valuePtr()[k] = matrix.valuePtr()[entry_of_[k]];
  }
  return solver_.factorise(lower_);
}

Eigen::VectorXd SymmetricFactor::solve(const Eigen::VectorXd& right_side) const {
  Eigen::VectorXd ordered(right_side.size()), solution(right_side.size());
  for (std::size_t k = 0; k < order_.size(); ++k) {
    ordered[static_cast<Index>(k)] = right_side[order_[k]];
  }
  ordered = solver_.solve(ordered);
  for (std::size_t k = 0; k < order_.size(); ++k) {
    solution[order_[k]] = ordered[static_cast<Index>(k)];
  }
  return solution;
}

}  // namespace lapilli
