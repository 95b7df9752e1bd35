#pragma once

#include <Eigen/Dense>
#include <array>
#include <bitset>
#include <cmath>

#include "lapilli/materials/solid.hpp"

namespace lapilli::test {

/// One point of a solid, loaded by strains along some components and stresses along the others.
struct LoadedPoint {
  explicit LoadedPoint(const Solid& of) : solid(of), law(law_of(of)) {}

  /// Add `strain` (engineering shear) to the components whose bit is not set; find the strains of
  /// the others that give them the `wanted` stress, by Newton's method with the consistent tangent.
  /// Returns the iterations.
  int load(const std::array<double, 6>& strain, const std::bitset<6>& stress_given,
           const SymmetricTensor& wanted, double tolerance = 1e-13) {
    const Stiffness stiffness = stiffness_of(elastic_part(solid));
    Eigen::Matrix<double, 6, 1> change =
        Eigen::Map<const Eigen::Matrix<double, 6, 1>>(strain.data());
    for (int iteration = 0;; ++iteration) {
      SymmetricTensor trial = stress;
      const Eigen::Matrix<double, 6, 1> added = stiffness * change;
      for (int c = 0; c < 6; ++c) {
        trial[c] += added[c];
      }
      auto reached_state = state;
      StressSlope slope;
      const SymmetricTensor reached = stress_and_slope(law, trial, reached_state.data(), slope);
      const Stiffness tangent = slope * stiffness;
      Eigen::VectorXd miss = Eigen::VectorXd::Zero(6);
      Eigen::MatrixXd reduced = Eigen::MatrixXd::Identity(6, 6);
      double size = 1e-300;
      for (int c = 0; c < 6; ++c) {
        size = std::max({size, std::abs(reached[c]), std::abs(wanted[c])});
        if (stress_given[c]) {
          miss[c] = wanted[c] - reached[c];
          for (int k = 0; k < 6; ++k) {
            reduced(c, k) = stress_given[k] ? tangent(c, k) : 0.0;
          }
        }
      }
      if (miss.cwiseAbs().maxCoeff() <= tolerance * size || iteration == 60) {
        stress = reached;
        volume += change.head<3>().sum();
        state = reached_state;
        return iteration;
      }
      change += reduced.fullPivLu().solve(miss);
    }
  }

  Solid solid;
  SolidLaw law;
  SymmetricTensor stress;
  double volume = 0.0;  // strain
  std::array<double, most_state_variables> state{};
};

inline constexpr double degree = 3.14159265358979323846 / 180.0;

}  // namespace lapilli::test
