#pragma once

#include <span>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/materials/solid.hpp"
#include "lapilli/materials/state_arrays.hpp"

namespace lapilli {

/// The solids of the bodies with the stress and the state variables of their points. Stresses and
/// tangents at the end of a load step follow from the strain increment of a point.
class SolidState {
 public:
  /// `solids` by body. Throws std::invalid_argument for a solid that cannot be used, and for points
  /// of a body without one.
  SolidState(Points& points, const std::vector<Solid>& solids);

  std::span<const LinearElastic> elastic() const { return elastic_; }
  const LinearElastic& elastic(Index body) const { return elastic_[body]; }
  /// Whether any of the solids ever yields.
  bool can_yield() const { return can_yield_; }
  bool can_yield(Index body) const { return yields(laws_[body]); }
  std::span<double> stress() { return stress_.values(); }  // rows x 6, Pa
  std::span<const double> stress() const { return stress_.values(); }
  /// The largest component of the stress of a point, Pa.
  double largest_stress(Index point) const;
  /// The stress of a point, Pa.
  SymmetricTensor stress(Index point) const;

  // After a strain increment (tensor components) of a point of a body.

  SymmetricTensor stress_after(Index point, Index body, const SymmetricTensor& strain) const;
  /// Whether the law returns the elastic stress.
  bool yields_after(Index point, Index body, const SymmetricTensor& strain) const;
  /// The symmetric part of the consistent tangent, mixed with a share of the elastic stiffness.
  Stiffness tangent_after(Index point, Index body, const SymmetricTensor& strain,
                          double elastic_share) const;
  /// Elastic strain over all strain since the start, where the law yields.
  double stiffness_left(Index point, Index body, const SymmetricTensor& strain) const;
  /// Take the increment.
  void strain(Index point, Index body, const SymmetricTensor& strain);

  /// Largest principal strain of any point since the start, of either sign.
  double largest_strain(const Points& points) const;
  /// Stress and state variables.
  std::vector<Field> fields();
  void save(Archive& archive) const;
  void load(const Archive& archive);

 private:
  std::vector<LinearElastic> elastic_;  // by body
  std::vector<SolidLaw> laws_;          // by body
  bool can_yield_ = false;
  PointArray stress_;                   // Pa, rows x 6
  std::unique_ptr<PointArray> strain_;  // rows x 6, where the stress does not tell it
  StateArrays states_;
};

}  // namespace lapilli
