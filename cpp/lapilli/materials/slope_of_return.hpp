#pragma once

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "lapilli/materials/dual.hpp"
#include "lapilli/materials/stress_of_duals.hpp"
#include "lapilli/materials/stress_slope.hpp"

namespace lapilli {

// Derivatives of a return to its trial stress, from the code of the return itself: exact, and never
// out of step with it.

/// Of a law that is smooth in the components of the stress wherever it yields.
template <class Law>
SymmetricTensor differentiate_return(const Law& law, const SymmetricTensor& trial, double* state,
                                     StressSlope& slope) {
  using Real = Dual<6>;
  Real stress[6], states[std::max(1, Law::states)];
  for (int c = 0; c < 6; ++c) {
    stress[c] = Real::variable(trial[c], c);
  }
  for (int k = 0; k < Law::states; ++k) {
    states[k] = as<Real>(state[k]);
  }
  law.return_stress(stress, states);
  return stress_of_duals(stress, states, Law::states, state, slope);
}

/// Of an isotropic law given by its sorted principal stresses, f(t1, t2, t3) with members s1, s2,
/// s3. Principal axes turn with the trial stress: a shear between two of them goes by the ratio of
/// the differences of their values, where two coincide by its limit.
template <class Function>
SymmetricTensor differentiate_principal(const Function& f, const SymmetricTensor& trial,
                                        StressSlope& slope) {
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(trial.matrix());
  const Vec3 t = solver.eigenvalues().reverse();
  const Mat3 axes = solver.eigenvectors().rowwise().reverse();
  using Real = Dual<3>;
  const auto reached = f(Real::variable(t[0], 0), Real::variable(t[1], 1), Real::variable(t[2], 2));
  const Real s[3] = {reached.s1, reached.s2, reached.s3};
  const double close = 1e-8 * t.cwiseAbs().maxCoeff();
  Mat3 normal, turning;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const auto one = static_cast<std::size_t>(j), own = static_cast<std::size_t>(i);
      normal(i, j) = s[i].slope[one];
      turning(i, j) =
          std::abs(t[i] - t[j]) > close
              ? (s[i].value - s[j].value) / (t[i] - t[j])
              : 0.5 * (s[i].slope[own] - s[i].slope[one] + s[j].slope[one] - s[j].slope[own]);
    }
  }
  for (int k = 0; k < 6; ++k) {
    SymmetricTensor unit;
    unit[k] = 1.0;
    const Mat3 change = axes.transpose() * unit.matrix() * axes;
    Mat3 result = turning.cwiseProduct(change);
    result.diagonal() = normal * change.diagonal();
    const SymmetricTensor column = symmetric_part(Mat3(axes * result * axes.transpose()));
    for (int c = 0; c < 6; ++c) {
      slope(c, k) = column[c];
    }
  }
  const Vec3 values(s[0].value, s[1].value, s[2].value);
  return symmetric_part(Mat3(axes * values.asDiagonal() * axes.transpose()));
}

}  // namespace lapilli
