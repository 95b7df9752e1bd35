#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/heat_settings.hpp"
#include "lapilli/peridynamics/influence.hpp"

namespace lapilli {

/// Non-local derivatives at points, in the plain form of the equations: the reference that the fast
/// loops of heat and flow are tested against, and the literal two-field operators themselves.
///
/// With bonds Y = x_j - x_i, weights w and volumes V the shape matrix is M = sum of w Y Y V. Points
/// without a family get zeros. A family whose bonds do not span the space throws RunError.
template <int Dim>
class NonlocalOperators {
 public:
  /// Weights and inverse shape matrices for the points where they are now; `families` must be up to
  /// date. `volume` one a point: 0 leaves a point out of all families. Points for which
  /// `may_be_flat` says so take gradients along the directions that their families span.
  NonlocalOperators(const Points& points, const Families& families, const BondWeight& weight,
                    std::span<const double> volume,
                    const std::function<bool(Index)>& may_be_flat = {});

  /// sum of w (f_j - f_i) M^-1 Y V (Eqs. 26, 29): exact for linear fields. `scalar` one a point.
  std::vector<Vec<Dim>> gradient(std::span<const double> scalar) const;
  /// Trace of the gradient of `vector`.
  std::vector<double> divergence(std::span<const Vec<Dim>> vector) const;
  /// sum of w (f_i M_i^-1 + f_j M_j^-1) Y V (Eqs. 27, 28): what j gives i is what i loses to j; not
  /// exact for linear fields on irregular points.
  std::vector<double> flux_divergence(std::span<const Vec<Dim>> flux) const;
  /// The Laplacian of `scalar` in any of its forms; `corrected` is here the one that each point
  /// forms for itself, 2 Dim / tr M sum of w (f_j - f_i - grad f . Y) V, exact for linear fields
  /// but not the same from both ends. `zero_energy` is the coefficient of that term.
  std::vector<double> laplacian(std::span<const double> scalar, Laplacian form,
                                double zero_energy) const;

  double weight(Index bond) const { return bond_weight_[bond]; }
  const Mat<Dim>& inverse_shape(Index point) const { return inverse_shape_[point]; }

 private:
  /// Call body(j, Y, w V_j) for the bonds of `point`.
  template <class Body>
  void for_bonds(Index point, const Body& body) const;

  const Points& points_;
  const Families& families_;
  BondWeight influence_;
  std::vector<double> bond_weight_;  // w V_j
  std::vector<Mat<Dim>> inverse_shape_;
  std::vector<double> trace_;
};

}  // namespace lapilli
