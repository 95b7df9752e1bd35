#pragma once

#include <cstdint>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// The bonds of points at rest, both ways, in a compressed list.
template <int Dim>
struct BondGraph {
  std::vector<Index> begin;             // points + 1
  std::vector<std::int32_t> neighbour;  // a bond
  std::vector<Vec<Dim>> bond;           // Y = x_j - x_i, m
  std::vector<double> weight;           // w V_i V_j, the same from both ends

  Index points() const { return static_cast<Index>(begin.size()) - 1; }
};

/// What the surface takes of each point.
template <int Dim>
struct PointSurface {
  std::vector<Vec<Dim>> area;  // sum of the outward areas a of a point, m^(Dim-1)
  std::vector<double> moment;  // Dim V - sum of a . (place on the surface - x), m^Dim
};

/// Areas over lengths that bonds stand for, g_ij = weight (c_i + c_j)/2 f((l_i - l_j) . Y), all
/// positive and the same from both ends, so that every point is closed:
///
///     sum over bonds of g Y + a = 0.
///
/// Then a field linear in space whose slope every surface of a body agrees with gives no rate at
/// any point, whatever the shape. f(t) = 1 + t, or 1/(1 - t) below 0, keeps bonds positive. The c
/// start from sum of g Y^2 = 2 moment; the l are the displacements of a truss whose bars are the
/// bonds, under the loads that the surface leaves, found by damped sweeps and by Newton's method
/// with conjugate gradients. Closed surfaces are in equilibrium but for the arm between a point and
/// its surface; that turning part is left over.
template <int Dim>
class BondBalance {
 public:
  BondBalance(const BondGraph<Dim>& graph, const PointSurface<Dim>& surface,
              std::vector<Vec<Dim>> places);

  /// g of every bond, m^(Dim-2).
  std::vector<double> solve();
  /// |sum of g Y + a| / (sum of g |Y| + |a|) of a point, as `solve` left it.
  const std::vector<double>& open() const { return open_; }

 private:
  using Vectors = std::vector<Vec<Dim>>;

  void start();
  void sweep(bool scale);
  /// One step of Newton's method; false if it brought little.
  bool newton();
  double weight(Index point, Index bond, const Vectors& tilt) const;
  double stiffness(Index point, Index bond) const;
  double tilt_of(Index point, Index bond, const Vectors& tilt) const;
  Vec<Dim> load(Index point, const Vectors& tilt) const;
  Vectors loads(const Vectors& tilt) const;
  /// Take translations and turns out of loads: the truss has no answer to them.
  void remove_rigid(Vectors& loads) const;
  Vectors displacements(const Vectors& loads) const;
  void measure();

  const BondGraph<Dim>& graph_;
  const PointSurface<Dim>& surface_;
  Vectors places_, tilt_;
  std::vector<double> scale_;  // c
  std::vector<double> open_;
};

}  // namespace lapilli
