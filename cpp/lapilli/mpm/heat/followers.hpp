#pragma once

#include <span>
#include <vector>

#include "lapilli/algebra/node_rows.hpp"

namespace lapilli {

/// Nodes that have next to nothing of the body follow the nearest ones that have more:
/// T_follower = sum of weight T_leader, a straight line through the leaders. Sums over nodes and
/// the symmetry of operators stay: C' = P^T C, K' = P^T K P.
template <int Dim>
class Followers {
 public:
  Followers() = default;
  /// `volume` (m^Dim) and `active` by node of the grid. Nodes below a hundredth of a full cell
  /// follow, or of the fullest node around where the body is thinner than that. Without `lines`
  /// they follow the mean of their leaders, whose capacities then stay positive whatever they are.
  Followers(const Grid<Dim>& grid, const NodeRows<Dim>& rows, std::span<const double> volume,
            std::span<const unsigned char> active, bool lines = true);

  struct Leader {
    Index place;
    double weight;
  };

  bool follows(Index place) const { return number_[place] >= 0; }
  /// Of a node that follows.
  std::span<const Leader> leaders(Index place) const {
    const Index k = number_[place];
    return std::span(leader_).subspan(first_[k], first_[k + 1] - first_[k]);
  }
  std::size_t count() const { return place_.size(); }

  /// Give followers the values of their leaders.
  void prolong(std::span<double> values) const;
  /// Hand the heat that followers received, entered as their rise, to their leaders, whose rise is
  /// heat times `inverse` capacity.
  void hand_on(std::span<double> rise, std::span<const double> inverse) const;
  /// Hand what followers received to their leaders.
  void restrict_to_leaders(std::span<double> values) const;

 private:
  std::vector<Index> number_;  // by place, -1 for nodes of their own
  std::vector<Index> place_;
  std::vector<std::size_t> first_{0};
  std::vector<Leader> leader_;
};

}  // namespace lapilli
