#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lapilli/algebra/direct_solver.hpp"
#include "lapilli/mpm/quasi_static/hydrostatic.hpp"
#include "lapilli/mpm/quasi_static/joint_gap.hpp"
#include "lapilli/mpm/quasi_static/newton.hpp"
#include "lapilli/mpm/quasi_static/solid_state.hpp"
#include "lapilli/mpm/quasi_static/support_terms.hpp"

namespace lapilli {

/// A force on the surface of the material, spread by the shape functions of a cell.
template <int Dim>
struct SurfaceForce {
  typename Grid<Dim>::Cell cell;
  Vec<Dim> position;  // m
  Vec<Dim> force;     // N (per metre of thickness in 2D)
};

/// The loads of one load step, at its end.
template <int Dim>
struct Loads {
  std::vector<Vec<Dim>> body_force;  // N/m^3, one a point; empty: none
  /// Of points whose dilatation is averaged: the even part of the body force, as the pressure that
  /// balances it. `body_force` holds the rest; `skin_forces` that pressure on free surfaces.
  std::optional<HydrostaticPressure<Dim>> hydrostatic;
  std::vector<SurfaceForce<Dim>> skin_forces;
  std::vector<SupportTerm<Dim>> walls;
  std::vector<JointGap<Dim>> joint_gaps;
  std::vector<SurfaceForce<Dim>> surface_forces;
  std::array<std::vector<CellBox<Dim>>, Dim> ghost_pairs;
  double ghost = 0.0;
  std::vector<double> stiffness_left;  // by cell, of the elastic one that ghosts have; empty: all
  /// Displacement of the unknowns since the grid was reset, m; empty: none. Walls and ghosts resist
  /// all of it, the material only what is added: its stress already holds the rest.
  Eigen::VectorXd since_reset;
  /// Part of the imbalance that the reset brought, not taken up yet, N; empty: none.
  Eigen::VectorXd carried;
  /// Size of the largest forces of the steps before, N: where loads are taken off, what is out of
  /// balance is compared with what they were.
  double largest_before = 0.0;
};

/// Equilibrium of the nodes of the background grid in one load step. The unknown is the
/// displacement increment of the nodes; stresses at its start are given. Small strains.
///
/// Solves  int B^T sigma(u) + walls(u) + ghost(u) = body force + traction.
template <int Dim>
class Equilibrium {
 public:
  /// All arguments must outlive the object; `volume` (m^Dim) and `body` one a point. `system` and
  /// `solver` are kept between load steps so that a pattern that stands is not analysed again.
  Equilibrium(const Grid<Dim>& grid, std::span<const double> volume, std::span<const Index> body,
              const PointWeights<Dim>& weights, const CellState<Dim>& state,
              const SolidState& solids, const Loads<Dim>& loads, NodeSystem<Dim>& system,
              DirectSolver& solver);

  /// Assemble and factorise the elastic stiffness. The caller judges the pivots.
  PivotReport factorise();
  /// The same for the tangent at the increment `u`: the symmetric part of the consistent one where
  /// points yield, mixed with a share of the elastic stiffness.
  PivotReport factorise_at(const Eigen::VectorXd& u, double elastic_share);
  /// Whether any point yields at the increment `u`.
  bool yields_at(const Eigen::VectorXd& u) const;
  /// External minus internal forces at the increment `u`; zero at unknowns without stiffness.
  Imbalance residual(const Eigen::VectorXd& u) const;
  Eigen::VectorXd correction(const Eigen::VectorXd& force) const { return solver_.solve(force); }

  /// What of the surface forces reaches unknowns that carry stiffness, minus what was asked, over
  /// the sum of their sizes. Known once the tangent is factorised.
  double lost_surface_force() const;

  /// Strain increment of a point (tensor components), its dilatation that of its cell where that
  /// is averaged.
  SymmetricTensor strain(Index point, const Eigen::VectorXd& u) const;
  /// Displacement increment of a point.
  Vec<Dim> displacement(Index point, const Eigen::VectorXd& u) const;
  /// Force of each of `walls` walls on the material, N (per metre of thickness in 2D).
  std::vector<Vec<Dim>> support_forces(const Eigen::VectorXd& u, int walls) const;

 private:
  void lay_out();
  Eigen::VectorXd total(const Eigen::VectorXd& u) const {
    return loads_.since_reset.size() > 0 ? Eigen::VectorXd(loads_.since_reset + u) : u;
  }
  PivotReport factorise_assembled();
  void assemble_points();
  void assemble_yielding(const Eigen::VectorXd& u, double elastic_share);
  void assemble_group(const typename PointWeights<Dim>::Group& group, const auto& add_point);
  void assemble_surfaces();
  void external_force();
  double ghost_stiffness(const CellBox<Dim>& pair, int axis) const;
  // Each adds to `cancelled` the sizes of the terms that it sums into the force.
  void add_internal_force(const Eigen::VectorXd& u, Eigen::VectorXd& force,
                          Eigen::VectorXd& cancelled) const;
  void add_walls(const Eigen::VectorXd& held_back, Eigen::VectorXd& internal,
                 Eigen::VectorXd& cancelled, double& wall_square) const;
  void add_ghosts(const Eigen::VectorXd& held_back, Eigen::VectorXd& internal,
                  Eigen::VectorXd& cancelled) const;
  /// Call add(first unknown of a node, its share) for the nodes a surface force is spread to.
  template <class Add>
  void spread(const SurfaceForce<Dim>& load, const Add& add) const;
  Eigen::VectorXd gather(const CellBox<Dim>& box, const Eigen::VectorXd& from) const;
  void scatter(const CellBox<Dim>& box, const Eigen::VectorXd& local, Eigen::VectorXd& to) const;

  const Grid<Dim>& grid_;
  std::span<const double> volume_;
  std::span<const Index> body_;
  const PointWeights<Dim>& weights_;
  const CellState<Dim>& state_;
  const SolidState& solids_;
  const Loads<Dim>& loads_;
  NodeSystem<Dim>& system_;
  DirectSolver& solver_;
  std::array<Eigen::MatrixXd, Dim> ghost_matrix_;  // one component, per unit of gamma E
  Eigen::VectorXd external_;
};

}  // namespace lapilli
