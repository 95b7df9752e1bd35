#pragma once

#include <array>
#include <span>
#include <vector>

#include "lapilli/mpm/quasi_static/cell_state.hpp"
#include "lapilli/mpm/quasi_static/settings.hpp"

namespace lapilli {

/// Unit vectors along a wall, across each other.
template <int Dim>
std::array<Vec<Dim>, Dim - 1> tangents(const Vec<Dim>& normal);

/// The numbers of a wall form: stiffness of the constraint and share of the consistency term.
struct SupportScheme {
  double stiff = 0.0;          // 4/(3 bandwidth), on the mean over a facet; 0: none
  double pointwise = 0.0;      // 4/(3 bandwidth), at every point
  double consistency = 1.0;    // of the wall's traction; 1 passes the patch test for any bandwidth
  bool spares_volume = false;  // points are held across no stiffer than at a Poisson ratio of 0.4

  /// Bandwidths in cells (Cortis et al. Eq. 29 for a band that shrinks to the wall).
  static SupportScheme of(Enforcement form, double bandwidth, double gap_bandwidth);
  /// Where a wall ends beside free material: at points alone. `averaged`: where the dilatation is
  /// that of the cell, whose traction would need the mean gap.
  SupportScheme at_end(bool averaged) const;
};

/// What one facet of a wall adds to the equilibrium of the nodes of its cell,
/// `matrix` u - `force`, and the force of the wall on the material, `-(reaction u - given)`.
template <int Dim>
struct SupportTerm {
  static constexpr int nodes = 1 << Dim;
  using LocalMatrix = Eigen::Matrix<double, nodes * Dim, nodes * Dim, Eigen::RowMajor>;
  using LocalVector = Eigen::Matrix<double, nodes * Dim, 1>;

  CellBox<Dim> box;
  int wall = 0;
  LocalMatrix matrix;
  LocalVector force;
  Eigen::Matrix<double, Dim, nodes * Dim> reaction;
  Vec<Dim> given;

  /// Hold nothing any more.
  void let_go();
  /// Add a known force to what the nodes get at a point of the facet, N.
  void push(const Grid<Dim>& grid, const SurfacePoint<Dim>& point, const Vec<Dim>& by);
};

/// The terms of one facet of a wall of `kind` (Cortis et al. Eqs. 22 to 28 without frames; see
/// docs): K2 + K2^T + K3 and (K2 + K3) g, with the elastic moduli of the facet's cell. `motion`
/// holds the displacement increment g of the wall at each point of the facet. A facet in an empty
/// cell has no traction, so no consistency term.
template <int Dim>
SupportTerm<Dim> support_term(const Grid<Dim>& grid, const CellState<Dim>& state,
                              const Facet<Dim>& facet, HeldMotion kind,
                              std::span<const Vec<Dim>> motion, const SupportScheme& scheme);

/// Ghost stabilisation of the face between two cells along `axis`: gamma E h/3 times the integral
/// of the products of the jumps of the normal derivative (Burman 2010); per unit of gamma E, for
/// one component, over the nodes of the pair.
template <int Dim>
Eigen::MatrixXd ghost_matrix(int axis, double cell_size);

/// Values and gradients of the linear shape functions of one cell, continued beyond it.
template <int Dim>
void cell_shape(const Grid<Dim>& grid, const typename Grid<Dim>::Cell& cell,
                const Vec<Dim>& position, double* value, Vec<Dim>* gradient);

}  // namespace lapilli
