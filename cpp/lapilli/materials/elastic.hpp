#pragma once

#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/materials/state_variable.hpp"

namespace lapilli {

struct ElasticLaw;  // stiffness.hpp

/// Isotropic linear elastic solid. Applied to the rate of deformation it is hypoelastic: large
/// rotations are exact, large elastic strains are not modelled.
struct LinearElastic {
  static constexpr const char* kind = "elastic";
  using Law = ElasticLaw;
  double density = 0.0;         // kg/m^3, of the undeformed body
  double youngs_modulus = 0.0;  // Pa
  double poissons_ratio = 0.0;  // in (-1, 0.5)

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("density").unit("kg/m^3").positive().required().text("mass per undeformed volume"),
          self.density);
    visit(Key("youngs_modulus").unit("Pa").positive().required().text("stiffness in tension"),
          self.youngs_modulus);
    visit(Key("poissons_ratio").range(-1.0, 0.5, true).text("lateral contraction, in (-1, 0.5)"),
          self.poissons_ratio);
  }

  const LinearElastic& elastic_part() const { return *this; }
  std::vector<StateVariable> state_variables() const { return {}; }

  /// First Lame constant, Pa.
  double lambda() const {
    return youngs_modulus * poissons_ratio /
           ((1.0 + poissons_ratio) * (1.0 - 2.0 * poissons_ratio));
  }
  /// Shear modulus, Pa.
  double shear_modulus() const { return 0.5 * youngs_modulus / (1.0 + poissons_ratio); }
  double bulk_modulus() const { return youngs_modulus / (3.0 * (1.0 - 2.0 * poissons_ratio)); }
  /// Modulus of uniaxial strain, lambda + 2 mu, Pa: density times the square of the wave speed.
  double wave_modulus() const { return lambda() + 2.0 * shear_modulus(); }
};

/// Throws std::invalid_argument naming the first constant outside its range.
void check(const LinearElastic& material);

}  // namespace lapilli
