#pragma once

#include "lapilli/core/describe.hpp"
#include "lapilli/materials/symmetric_tensor.hpp"

namespace lapilli {

/// Stiffness of a solid: engineering strains (xx, yy, zz, 2xy, 2yz, 2xz) to stresses, Pa.
using Stiffness = Eigen::Matrix<double, 6, 6>;

/// An isotropic solid whose stress is linear in the strain (Hooke). Strains are small.
struct LinearElastic {
  double youngs_modulus = 0.0;  // Pa
  double poissons_ratio = 0.0;  // 1, in (-1, 1/2)

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("youngs_modulus").unit("Pa").positive().required().text("stiffness in tension"),
          self.youngs_modulus);
    visit(Key("poissons_ratio").range(-1.0, 0.5, true).text("contraction across over stretch along"),
          self.poissons_ratio);
  }

  double shear_modulus() const { return 0.5 * youngs_modulus / (1.0 + poissons_ratio); }
  /// Lame's first parameter, Pa.
  double lame() const {
    return youngs_modulus * poissons_ratio / ((1.0 + poissons_ratio) * (1.0 - 2.0 * poissons_ratio));
  }
  /// Stiffness in compression without lateral strain, Pa.
  double constrained_modulus() const { return lame() + 2.0 * shear_modulus(); }
};

/// Throws std::invalid_argument unless the modulus is positive and the ratio in (-1, 1/2).
void check(const LinearElastic& material);

/// Stress that a strain (tensor components) adds.
SymmetricTensor stress_of(const LinearElastic& material, const SymmetricTensor& strain);

/// The matrix of `stress_of`, for engineering shear strains.
Stiffness stiffness_of(const LinearElastic& material);

}  // namespace lapilli
