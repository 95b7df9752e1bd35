#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "lapilli/algebra/node_rows.hpp"
#include "lapilli/core/large_array.hpp"
#include "lapilli/core/parallel.hpp"

namespace lapilli {

/// A symmetric matrix whose rows add up to zero and couple every node with those at most `reach`
/// away along each axis. Most rows are alike: nodes deep inside one body share their coefficients,
/// the others have a row of their own.
///
/// Products are sums over differences, sum of a_ij (x_j - x_i): nothing comes from nothing, and
/// what is even stays so to the last bit.
template <int Dim>
class SharedStencil {
 public:
  using Step = std::array<int, Dim>;
  static constexpr int own = -1, nobody = -2;

  /// `kind` by place: the number of a shared row, `own` or `nobody`. Coefficients are zero at
  /// first.
  SharedStencil(const NodeRows<Dim>& rows, std::vector<int> kind, int shared);

  int kind(Index place) const { return kind_[place]; }
  /// Set the coefficient of a shared row towards the neighbour `step` away, and its mirror image.
  void share(int which, const Step& step, double value);
  /// Add to the coefficient between the nodes at `place` and, `step` later, at `other`; rows that
  /// are shared stay.
  void add(Index place, Index other, const Step& step, double value);
  /// Let rows of their own take over what neighbours with a shared row say. Call before use.
  void agree();

  /// Call body(place, product) over all rows, in blocks: product is a std::array of matrix x from
  /// `place` on.
  template <class Body>
  void multiply(const double* x, const Body& body) const;

  /// The lower triangle and diagonal as a sparse matrix; `number` numbers the places (-1: left
  /// out, with what they are coupled by).
  void append_triplets(std::span<const Index> number, double scale,
                       std::vector<Eigen::Triplet<double>>& triplets) const;

 private:
  // Slots: later neighbours on the same grid row, then row by row, then their mirror images.
  struct Run {
    Index place;
    int count, kind;
    Index base;  // of the coefficients of rows of their own
  };
  struct RowRuns {
    std::size_t first, last;  // runs
  };

  static constexpr int most_rows = Dim == 1 ? 1 : Dim == 2 ? 2 : 12;  // pairs of other grid rows
  struct Distances {
    std::array<Index, most_rows> up, down;
  };

  int slot(const Step& step) const;  // of a later neighbour
  Index neighbour(const typename NodeRows<Dim>::Row& row, Index place, int slot) const;
  Distances distances(const typename NodeRows<Dim>::Row& row) const;
  /// How many rows of their own are stored side by side from `count` on.
  static constexpr int lanes(int count) {
    return count >= 8 ? 8 : count >= 4 ? 4 : count >= 2 ? 2 : 1;
  }

  template <int Reach, class Body>
  void multiply_rows(const double* x, std::size_t begin, std::size_t end, const Body& body) const;
  template <int Reach, int Lanes>
  std::array<double, Lanes> shared_block(const double* at, const double* c,
                                         const Distances& away) const;
  template <int Reach, int Lanes>
  std::array<double, Lanes> own_block(const double* at, const double* c,
                                      const Distances& away) const;

  const NodeRows<Dim>* rows_;
  int reach_, half_;        // slots of later neighbours
  std::vector<Index> far_;  // grid rows away, by pair
  std::vector<int> kind_;   // by place
  std::vector<RowRuns> row_runs_;
  std::vector<Run> runs_;
  std::vector<Index> address_;         // by place: where its first coefficient stands
  std::vector<unsigned char> stride_;  // by place: coefficients from slot to slot
  std::vector<double> shared_;         // by kind and slot, later neighbours only
  LargeArray<double> own_;
  Index row_of_task_ = 1;
  bool pays_threads_ = false;
};

template <int Dim>
template <int Reach, int Lanes>
std::array<double, Lanes> SharedStencil<Dim>::shared_block(const double* at, const double* c,
                                                           const Distances& away) const {
  using Some = Eigen::Array<double, Lanes, 1>;
  using At = Eigen::Map<const Some>;
  Some sum = Some::Zero();
  const Some twice = 2.0 * At(at);
  const auto add = [&](const double* up, const double* down, double factor) {
    sum += factor * ((At(up) + At(down)) - twice);
  };
  for (int i = 1; i <= Reach; ++i) {
    add(at + i, at - i, *c++);
  }
  for (std::size_t pair = 0; pair < far_.size(); ++pair) {
    const double *up = at + away.up[pair], *down = at + away.down[pair];
    for (int i = -Reach; i <= Reach; ++i) {
      add(up + i, down - i, *c++);
    }
  }
  std::array<double, Lanes> product;
  Eigen::Map<Some>(product.data()) = sum;
  return product;
}

template <int Dim>
template <int Reach, int Lanes>
std::array<double, Lanes> SharedStencil<Dim>::own_block(const double* at, const double* c,
                                                        const Distances& away) const {
  using Some = Eigen::Array<double, Lanes, 1>;
  using At = Eigen::Map<const Some>;
  Some sum = Some::Zero();
  const Some here = At(at);
  const double* mirrored = c + static_cast<Index>(half_) * Lanes;
  const auto add = [&](const double* up, const double* down) {
    sum += At(c) * (At(up) - here) + At(mirrored) * (At(down) - here);
    c += Lanes;
    mirrored += Lanes;
  };
  for (int i = 1; i <= Reach; ++i) {
    add(at + i, at - i);
  }
  for (std::size_t pair = 0; pair < far_.size(); ++pair) {
    const double *up = at + away.up[pair], *down = at + away.down[pair];
    for (int i = -Reach; i <= Reach; ++i) {
      add(up + i, down - i);
    }
  }
  std::array<double, Lanes> product;
  Eigen::Map<Some>(product.data()) = sum;
  return product;
}

template <int Dim>
template <int Reach, class Body>
void SharedStencil<Dim>::multiply_rows(const double* x, std::size_t begin, std::size_t end,
                                       const Body& body) const {
  for (std::size_t r = begin; r < end; ++r) {
    const Distances away = distances(rows_->rows()[r]);
    for (std::size_t k = row_runs_[r].first; k < row_runs_[r].last; ++k) {
      const Run& run = runs_[k];
      const double* c = run.kind >= 0 ? shared_.data() + run.kind * half_ : own_.data() + run.base;
      Index place = run.place;
      const auto blocks = [&](auto width) {
        constexpr int Lanes = decltype(width)::value;
        for (; run.place + run.count - place >= Lanes; place += Lanes) {
          if (run.kind >= 0) {
            body(place, shared_block<Reach, Lanes>(x + place, c, away));
          } else {
            body(place, own_block<Reach, Lanes>(x + place, c, away));
            c += 2 * static_cast<Index>(half_) * Lanes;
          }
        }
      };
      blocks(std::integral_constant<int, 8>{});
      blocks(std::integral_constant<int, 4>{});
      blocks(std::integral_constant<int, 2>{});
      blocks(std::integral_constant<int, 1>{});
    }
  }
}

template <int Dim>
template <class Body>
void SharedStencil<Dim>::multiply(const double* x, const Body& body) const {
  const auto rows = static_cast<Index>(row_runs_.size());
  const auto some = [&](Index begin, Index end) {
    const auto first = static_cast<std::size_t>(begin), last = static_cast<std::size_t>(end);
    if (reach_ == 1) {
      multiply_rows<1>(x, first, last, body);
    } else {
      multiply_rows<2>(x, first, last, body);
    }
  };
  if (!pays_threads_) {
    some(0, rows);
    return;
  }
  parallel_runs((rows + row_of_task_ - 1) / row_of_task_, [&](Index task) {
    some(task * row_of_task_, std::min(rows, (task + 1) * row_of_task_));
  });
}

}  // namespace lapilli
