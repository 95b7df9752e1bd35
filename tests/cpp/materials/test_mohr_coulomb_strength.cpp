#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "lapilli/materials/mohr_coulomb.hpp"

using namespace lapilli;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

}  // namespace

TEST_CASE("triaxial compression and extension end at the analytic strengths") {
  for (double friction : {0.0, 20.0, 30.0, 60.0}) {
    MohrCoulomb m;
    m.elastic = {2000.0, 1e7, 0.3};
    m.friction_angle = friction;
    m.cohesion = 1e3;
    const MohrCoulombLaw constants(m);
    const double passive = std::pow(std::tan((45.0 + 0.5 * friction) * degree), 2);
    const double strength = 2 * m.cohesion * std::sqrt(passive);
    const double cell = -5e3, rate = 1e-4;
    const double young = m.elastic.youngs_modulus, nu = m.elastic.poissons_ratio;
    // The lateral stress is held by correcting the lateral strain with the elastic stiffness.
    for (double direction : {-1.0, 1.0}) {
      SymmetricTensor s(cell, cell, cell, 0, 0, 0);
      const double lambda = m.elastic.lambda(), shear = m.elastic.shear_modulus();
      for (int step = 0; step < 400; ++step) {
        const double axial = direction * rate;
        double lateral = -nu * axial;
        SymmetricTensor next;
        for (int correction = 0; correction < 100000; ++correction) {
          const double trace = axial + 2 * lateral;
          SymmetricTensor trial = s;
          trial[0] += lambda * trace + 2 * shear * lateral;
          trial[1] += lambda * trace + 2 * shear * lateral;
          trial[2] += lambda * trace + 2 * shear * axial;
          next = return_point(constants, trial, nullptr);
          const double miss = cell - 0.5 * (next[0] + next[1]);
          if (std::abs(miss) < 1e-12 * std::abs(cell)) {
            break;
          }
          lateral += miss / (2 * (lambda + shear));
        }
        s = next;
      }
      // s1 = K_p-law: compression -s3 = -s1 K_p + 2 c sqrt(K_p); extension the other way round.
      const double expected =
          direction < 0 ? cell * passive - strength : (cell + strength) / passive;
      CAPTURE(friction, direction, young);
      REQUIRE(s[2] == Approx(expected).epsilon(1e-10));
      REQUIRE(s[0] == Approx(cell).epsilon(1e-10));
    }
  }
}

TEST_CASE("plane strain compression without dilation ends at the analytic mean stress") {
  // With psi = 0 and no in-plane volume change: s1 - s3 = -(s1 + s3) sin(phi) + 2 c cos(phi), and
  // the third stress stays elastic, szz = nu (s1 + s3), while it lies between them.
  MohrCoulomb m;
  m.elastic = {2000.0, 1e7, 0.3};
  m.friction_angle = 30.0;
  m.cohesion = 200.0;
  const MohrCoulombLaw constants(m);
  const double start = -1e4;
  double s[4] = {start, start, 2 * 0.3 * start, 0};
  for (int step = 0; step < 1000; ++step) {
    const double rate = 1e-5, shear = m.elastic.shear_modulus();
    s[0] += 2 * shear * rate;
    s[1] -= 2 * shear * rate;
    return_stresses<4>(constants, s, nullptr, 1, 1);
  }
  const double radius = -start * std::sin(30 * degree) + 200 * std::cos(30 * degree);
  REQUIRE(s[0] == Approx(start + radius).epsilon(1e-10));
  REQUIRE(s[1] == Approx(start - radius).epsilon(1e-10));
  REQUIRE(s[2] == Approx(0.6 * start).epsilon(1e-10));
}

TEST_CASE("Mohr-Coulomb constants out of range are refused with their range") {
  MohrCoulomb sound;
  sound.elastic = {2000.0, 1e7, 0.3};
  sound.friction_angle = 30.0;
  REQUIRE_NOTHROW(check(sound));
  const auto refused = [&](auto change, const char* says) {
    MohrCoulomb m = sound;
    change(m);
    REQUIRE_THROWS_WITH(check(m), Catch::Contains(says));
  };
  refused([](MohrCoulomb& m) { m.dilatancy_angle = 31.0; }, "friction angle of 30");
  refused([](MohrCoulomb& m) { m.dilatancy_angle = -1.0; }, "dilatancy_angle");
  refused([](MohrCoulomb& m) { m.friction_angle = 90.0; }, "[0, 89.999]");
  refused([](MohrCoulomb& m) { m.cohesion = -1.0; }, "cohesion");
  refused([](MohrCoulomb& m) { m.cohesion = NAN; }, "cohesion");
  refused([](MohrCoulomb& m) { m.tension_cutoff = -1.0; }, "tension_cutoff");
  refused([](MohrCoulomb& m) { m.elastic.poissons_ratio = 0.5; }, "(-1, 0.5)");
  refused([](MohrCoulomb& m) { m.elastic.density = 0.0; }, "density");
  refused([](MohrCoulomb& m) { m.elastic.youngs_modulus = 0.0; }, "youngs_modulus");
}
