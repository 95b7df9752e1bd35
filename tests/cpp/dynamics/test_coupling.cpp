#include <catch2/catch.hpp>

#include "dynamics/fixtures.hpp"
#include "lapilli/mpm/dynamics/thermal_strain.hpp"

using namespace dynamics_test;

namespace {

/// Ten steps of 3 K each, everywhere.
void heat_by_30_kelvin(Run<2>& run) {
  PointArray temperature(run.points, 1, 280.0);
  ThermalStrain expansion(run.points, temperature, run.solver->free_strain(), {1e-5});
  for (int k = 0; k < 10; ++k) {
    for (double& value : temperature.values()) {
      value += 3.0;
    }
    expansion.advance({run.time, 1e-4, run.index});
    run.advance(1e-4);
  }
}

}  // namespace

TEST_CASE("heating a body held on all sides gives the pressure of its bulk modulus") {
  Run<2> run(Grid<2>({0, 0}, {1, 1}, 0.25), ShapeFunction::linear);
  const LinearElastic solid = elastic(1000, 1e6, 0.25);
  run.add({solid, 0.25, {}, {}}, 2, [](const Vec<2>&) { return true; });
  for (int axis : {0, 1}) {
    run.roller(axis, 0);
    run.roller(axis, 1);
  }
  run.start();
  heat_by_30_kelvin(run);
  // Every node lies on a wall or between equal neighbours: nothing moves, 30 K in all.
  for (Index row = 0; row < run.points.size(); ++row) {
    REQUIRE(run.solver->stress()[4 * row] ==
            Approx(-3 * solid.bulk_modulus() * 1e-5 * 30.0).epsilon(1e-9));
  }
}

namespace {

/// What is left over of the energy account, over the largest of its entries.
template <int Dim>
double energy_gap(const Run<Dim>& run) {
  const Balance energy = run.solver->balances()[0];
  double largest = 0.0;
  for (const Balance::Entry& entry : energy.entries) {
    largest = std::max(largest, std::abs(entry.in));
  }
  return (energy.stored - energy.initial - energy.supplied()) / largest;
}

/// Half of a block is heated by 30 K within 0.05 s and rings on; the entry of expansion, J.
template <int Dim>
double heat_half(Run<Dim>& run, const DynamicsBody& body) {
  run.add(body, 2,
          [](const Vec<Dim>& x) { return (x.array() > 0.25).all() && (x.array() < 0.75).all(); });
  run.start();
  PointArray temperature(run.points, 1, 280.0);
  ThermalStrain expansion(run.points, temperature, run.solver->free_strain(), {1e-4});
  for (int k = 0; k < 400; ++k) {
    for (Index row = 0; row < run.points.size(); ++row) {
      const bool warm = k < 200 && run.points.template position<Dim>(row)[0] > 0.5;
      temperature[row] += warm ? 30.0 / 200 : 0.0;
    }
    expansion.advance({run.time, 2.5e-4, run.index});
    run.advance(2.5e-4);
  }
  return run.value("expansion work");
}

}  // namespace

TEST_CASE("a clamped body that is heated stores what expansion gives it") {
  for (const Solid& solid : {Solid(elastic(1000, 1e6, 0.25)), Solid(soil(1e6, 30, 1e6))}) {
    Run<2> run(Grid<2>({0, 0}, {1, 1}, 0.25), ShapeFunction::gimp);
    run.add({solid, 0.25, {}, {}}, 2, [](const Vec<2>&) { return true; });
    for (int axis : {0, 1}) {
      run.no_slip(axis, 0);
      run.no_slip(axis, 1);
    }
    run.start();
    heat_by_30_kelvin(run);
    // 9/2 K (alpha dT)^2 over one square metre; nothing moves, no other entry.
    const double stored = 4.5 * elastic_part(solid).bulk_modulus() * std::pow(1e-5 * 30.0, 2);
    CHECK(run.value("expansion work") == Approx(stored).epsilon(1e-9));
    CHECK(run.value("elastic energy") == Approx(stored).epsilon(1e-9));
    CHECK(std::abs(energy_gap(run)) < 1e-9);
  }
}

TEST_CASE("the energy of a free body that expands unevenly and rings closes") {
  // What is left is the change of volume on the stored energy, of the size of the strain of 3e-3.
  Run<2> plane(Grid<2>({0, 0}, {1, 1}, 0.125), ShapeFunction::gimp);
  CHECK(heat_half<2>(plane, {elastic(1000, 1e6, 0.3), 0.25, {}, {}}) > 0.0);
  CHECK(plane.value("kinetic energy") > 0.0);
  CHECK(std::abs(energy_gap(plane)) < 3e-3);
  Run<3> space(Grid<3>({0, 0, 0}, {1, 1, 1}, 0.125), ShapeFunction::gimp);
  CHECK(heat_half<3>(space, {elastic(1000, 1e6, 0.3), 0.25, {}, {}}) > 0.0);
  CHECK(std::abs(energy_gap(space)) < 3e-3);
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

namespace {

/// Gradients of ones on a block that is sheared and turned for some steps, all in one row.
template <int Dim>
std::vector<double> carried(bool handed_over) {
  Vec<Dim> low = Vec<Dim>::Zero(), high = Vec<Dim>::Ones();
  Run<Dim> run(Grid<Dim>(low, high, 0.125), ShapeFunction::gimp);
  DynamicsBody body{elastic(1000, 1e5, 0.3), 0.25, {}, {}};
  body.velocity = [](const Vec3& x) { return Vec3(-2.0 * x[1], 3.0 * x[0] + x[2], 0.5 * x[0]); };
  run.add(body, 2,
          [](const Vec<Dim>& x) { return (x.array() > 0.25).all() && (x.array() < 0.75).all(); });
  PointArray gradient(run.points, Dim, 1.0, PointArray::Kind::gradient);
  run.start();
  if (handed_over) {
    run.solver->turn(gradient);
  }
  for (int k = 0; k < 20; ++k) {
    run.advance(1e-3);
  }
  return {gradient.values().begin(), gradient.values().end()};
}

template <int Dim>
void compare_carried() {
  const std::vector<double> turned = carried<Dim>(true), moved = carried<Dim>(false);
  double largest = 0.0, change = 0.0;
  for (std::size_t k = 0; k < turned.size(); ++k) {
    largest = std::max(largest, std::abs(turned[k] - moved[k]));
    change = std::max(change, std::abs(turned[k] - 1.0));
  }
  CHECK(change > 0.02);
  CHECK(largest < 1e-14);  // rounding of twenty products near one
}

}  // namespace

TEST_CASE("a gradient that dynamics turns is the one that points carry") {
  compare_carried<2>();
  compare_carried<3>();
}
