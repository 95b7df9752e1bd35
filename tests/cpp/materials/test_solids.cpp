// What every solid of the list must do, whichever it is.
#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <type_traits>

#include "driver.hpp"
#include "lapilli/materials/return_point.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

std::vector<Solid> samples() {
  const LinearElastic elastic{2000.0, 1e7, 0.3};
  VonMises metal;
  metal.elastic = elastic;
  metal.yield_stress = {1e4, 1.3e4, 1.5e4};
  metal.plastic_strain = {0.0, 2e-4, 1e-3};
  VonMises clay = metal;
  clay.yield_stress = {1e4};
  clay.plastic_strain = {};
  return {elastic,
          MohrCoulomb{elastic, 30.0, 10.0, 5e3},
          MohrCoulomb{elastic, 0.0, 0.0, 5e3},
          DruckerPrager{elastic, 30.0, 10.0, 5e3},
          DruckerPrager{elastic, 25.0, 0.0, 5e3, ConeFit::compression},
          DruckerPrager{elastic, 0.0, 0.0, 5e3, ConeFit::extension},
          metal,
          clay,
          ModifiedCamClay{elastic, 1.2, 0.02, 1.2e4},
          TabulatedMohrCoulomb{
              elastic, {0.0, 1e-4, 5e-4}, {35.0, 30.0, 25.0}, {15.0, 5.0, 0.0}, {5e3, 1e3, 0.0}}};
}

SymmetricTensor draw(std::mt19937_64& engine, double size) {
  std::normal_distribution<double> normal;
  SymmetricTensor stress(-0.5 * size);
  for (double& component : stress.components) {
    component += size * normal(engine);
  }
  return stress;
}

std::string name_of_solid(const Solid& solid) {
  return std::visit([](const auto& one) { return std::string(one.kind); }, solid);
}

SymmetricTensor reached(const SolidLaw& law, const SymmetricTensor& trial, double strain) {
  std::array<double, most_state_variables> state{};
  state[0] = strain;
  return return_stress(law, trial, state.data());
}

}  // namespace

TEST_CASE("the slope of every return is that of finite differences") {
  std::mt19937_64 engine(3);
  for (const Solid& solid : samples()) {
    const SolidLaw law = law_of(solid);
    double worst = 0.0;
    int compared = 0, yielded = 0;
    for (int draws = 0; draws < 300; ++draws) {
      const SymmetricTensor trial = draw(engine, 1.5e4);
      const double strain = 1e-4 * (draws % 5);
      std::array<double, most_state_variables> state{strain};
      StressSlope slope;
      const SymmetricTensor stress = stress_and_slope(law, trial, state.data(), slope);
      const SymmetricTensor direct = reached(law, trial, strain);
      const double step = 0.1;  // Pa: 1e-5 of the stress
      for (int k = 0; k < 6; ++k) {
        SymmetricTensor up = trial, down = trial;
        up[k] += step;
        down[k] -= step;
        const SymmetricTensor above = reached(law, up, strain), below = reached(law, down, strain);
        for (int c = 0; c < 6; ++c) {
          REQUIRE(stress[c] == Approx(direct[c]).margin(1e-9 * 1.5e4));
          const double forward = (above[c] - direct[c]) / step,
                       backward = (direct[c] - below[c]) / step;
          if (std::abs(forward - backward) > 1e-4) {
            continue;  // a corner lies between
          }
          ++compared;
          worst = std::max(worst, std::abs(0.5 * (forward + backward) - slope(c, k)));
        }
      }
      yielded += std::abs(direct[0] - trial[0]) > 1.0;
    }
    INFO(name_of_solid(solid) << ": worst " << worst << ", compared " << compared << ", yielded "
                              << yielded);
    // Second differences of a curvature of 1 / stress over the step: (1e-5)^2, and the rounding of
    // 1e-12 Pa over 0.1 Pa.
    CHECK(worst < 1e-7);
    CHECK(compared > 9000);
    CHECK((yielded > 100 || !yields(law)));
  }
}

TEST_CASE("plane strain and the full form of every solid agree, alone and four at once") {
  std::mt19937_64 engine(5);
  for (const Solid& solid : samples()) {
    CAPTURE(name_of_solid(solid));
    std::visit(
        [&](const auto& law) {
          if constexpr (!BlockLaw<std::remove_cvref_t<decltype(law)>>) {
            constexpr int rows = 7;  // a quad and a rest
            double full[6 * rows], plane[4 * rows], state[rows] = {}, plane_state[rows] = {};
            for (int row = 0; row < rows; ++row) {
              SymmetricTensor trial = draw(engine, 1.5e4);
              trial[4] = trial[5] = 0.0;
              for (int c = 0; c < 6; ++c) {
                full[c * rows + row] = trial[c];
                if (c < 4) {
                  plane[c * rows + row] = trial[c];
                }
              }
              double alone_state[1] = {};
              const SymmetricTensor alone = return_point(law, trial, alone_state);
              double again[6 * rows], again_state[rows] = {};
              std::copy(full, full + 6 * rows, again);
              return_stresses<6>(law, again, again_state, rows, row + 1);
              for (int c = 0; c < 6; ++c) {
                REQUIRE(again[c * rows + row] == alone[c]);  // the same arithmetic in both
              }
              REQUIRE(again_state[row] == alone_state[0]);
            }
            return_stresses<6>(law, full, state, rows, rows);
            return_stresses<4>(law, plane, plane_state, rows, rows);
            for (int row = 0; row < rows; ++row) {
              for (int c = 0; c < 4; ++c) {
                REQUIRE(full[c * rows + row] ==
                        Approx(plane[c * rows + row]).margin(1e-12 * 1.5e4));
              }
              REQUIRE(state[row] == Approx(plane_state[row]).margin(1e-15));
            }
          }
        },
        law_of(solid));
  }
}
