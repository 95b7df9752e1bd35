#include <catch2/catch.hpp>
#include <cmath>

#include "driver.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

DruckerPrager soil(double friction, double dilatancy, ConeFit fit) {
  return {{2000.0, 1e7, 0.3}, friction, dilatancy, 1e3, fit};
}

}  // namespace

TEST_CASE("the cones end at the triaxial strengths of Mohr-Coulomb they are fitted to") {
  for (double friction : {0.0, 20.0, 30.0, 60.0}) {
    for (double direction : {-1.0, 1.0}) {
      const ConeFit fit = direction < 0 ? ConeFit::compression : ConeFit::extension;
      LoadedPoint point(soil(friction, 0.5 * friction, fit));
      const double cell = -5e3;
      point.stress = SymmetricTensor(cell);
      int most = 0;
      for (int step = 0; step < 40; ++step) {
        const double strain = direction * 1e-3;
        most = std::max(most, point.load({0, 0, strain, 0, 0, 0}, 0b000011, {cell}));
      }
      const double passive = std::pow(std::tan((45.0 + 0.5 * friction) * degree), 2);
      const double strength = 2e3 * std::sqrt(passive);
      const double expected =
          direction < 0 ? cell * passive - strength : (cell + strength) / passive;
      CAPTURE(friction, direction, most);
      REQUIRE(point.stress[2] == Approx(expected).epsilon(1e-10));
      REQUIRE(point.stress[0] == Approx(cell).epsilon(1e-10));
      REQUIRE(most <= 8);  // iterations that the consistent tangent needs
    }
  }
}

TEST_CASE("in plane strain the cone has Mohr-Coulomb's strength for any dilatancy") {
  // Once nothing flows across the plane, (s1 - s3) / 2 = c cos(phi) - sin(phi) (s1 + s3) / 2.
  for (double friction : {0.0, 15.0, 30.0, 45.0}) {
    for (double share : {0.0, 0.4, 1.0}) {
      LoadedPoint point(soil(friction, share * friction, ConeFit::plane_strain));
      const double cell = -5e3;
      point.stress = SymmetricTensor(cell);
      for (int step = 0; step < 400; ++step) {
        point.load({0, -1e-3, 0, 0, 0, 0}, 0b000001, {cell});
      }
      const double radius = 0.5 * (point.stress[0] - point.stress[1]);
      const double middle = 0.5 * (point.stress[0] + point.stress[1]);
      CAPTURE(friction, share);
      REQUIRE(radius ==
              Approx(1e3 * std::cos(friction * degree) - middle * std::sin(friction * degree))
                  .epsilon(1e-10));
      // The dilatancy angle is that of the plane: sin(psi) = volume over shear of the flow.
      const double before = point.stress[0];
      REQUIRE(before == Approx(cell).epsilon(1e-10));
    }
  }
}

TEST_CASE("beyond its apex the cone leaves the cohesion over the tangent of friction") {
  // Fit to triaxial compression: the mean stress of the apex is c / tan(phi), as Mohr-Coulomb's.
  for (double dilatancy : {0.0, 15.0, 30.0}) {
    LoadedPoint point(soil(30.0, dilatancy, ConeFit::compression));
    point.load({1e-2, 1e-2, 1.2e-2, 1e-3, 0, 0}, 0, {});
    const double apex = 1e3 / std::tan(30.0 * degree);
    for (int c = 0; c < 6; ++c) {
      REQUIRE(point.stress[c] == Approx(c < 3 ? apex : 0.0).epsilon(1e-12).margin(1e-9));
    }
    REQUIRE(point.state[0] > 0.0);
    REQUIRE(std::get<DruckerPragerLaw>(point.law).parts_at(point.state.data()) ==
            Approx(apex).epsilon(1e-12));
  }
}

TEST_CASE("the plastic strain of the cone is that of its flow") {
  // Triaxial compression at the limit: the stress stands, all of the strain is plastic. Axial and
  // lateral deviatoric rates (e, -e/2, -e/2) give sqrt(2/3 e:e) = |e|, and e = 2/3 (axial -
  // lateral).
  LoadedPoint point(soil(30.0, 10.0, ConeFit::compression));
  point.stress = SymmetricTensor(-5e3);
  for (int step = 0; step < 20; ++step) {
    point.load({0, 0, -1e-3, 0, 0, 0}, 0b000011, {-5e3});
  }
  const double before = point.state[0];
  const double axial = -1e-4;
  // sin(psi) of triaxial compression: volume = -axial * 2 sin(psi) / (1 - sin(psi)).
  const double sine = std::sin(10.0 * degree);
  const double lateral = -0.5 * axial * (1.0 + 2.0 * sine / (1.0 - sine));
  point.load({0, 0, axial, 0, 0, 0}, 0b000011, {-5e3});
  REQUIRE(point.state[0] - before == Approx(2.0 / 3.0 * (lateral - axial)).epsilon(1e-9));
}

TEST_CASE("Drucker-Prager constants out of range are refused with their range") {
  const auto refused = [](auto change, const char* says) {
    DruckerPrager material = soil(30.0, 10.0, ConeFit::plane_strain);
    REQUIRE_NOTHROW(check(material));
    change(material);
    REQUIRE_THROWS_WITH(check(material), Catch::Contains(says));
  };
  refused([](DruckerPrager& m) { m.dilatancy_angle = 31.0; }, "friction angle of 30");
  refused([](DruckerPrager& m) { m.dilatancy_angle = -1.0; }, "dilatancy_angle");
  refused([](DruckerPrager& m) { m.friction_angle = 90.0; }, "[0, 89.999]");
  refused([](DruckerPrager& m) { m.cohesion = NAN; }, "cohesion");
  refused([](DruckerPrager& m) { m.elastic.poissons_ratio = 0.5; }, "(-1, 0.5)");
}

TEST_CASE("with dilation equal to friction cone and flow are the textbook's of plane strain") {
  const DruckerPragerLaw law(soil(35.0, 35.0, ConeFit::plane_strain));
  const double tangent = std::tan(35.0 * std::acos(-1.0) / 180.0);
  const double root = std::sqrt(9.0 + 12.0 * tangent * tangent);  // Drucker and Prager 1952
  CHECK(law.flow == Approx(tangent / root).epsilon(1e-12));
  CHECK(law.cone == Approx(tangent / root).epsilon(1e-12));
  CHECK(law.strength == Approx(3e3 / root).epsilon(1e-12));
}
