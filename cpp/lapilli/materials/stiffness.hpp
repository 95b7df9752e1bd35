#pragma once

#include "lapilli/materials/elastic.hpp"
#include "lapilli/materials/return_point.hpp"
#include "lapilli/materials/stress_slope.hpp"

namespace lapilli {

/// Stiffness of a solid: engineering strains (xx, yy, zz, 2 xy, 2 yz, 2 xz) to stresses, Pa.
using Stiffness = Eigen::Matrix<double, 6, 6>;

/// Stress that a small strain (tensor components) adds, Pa.
SymmetricTensor stress_of(const LinearElastic& material, const SymmetricTensor& strain);

/// The matrix of `stress_of`, for engineering shear strains.
Stiffness stiffness_of(const LinearElastic& material);

/// The law of the elastic solid: every trial stress stands.
struct ElasticLaw {
  static constexpr int states = 0;
  static constexpr bool yields = false, parts = false;

  explicit ElasticLaw(const LinearElastic&) {}

  template <class Real, int components>
  void return_stress(Real (&)[components], Real*) const {}
  SymmetricTensor stress_and_slope(const SymmetricTensor& trial, double*,
                                   StressSlope& slope) const {
    slope.setIdentity();
    return trial;
  }
};

}  // namespace lapilli
