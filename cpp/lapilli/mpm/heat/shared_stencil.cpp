#include "lapilli/mpm/heat/shared_stencil.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

// Products of coefficients from which a second thread pays for being woken.
constexpr Index threads_from = 2'000'000;

}  // namespace

template <int Dim>
SharedStencil<Dim>::SharedStencil(const NodeRows<Dim>& rows, std::vector<int> kind, int shared)
    : rows_(&rows), reach_(rows.reach()), kind_(std::move(kind)) {
  const int width = 2 * reach_ + 1;
  require(reach_ == 1 || reach_ == 2, "a shared stencil reaches 1 or 2, got ", reach_);
  if constexpr (Dim == 2) {
    for (int j = 1; j <= reach_; ++j) {
      far_.push_back(j);
    }
  } else if constexpr (Dim == 3) {
    for (int k = 0; k <= reach_; ++k) {
      for (int j = k == 0 ? 1 : -reach_; j <= reach_; ++j) {
        far_.push_back(j + k * rows.rows_in_layer());
      }
    }
  }
  half_ = reach_ + width * static_cast<int>(far_.size());
  shared_.assign(static_cast<std::size_t>(shared * half_), 0.0);
  address_.assign(kind_.size(), -1);
  stride_.assign(kind_.size(), 0);
  Index stored = 0, nodes = 0;
  for (const auto& row : rows.rows()) {
    const std::size_t first = runs_.size();
    const Index end = row.shift + row.end;
    for (Index place = row.shift + row.begin; place < end;) {
      Index next = place + 1;
      while (next < end && kind_[next] == kind_[place]) {
        ++next;
      }
      if (kind_[place] != nobody) {
        nodes += next - place;
        runs_.push_back({place, static_cast<int>(next - place), kind_[place], stored});
      }
      while (place < next && kind_[place] == own) {
        const int side = lanes(static_cast<int>(next - place));
        for (int k = 0; k < side; ++k) {
          address_[place + k] = stored + k;
          stride_[place + k] = static_cast<unsigned char>(side);
        }
        stored += 2 * half_ * side;
        place += side;
      }
      place = next;
    }
    row_runs_.push_back({first, runs_.size()});
  }
  own_.assign(static_cast<std::size_t>(stored), 0.0);
  pays_threads_ = nodes * 2 * half_ >= threads_from;
  row_of_task_ = std::max<Index>(
      1, piece_rows * static_cast<Index>(row_runs_.size()) / std::max<Index>(1, nodes));
}

template <int Dim>
int SharedStencil<Dim>::slot(const Step& step) const {
  Index away = 0;
  if constexpr (Dim == 2) {
    away = step[1];
  } else if constexpr (Dim == 3) {
    away = step[1] + step[2] * rows_->rows_in_layer();
  }
  if (away == 0) {
    return step[0] - 1;
  }
  const auto pair = std::find(far_.begin(), far_.end(), away) - far_.begin();
  return reach_ + static_cast<int>(pair) * (2 * reach_ + 1) + step[0] + reach_;
}

template <int Dim>
typename SharedStencil<Dim>::Distances SharedStencil<Dim>::distances(
    const typename NodeRows<Dim>::Row& row) const {
  Distances away{};
  for (std::size_t pair = 0; pair < far_.size(); ++pair) {
    away.up[pair] = rows_->distance(row, far_[pair]);
    away.down[pair] = rows_->distance(row, -far_[pair]);
  }
  return away;
}

template <int Dim>
Index SharedStencil<Dim>::neighbour(const typename NodeRows<Dim>::Row& row, Index place,
                                    int slot) const {
  const bool mirrored = slot >= half_;
  const int later = mirrored ? slot - half_ : slot;
  if (later < reach_) {
    return mirrored ? place - later - 1 : place + later + 1;
  }
  const int pair = (later - reach_) / (2 * reach_ + 1);
  const int along = (later - reach_) % (2 * reach_ + 1) - reach_;
  return mirrored ? place + rows_->distance(row, -far_[pair]) - along
                  : place + rows_->distance(row, far_[pair]) + along;
}

template <int Dim>
void SharedStencil<Dim>::share(int which, const Step& step, double value) {
  shared_[static_cast<std::size_t>(which * half_ + slot(step))] = value;
}

template <int Dim>
void SharedStencil<Dim>::add(Index place, Index other, const Step& step, double value) {
  const int later = slot(step);
  if (kind_[place] == own) {
    own_[address_[place] + later * stride_[place]] += value;
  }
  if (kind_[other] == own) {
    own_[address_[other] + (half_ + later) * stride_[other]] += value;
  }
}

template <int Dim>
void SharedStencil<Dim>::agree() {
  for (std::size_t r = 0; r < row_runs_.size(); ++r) {
    const auto& row = rows_->rows()[r];
    for (std::size_t k = row_runs_[r].first; k < row_runs_[r].last; ++k) {
      const Run& run = runs_[k];
      for (Index place = run.place; run.kind == own && place < run.place + run.count; ++place) {
        for (int slot = 0; slot < 2 * half_; ++slot) {
          const Index other = neighbour(row, place, slot);
          if (other >= 0 && other < static_cast<Index>(kind_.size()) && kind_[other] >= 0) {
            own_[address_[place] + slot * stride_[place]] =
                shared_[static_cast<std::size_t>(kind_[other] * half_ + slot % half_)];
          }
        }
      }
    }
  }
}

template <int Dim>
void SharedStencil<Dim>::append_triplets(std::span<const Index> number, double scale,
                                         std::vector<Eigen::Triplet<double>>& triplets) const {
  for (std::size_t r = 0; r < row_runs_.size(); ++r) {
    const auto& row = rows_->rows()[r];
    for (std::size_t k = row_runs_[r].first; k < row_runs_[r].last; ++k) {
      const Run& run = runs_[k];
      for (Index place = run.place; place < run.place + run.count; ++place) {
        if (number[place] < 0) {
          continue;
        }
        double sum = 0.0;
        for (int slot = 0; slot < 2 * half_; ++slot) {
          const double value =
              run.kind >= 0 ? shared_[static_cast<std::size_t>(run.kind * half_ + slot % half_)]
                            : own_[address_[place] + slot * stride_[place]];
          if (value == 0.0) {
            continue;
          }
          const Index other = neighbour(row, place, slot);
          if (number[other] < 0) {
            continue;
          }
          sum -= value;
          if (number[other] < number[place]) {
            triplets.emplace_back(static_cast<int>(number[place]), static_cast<int>(number[other]),
                                  scale * value);
          }
        }
        triplets.emplace_back(static_cast<int>(number[place]), static_cast<int>(number[place]),
                              scale * sum);
      }
    }
  }
}

template class SharedStencil<1>;
template class SharedStencil<2>;
template class SharedStencil<3>;

}  // namespace lapilli
