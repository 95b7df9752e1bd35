#include <catch2/catch.hpp>
#include <cmath>

#include "driver.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

constexpr double slope = 1.2, softness = 0.04, start = 1e5;

ModifiedCamClay clay() { return {{1800.0, 1e7, 0.25}, slope, softness, start}; }

double mean_pressure(const SymmetricTensor& stress) {
  return -(stress[0] + stress[1] + stress[2]) / 3.0;
}

}  // namespace

TEST_CASE("compacted without shear the clay follows its line of normal consolidation") {
  for (int steps : {1, 7, 50}) {
    LoadedPoint point(clay());
    const double strain = -0.1 / steps;
    for (int step = 0; step < steps; ++step) {
      point.load({strain / 3, strain / 3, strain / 3, 0, 0, 0}, 0, {});
    }
    const double p = mean_pressure(point.stress);
    // All of the strain: elastic p / K, plastic along the line.
    const double bulk = clay().elastic.bulk_modulus();
    CAPTURE(steps);
    REQUIRE(p > 2.0 * start);
    REQUIRE(p / bulk + softness * std::log(p / start) == Approx(0.1).epsilon(1e-12));
    REQUIRE(point.state[0] == Approx(softness * std::log(p / start)).epsilon(1e-12));
  }
}

TEST_CASE("drained compression ends at the critical state") {
  // q = M p with dp = dq / 3: q = 3 M p0 / (3 - M); half of the preconsolidation pressure.
  for (double cell : {2e4, 5e4, 1.5e5}) {  // heavily and lightly overconsolidated; beyond the start
    LoadedPoint point(clay());
    point.load({0, 0, 0, 0, 0, 0}, 0b000111, SymmetricTensor(-cell));
    for (int step = 0; step < 400; ++step) {
      point.load({0, 0, -5e-3, 0, 0, 0}, 0b000011, SymmetricTensor(-cell));
    }
    const double q = point.stress[0] - point.stress[2], p = mean_pressure(point.stress);
    CAPTURE(cell);
    REQUIRE(q == Approx(3.0 * slope * cell / (3.0 - slope)).epsilon(1e-10));
    REQUIRE(p == Approx(cell + q / 3.0).epsilon(1e-10));
    REQUIRE(point.state[0] == Approx(softness * std::log(2.0 * p / start)).epsilon(1e-9));
  }
}

TEST_CASE("sheared at constant volume the clay ends where elastic and plastic volume cancel") {
  for (double cell : {2e4, 9e4}) {  // pressure rises and falls
    LoadedPoint point(clay());
    point.load({0, 0, 0, 0, 0, 0}, 0b000111, SymmetricTensor(-cell));
    for (int step = 0; step < 400; ++step) {
      point.load({1e-3, 1e-3, -2e-3, 0, 0, 0}, 0, {});
    }
    const double q = point.stress[0] - point.stress[2], p = mean_pressure(point.stress);
    const double bulk = clay().elastic.bulk_modulus();
    CAPTURE(cell);
    REQUIRE((p - cell) / bulk + softness * std::log(2.0 * p / start) == Approx(0.0).margin(1e-12));
    REQUIRE(q == Approx(slope * p).epsilon(1e-10));
  }
}

TEST_CASE("strength in shear does not depend on the direction of the shear") {
  const double cell = 8e4;
  for (int component : {3, 4, 5}) {
    LoadedPoint point(clay());
    point.load({0, 0, 0, 0, 0, 0}, 0b000111, SymmetricTensor(-cell));
    std::array<double, 6> strain{};
    strain[static_cast<std::size_t>(component)] = 2e-2;
    for (int step = 0; step < 200; ++step) {
      point.load(strain, 0b000111, SymmetricTensor(-cell));
    }
    REQUIRE(std::sqrt(3.0) * point.stress[component] == Approx(slope * cell).epsilon(1e-10));
  }
}

TEST_CASE("the path of drained compression is that of its differential equations, at first order") {
  // Along it eta = q / p: d(volume)/dp and d(shear)/dp have closed forms (Wood 1990, chapter 5);
  // normally consolidated, volume = (p - p0) / K + softness ln(pc / pc0), pc = p + q^2 / (M^2 p).
  const double cell = start, end = 0.1;
  double coarse = 0.0;
  for (int steps : {100, 200, 400}) {
    LoadedPoint point(clay());
    point.load({0, 0, 0, 0, 0, 0}, 0b000111, SymmetricTensor(-cell));
    point.volume = 0.0;
    for (int step = 0; step < steps; ++step) {
      point.load({0, 0, -end / steps, 0, 0, 0}, 0b000011, SymmetricTensor(-cell));
    }
    const double q = point.stress[0] - point.stress[2], p = mean_pressure(point.stress);
    const double pc = p + q * q / (slope * slope * p);
    const double bulk = clay().elastic.bulk_modulus();
    REQUIRE(-point.volume ==
            Approx((p - cell) / bulk + softness * std::log(pc / start)).epsilon(1e-10));
    // The shear strain, integrated finely: d(shear) = dq / 3 mu + flow of the ellipse.
    const double shear_modulus = clay().elastic.shear_modulus();
    double shear = 0.0;
    const int pieces = 200000;
    for (int k = 0; k < pieces; ++k) {
      const double at = q * (k + 0.5) / pieces, dq = q / pieces, here = cell + at / 3.0;
      const double eta = at / here;
      const double d_eta = (1.0 - eta / 3.0) / here * dq;
      const double volume =
          softness * (dq / 3.0 / here + 2.0 * eta * d_eta / (slope * slope + eta * eta));
      shear += dq / (3.0 * shear_modulus) + volume * 2.0 * eta / (slope * slope - eta * eta);
    }
    const double error = std::abs(shear - (end + point.volume / 3.0)) / end;
    CAPTURE(steps, error);
    REQUIRE(error < 1.5 / steps);  // measured 1.1 / steps
    if (coarse > 0.0) {
      REQUIRE(coarse / error == Approx(2.0).epsilon(0.15));
    }
    coarse = error;
  }
}

TEST_CASE("pulled apart the clay bears nothing, and pressed again it closes before it presses") {
  LoadedPoint point(clay());
  point.load({0, 0, 0, 0, 0, 0}, 0b000111, SymmetricTensor(-0.9 * start));
  const double before = mean_pressure(point.stress), volume = point.volume;
  for (int step = 0; step < 100; ++step) {
    point.load({1e-2, 1e-2, 1e-2, 0, 0, 0}, 0, {});
    REQUIRE(mean_pressure(point.stress) >= -1e-9 * start);
  }
  REQUIRE(mean_pressure(point.stress) < 1e-3 * start);
  while (point.volume > volume + 1e-9) {
    const double back = std::max(-1e-2, (volume - point.volume) / 3.0);
    point.load({back, back, back, 0, 0, 0}, 0, {});
  }
  // Elastic and plastic strain share the volume anew.
  const double p = mean_pressure(point.stress), bulk = clay().elastic.bulk_modulus();
  REQUIRE(p < start);
  REQUIRE(p / bulk + point.state[0] == Approx(before / bulk).epsilon(1e-9));
}

TEST_CASE("steps of any size from any state end on the ellipse") {
  std::uint64_t seed = 7;
  const auto uniform = [&seed] {
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(seed >> 11) * 0x1p-53;
  };
  const ModifiedCamClayLaw law(clay());
  for (int trial = 0; trial < 20000; ++trial) {
    const double size = std::pow(10.0, 9.0 * uniform());
    const double shear = std::pow(10.0, 9.0 * uniform());
    SymmetricTensor stress((uniform() - 0.7) * size);
    for (double& component : stress.components) {
      component += shear * (uniform() - 0.5);
    }
    double state[1] = {softness * (uniform() * 10.0 - 6.0)};
    const double before = state[0], trial_mean = -mean_pressure(stress);
    const SymmetricTensor reached = return_point(law, stress, state);
    const double p = mean_pressure(reached);
    double square = 0.0;
    for (int c = 0; c < 3; ++c) {
      square += (reached[c] + p) * (reached[c] + p) + 2.0 * reached[c + 3] * reached[c + 3];
    }
    const double q = std::sqrt(1.5 * square), pc = law.preconsolidation(state[0]);
    CAPTURE(trial, p, q, pc, before);
    REQUIRE(std::isfinite(p));
    const double miss = q * q / (slope * slope) + p * (p - pc);
    if (state[0] != before || q * q / (slope * slope) + p * (p - pc) > 0.0) {
      REQUIRE(std::abs(miss) <= 1e-7 * (p * p + pc * pc));
      REQUIRE((state[0] - before) * law.bulk ==
              Approx(-trial_mean - p).margin(1e-9 * (size + shear)));
    }
  }
}

TEST_CASE("Cam-clay constants out of range are refused with their names") {
  const auto refused = [](auto change, const char* says) {
    ModifiedCamClay material = clay();
    REQUIRE_NOTHROW(check(material));
    change(material);
    REQUIRE_THROWS_WITH(check(material), Catch::Contains(says));
  };
  refused([](ModifiedCamClay& m) { m.critical_state_slope = 0.0; }, "critical_state_slope");
  refused([](ModifiedCamClay& m) { m.plastic_compressibility = -1.0; }, "plastic_compressibility");
  refused([](ModifiedCamClay& m) { m.preconsolidation_pressure = NAN; },
          "preconsolidation_pressure");
  refused([](ModifiedCamClay& m) { m.elastic.poissons_ratio = 0.5; }, "(-1, 0.5)");
}
