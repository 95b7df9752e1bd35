#include "lapilli/mpm/heat/followers.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/symmetric_modes.hpp"
#include "lapilli/geometry/node_block.hpp"

namespace lapilli {
namespace {

constexpr double least_share = 0.01;  // of the volume of a full cell
constexpr int farthest = 4;           // cells to a leader

/// Weights of the straight line fitted to values at `offset`, taken at zero: nearest first by the
/// fourth power of the distance. Directions along which no two leaders differ have no slope.
template <int Dim>
std::vector<double> fitted_weights(const std::vector<Vec<Dim>>& offset, bool lines,
                                   bool& complete) {
  using Line = Eigen::Matrix<double, Dim + 1, 1>;
  using Normal = Eigen::Matrix<double, Dim + 1, Dim + 1>;
  Normal normal = Normal::Zero();
  std::vector<Line> basis;
  std::vector<double> pull;
  for (const Vec<Dim>& x : offset) {
    basis.emplace_back();
    basis.back() << 1.0, x;
    pull.push_back(1.0 / (x.squaredNorm() * x.squaredNorm()));
    normal += pull.back() * basis.back() * basis.back().transpose();
  }
  const SymmetricModes<Dim + 1> modes = symmetric_modes<Dim + 1>(normal);
  const double least = 1e-9 * modes.eigenvalues.maxCoeff();
  complete = modes.eigenvalues.minCoeff() > least;
  Line at_zero = Line::Zero();
  for (int k = 0; k <= Dim; ++k) {
    if (modes.eigenvalues[k] > least) {
      const Line mode = modes.eigenvectors.col(k);
      at_zero += mode[0] / modes.eigenvalues[k] * mode;
    }
  }
  std::vector<double> weights;
  double sum = 0.0;
  for (std::size_t k = 0; k < offset.size(); ++k) {
    weights.push_back(lines ? pull[k] * at_zero.dot(basis[k]) : pull[k]);
    sum += weights.back();
  }
  for (double& weight : weights) {
    weight /= sum;
  }
  return weights;
}

}  // namespace

template <int Dim>
Followers<Dim>::Followers(const Grid<Dim>& grid, const NodeRows<Dim>& rows,
                          std::span<const double> volume, std::span<const unsigned char> active,
                          bool lines)
    : number_(static_cast<std::size_t>(rows.size()), -1) {
  std::vector<unsigned char> leads(active.size(), 0);
  std::vector<Index> small;
  for (Index node = 0; node < grid.node_count(); ++node) {
    if (active[node] == 0) {
      continue;
    }
    double fullest = 0.0;
    if (volume[node] < least_share * grid.cell_volume()) {
      for_each_in_block<Dim>(grid, node, 2, [&](Index other, const Vec<Dim>&) {
        fullest = std::max(fullest, volume[other]);
      });
      fullest = std::min(fullest, grid.cell_volume());
    }
    leads[node] = volume[node] > 0.0 && volume[node] >= least_share * fullest;
    if (leads[node] == 0) {
      small.push_back(node);
    }
  }
  for (const Index node : small) {
    std::vector<Vec<Dim>> offset;
    std::vector<Index> leader;
    std::vector<double> weight;
    bool complete = false;
    for (int reach = 1; reach <= farthest && !complete; ++reach) {
      offset.clear();
      leader.clear();
      for_each_in_block<Dim>(grid, node, reach, [&](Index other, const Vec<Dim>& away) {
        if (leads[other] != 0) {
          offset.push_back(away);
          leader.push_back(rows.place(other));
        }
      });
      if (leader.empty() || (leader.size() <= Dim && reach < farthest)) {
        continue;
      }
      weight = fitted_weights<Dim>(offset, lines, complete);
    }
    if (leader.empty()) {
      continue;
    }
    number_[rows.place(node)] = static_cast<Index>(place_.size());
    place_.push_back(rows.place(node));
    for (std::size_t k = 0; k < leader.size(); ++k) {
      leader_.push_back({leader[k], weight[k]});
    }
    first_.push_back(leader_.size());
  }
}

template <int Dim>
void Followers<Dim>::prolong(std::span<double> values) const {
  for (std::size_t k = 0; k < place_.size(); ++k) {
    double sum = 0.0;
    for (std::size_t j = first_[k]; j < first_[k + 1]; ++j) {
      sum += leader_[j].weight * values[leader_[j].place];
    }
    values[place_[k]] = sum;
  }
}

template <int Dim>
void Followers<Dim>::hand_on(std::span<double> rise, std::span<const double> inverse) const {
  for (std::size_t k = 0; k < place_.size(); ++k) {
    const double heat = rise[place_[k]];
    rise[place_[k]] = 0.0;
    for (std::size_t j = first_[k]; j < first_[k + 1]; ++j) {
      const Index leader = leader_[j].place;
      rise[leader] += leader_[j].weight * heat * inverse[leader];
    }
  }
}

template <int Dim>
void Followers<Dim>::restrict_to_leaders(std::span<double> values) const {
  for (std::size_t k = 0; k < place_.size(); ++k) {
    const double given = values[place_[k]];
    values[place_[k]] = 0.0;
    for (std::size_t j = first_[k]; j < first_[k + 1]; ++j) {
      values[leader_[j].place] += leader_[j].weight * given;
    }
  }
}

template class Followers<1>;
template class Followers<2>;
template class Followers<3>;

}  // namespace lapilli
