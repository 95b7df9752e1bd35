#pragma once

#include <span>
#include <vector>

#include "lapilli/mpm/quasi_static/support_terms.hpp"

namespace lapilli {

/// The mean gap of several facets of a wall together: what they bear is one traction.
template <int Dim>
struct JointGap {
  using Means = Eigen::Matrix<double, Eigen::Dynamic, Dim>;

  CellBox<Dim> box;  // of all their cells
  int wall = 0;
  Means mean;          // m^(Dim-1), of the nodes of the box, one held direction a column
  Vec<Dim> stiffness;  // Pa/m, times area^-1; 0 for a direction that is free
  Vec<Dim> motion;     // m m^(Dim-1), of the wall along each direction

  /// The box, node by node: matrix u - force.
  Eigen::MatrixXd matrix() const { return mean * stiffness.asDiagonal() * mean.transpose(); }
  /// What the wall gives each of the nodes, N, where they have moved by `u`.
  Eigen::VectorXd force(const Eigen::VectorXd& u) const { return mean * traction(u); }
  /// Sizes of the terms that `force` sums.
  Eigen::VectorXd sizes(const Eigen::VectorXd& u) const {
    const Vec<Dim> terms = motion.cwiseAbs() + mean.cwiseAbs().transpose() * u.cwiseAbs();
    return mean.cwiseAbs() * stiffness.cwiseProduct(terms);
  }
  /// Force of the wall on the material.
  Vec<Dim> total(const Eigen::VectorXd& u) const;

 private:
  Vec<Dim> traction(const Eigen::VectorXd& u) const {
    return stiffness.cwiseProduct(Vec<Dim>(motion - mean.transpose() * u));
  }
};

/// Of the facets numbered `members`, which belong to one wall of `kind`, fixed or a roller;
/// `motions` as `support_term` takes them, one list a facet.
template <int Dim>
JointGap<Dim> joint_gap(const Grid<Dim>& grid, const CellState<Dim>& state,
                        std::span<const Facet<Dim>> facets, std::span<const std::size_t> members,
                        HeldMotion kind, std::span<const std::vector<Vec<Dim>>> motions,
                        const SupportScheme& scheme);

}  // namespace lapilli
