#pragma once

#include "lapilli/materials/elastic.hpp"
#include "lapilli/materials/symmetric_tensor.hpp"

namespace lapilli {

/// Stiffness of a solid: engineering strains (xx, yy, zz, 2 xy, 2 yz, 2 xz) to stresses, Pa.
using Stiffness = Eigen::Matrix<double, 6, 6>;

/// Stress that a small strain (tensor components) adds, Pa.
SymmetricTensor stress_of(const LinearElastic& material, const SymmetricTensor& strain);

/// The matrix of `stress_of`, for engineering shear strains.
Stiffness stiffness_of(const LinearElastic& material);

}  // namespace lapilli
