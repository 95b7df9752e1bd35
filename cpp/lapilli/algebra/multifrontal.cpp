#include "lapilli/algebra/multifrontal.hpp"

#include <algorithm>

#include "lapilli/core/interruption.hpp"
#include "lapilli/core/parallel.hpp"

namespace lapilli {
namespace {

/// Eliminate the first `own` unknowns of a symmetric matrix given by its lower triangle: their
/// columns become L, the diagonal D, and the rest is left as it stands without them.
void eliminate_first(Eigen::MatrixXd& matrix, int own, double* pivots) {
  constexpr int block = 48;
  const auto size = static_cast<int>(matrix.rows());
  Eigen::MatrixXd scaled;
  for (int first = 0; first < own; first += block) {
    allow_interruption();
    const int width = std::min(block, own - first), after = first + width, rest = size - after;
    // Columns of the block, one by one.
    for (int column = first; column < after; ++column) {
      const double pivot = matrix(column, column);
      pivots[column] = pivot;
      const int below = after - column - 1;
      const auto scaled_column = matrix.col(column).segment(column + 1, below) / pivot;
      const Eigen::VectorXd factors = scaled_column;
      for (int j = 0; j < below; ++j) {
        matrix.col(column + 1 + j).segment(column + 1 + j, below - j) -=
            factors.segment(j, below - j) * (factors[j] * pivot);
      }
      matrix.col(column).segment(column + 1, below) = factors;
    }
    if (rest == 0) {
      continue;
    }
    // Rows below: L21 D = A21 L11^-T, then the Schur complement.
    auto corner = matrix.block(first, first, width, width);
    auto lower = matrix.block(after, first, rest, width);
    corner.triangularView<Eigen::UnitLower>().transpose().solveInPlace<Eigen::OnTheRight>(lower);
    scaled = lower;
    for (int column = 0; column < width; ++column) {
      lower.col(column) /= pivots[first + column];
    }
    matrix.bottomRightCorner(rest, rest).triangularView<Eigen::Lower>() -=
        scaled * lower.transpose();
  }
}

}  // namespace

void Multifrontal::analyse(const SparseMatrix& lower, std::span<const int> part_start) {
  const auto parts = static_cast<int>(part_start.size()) - 1;
  fronts_.assign(parts, {});
  std::vector<int> part_of(lower.rows());
  for (int part = 0; part < parts; ++part) {
    std::fill(part_of.begin() + part_start[part], part_of.begin() + part_start[part + 1], part);
  }
  std::vector<int> height(parts, 0), seen(lower.rows(), -1);
  for (int part = 0; part < parts; ++part) {
    allow_interruption();
    Front& front = fronts_[part];
    front.begin = part_start[part];
    front.own = part_start[part + 1] - front.begin;
    const int end = part_start[part + 1];
    const auto reach = [&](int row) {
      if (row >= end && seen[row] != part) {
        seen[row] = part;
        front.border.push_back(row);
      }
    };
    for (int column = front.begin; column < end; ++column) {
      for (SparseMatrix::InnerIterator entry(lower, column); entry; ++entry) {
        reach(static_cast<int>(entry.row()));
      }
    }
    for (int child : front.children) {
      std::for_each(fronts_[child].border.begin(), fronts_[child].border.end(), reach);
      height[part] = std::max(height[part], height[child] + 1);
    }
    std::sort(front.border.begin(), front.border.end());
    if (!front.border.empty()) {
      fronts_[part_of[front.border.front()]].children.push_back(part);
    }
  }
  levels_.clear();
  for (int part = 0; part < parts; ++part) {
    levels_.resize(std::max<std::size_t>(levels_.size(), height[part] + 1));
    levels_[height[part]].push_back(part);
  }
  pivots_.resize(lower.rows());
}

void Multifrontal::factorise(const SparseMatrix& lower) {
  update_.assign(fronts_.size(), {});
  for (const std::vector<int>& level : levels_) {
    parallel_tasks(static_cast<Index>(level.size()), [&](Index k) {
      Front& front = fronts_[level[k]];
      Eigen::MatrixXd& matrix = update_[level[k]];
      build(lower, front, matrix);
      for (int child : front.children) {
        update_[child] = {};
      }
      eliminate(front, matrix);
    });
  }
  update_.clear();
}

/// The front's matrix: its own columns, and what its children left, in their order.
void Multifrontal::build(const SparseMatrix& lower, Front& front, Eigen::MatrixXd& matrix) const {
  const auto border = static_cast<int>(front.border.size()), size = front.own + border;
  matrix.setZero(size, size);
  const auto place = [&](int unknown) {
    if (unknown < front.begin + front.own) {
      return unknown - front.begin;
    }
    const auto at = std::lower_bound(front.border.begin(), front.border.end(), unknown);
    return front.own + static_cast<int>(at - front.border.begin());
  };
  for (int column = 0; column < front.own; ++column) {
    for (SparseMatrix::InnerIterator entry(lower, front.begin + column); entry; ++entry) {
      matrix(place(static_cast<int>(entry.row())), column) += entry.value();
    }
  }
  std::vector<int> places;
  for (int child : front.children) {
    const std::vector<int>& unknowns = fronts_[child].border;
    places.resize(unknowns.size());
    std::transform(unknowns.begin(), unknowns.end(), places.begin(), place);
    const Eigen::MatrixXd& left = update_[child];
    for (std::size_t j = 0; j < places.size(); ++j) {
      const double* from = left.data() + static_cast<Index>(j) * left.rows();
      double* to = matrix.data() + static_cast<Index>(places[j]) * size;
      for (std::size_t i = j; i < places.size(); ++i) {
        to[places[i]] += from[i];
      }
    }
  }
}

void Multifrontal::eliminate(Front& front, Eigen::MatrixXd& matrix) {
  eliminate_first(matrix, front.own, pivots_.data() + front.begin);
  front.panel = matrix.leftCols(front.own);
  const auto border = static_cast<int>(front.border.size());
  matrix = Eigen::MatrixXd(matrix.bottomRightCorner(border, border));
}

Eigen::VectorXd Multifrontal::solve(const Eigen::VectorXd& right_side) const {
  Eigen::VectorXd x = right_side, border;
  for (const Front& front : fronts_) {
    auto own = x.segment(front.begin, front.own);
    front.panel.topRows(front.own).triangularView<Eigen::UnitLower>().solveInPlace(own);
    border.noalias() = front.panel.bottomRows(static_cast<Index>(front.border.size())) * own;
    for (std::size_t k = 0; k < front.border.size(); ++k) {
      x[front.border[k]] -= border[static_cast<Index>(k)];
    }
  }
  x.array() /= pivots_.array();
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    auto own = x.segment(front->begin, front->own);
    border.resize(static_cast<Index>(front->border.size()));
    for (std::size_t k = 0; k < front->border.size(); ++k) {
      border[static_cast<Index>(k)] = x[front->border[k]];
    }
    own.noalias() -= front->panel.bottomRows(border.size()).transpose() * border;
    front->panel.topRows(front->own)
        .triangularView<Eigen::UnitLower>()
        .transpose()
        .solveInPlace(own);
  }
  return x;
}

Index Multifrontal::entries() const {
  Index sum = 0;
  for (const Front& front : fronts_) {
    sum += front.panel.size();
  }
  return sum;
}

}  // namespace lapilli
