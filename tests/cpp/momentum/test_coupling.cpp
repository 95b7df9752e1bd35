#include <catch2/catch.hpp>

#include "lapilli/mpm/momentum/thermal_strain.hpp"
#include "momentum/fixtures.hpp"

using namespace momentum_test;

TEST_CASE("heating a body held on all sides gives the pressure of its bulk modulus") {
  Run<2> run(Grid<2>({0, 0}, {1, 1}, 0.25), ShapeFunction::linear);
  const LinearElastic solid = elastic(1000, 1e6, 0.25);
  run.add({solid, 0.25, {}, {}}, 2, [](const Vec<2>&) { return true; });
  for (int axis : {0, 1}) {
    run.roller(axis, 0);
    run.roller(axis, 1);
  }
  run.start();
  PointArray temperature(run.points, 1, 280.0);
  ThermalStrain expansion(run.points, temperature, run.solver->free_strain(), {1e-5});
  for (int k = 0; k < 10; ++k) {
    for (double& value : temperature.values()) {
      value += 3.0;
    }
    expansion.advance({run.time, 1e-4, run.index});
    run.advance(1e-4);
  }
  // Every node lies on a wall or between equal neighbours: nothing moves, 30 K in all.
  for (Index row = 0; row < run.points.size(); ++row) {
    REQUIRE(run.solver->stress()[4 * row] ==
            Approx(-3 * solid.bulk_modulus() * 1e-5 * 30.0).epsilon(1e-9));
  }
}

TEST_CASE("expansion coefficients that are missing or not finite are refused") {
  Points points(2);
  points.append(std::vector<double>{0.5, 0.5}, std::vector<double>{1.0}, 1);
  PointArray temperature(points, 1), strain(points, 1);
  REQUIRE_THROWS_WITH(ThermalStrain(points, temperature, strain, {1e-5}),
                      Catch::Contains("body 1"));
  REQUIRE_THROWS_WITH(ThermalStrain(points, temperature, strain, {1e-5, NAN}),
                      Catch::Contains("finite"));
}
