// Solids in motion: their state moves with the points, is shown and saved; functions of blocks.
#include <catch2/catch.hpp>

#include "fixtures.hpp"
#include "lapilli/materials/stiffness.hpp"

using namespace lapilli;
using namespace dynamics_test;

namespace {

const LinearElastic sand{2000.0, 1e6, 0.3};

template <int Dim>
struct Falling : Run<Dim> {
  explicit Falling(const Solid& solid)
      : Run<Dim>(Grid<Dim>(Vec<Dim>::Zero(), Vec<Dim>::Constant(2.0), 0.25), ShapeFunction::gimp) {
    this->add({solid, 0.25, [](const Vec3&) { return Vec3(0.3, -1.0, 0.1); }, {}}, 2,
              [](const Vec<Dim>& x) { return x[0] > 0.5 && x[0] < 1.25 && x[1] < 1.0; });
    this->problem.settings.gravity.assign(Dim, 0.0);
    this->problem.settings.gravity[1] = -10.0;
    this->no_slip(1, 0);
  }
};

std::span<const double> field(Physics& physics, const std::string& name) {
  for (const Field& one : physics.fields()) {
    if (one.name == name) {
      return one.values;
    }
  }
  throw std::invalid_argument(name);
}

}  // namespace

TEST_CASE("plastic strain is a field, and goes on from an archive with the same bytes") {
  VonMises metal;
  metal.elastic = sand;
  metal.yield_stress = {1e3, 2e3};
  metal.plastic_strain = {0.0, 0.02};
  for (const Solid& solid :
       {Solid(metal), Solid(DruckerPrager{sand, 30.0, 5.0, 100.0}),
        Solid(TabulatedMohrCoulomb{sand, {0.0, 0.01}, {35.0, 30.0}, {10.0, 0.0}})}) {
    Falling<2> run(solid);
    run.start();
    for (int k = 0; k < 10; ++k) {
      run.advance(1e-3);
    }
    Archive points, physics;
    run.points.save(points);
    run.solver->save(physics);
    Falling<2> again(solid);
    again.start();
    again.points.load(points);
    again.solver->load(physics);
    for (int k = 0; k < 10; ++k) {
      run.advance(1e-3);
      again.advance(1e-3);
    }
    const auto strain = field(*run.solver, "plastic_strain");
    const auto other = field(*again.solver, "plastic_strain");
    CHECK(*std::ranges::max_element(strain) > 1e-3);
    CHECK(std::ranges::equal(strain, other));
    CHECK(std::ranges::equal(run.solver->stress().values(), again.solver->stress().values()));
  }
}

TEST_CASE("an elastic law given as a function of blocks is the built-in one") {
  const auto compare = [&]<int Dim>() {
    FunctionSolid solid;
    solid.elastic = sand;
    solid.state = {"age"};
    solid.function = [](const PointBlock& block) {
      for (int row = 0; row < block.rows; ++row) {
        const double* e = block.strain.data() + 6 * row;
        const SymmetricTensor added = stress_of(sand, {e[0], e[1], e[2], e[3], e[4], e[5]});
        for (int c = 0; c < 6; ++c) {
          block.stress[6 * row + c] += added[c];
        }
        block.state[row] += block.step;
      }
    };
    Falling<Dim> written(solid), built_in(sand);
    written.start();
    built_in.start();
    for (int k = 0; k < 20; ++k) {
      written.advance(1e-3);
      built_in.advance(1e-3);
    }
    double worst = 0.0, largest = 0.0;
    for (std::size_t k = 0; k < built_in.solver->stress().values().size(); ++k) {
      const double one = built_in.solver->stress().values()[k];
      worst = std::max(worst, std::abs(one - written.solver->stress().values()[k]));
      largest = std::max(largest, std::abs(one));
    }
    CHECK(largest > 1e3);
    CHECK(worst < 1e-11 * largest);  // sums in another order, over 20 steps
    for (const double age : field(*written.solver, "age")) {
      CHECK(age == Approx(0.02).epsilon(1e-12));
    }
    CHECK(written.value("plastic dissipation") == Approx(0.0).margin(1e-9));
  };
  compare.template operator()<2>();
  compare.template operator()<3>();
}

TEST_CASE("a number that is not finite from a function names the body and the component") {
  FunctionSolid solid;
  solid.elastic = sand;
  solid.function = [](const PointBlock& block) { block.stress[6 * 3 + 1] = NAN; };
  Falling<2> run(solid);
  run.problem.bodies[0].label = "body 'sand'";
  run.start();
  REQUIRE_THROWS_WITH(run.advance(1e-4),
                      Catch::Contains("body 'sand' gave nan for stress yy of point 3"));
}
