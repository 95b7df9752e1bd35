// Bodies that yield under load steps: closed forms of even stress, and Newton's rate.
#include <catch2/catch.hpp>

#include "lapilli/geometry/cell_fill.hpp"
#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

const LinearElastic steel{1e-9, 2e11, 0.3};

VonMises hardening() {
  VonMises metal;
  metal.elastic = steel;
  metal.yield_stress = {2.5e8, 3.0e8, 3.2e8};
  metal.plastic_strain = {0.0, 0.01, 0.05};
  return metal;
}

/// A box between rollers on its lower sides; the upper side along x moves by `strain` of its
/// length, the others are free or loaded by `pressure`.
template <int Dim>
struct PulledBox {
  PulledBox(const Solid& solid, double strain, double pressure = 0.0) : points(Dim) {
    const double low = 0.4, size = 2.0;
    Box box{std::vector<double>(Dim, low), std::vector<double>(Dim, low + size)};
    const FilledPoints filled = fill_cells(Shape(box), Lattice{Vec3::Zero(), 1.0, 2}, {}, Dim);
    points.append(filled.position, filled.volume, 0);
    QuasiStaticSettings settings;
    settings.reset = 1.0;  // on one grid: small strains stay exact
    settings.update_volumes = false;
    for (int axis = 0; axis < Dim; ++axis) {
      for (const bool upper : {false, true}) {
        std::vector<double> at(Dim, low), out(Dim, 0.0);
        at[axis] += upper ? size : 0.0;
        out[axis] = upper ? 1.0 : -1.0;
        const Shape half = HalfSpace{at, out};
        if (!upper || axis == 0) {
          SupportSettings support{"side", HeldMotion::roller, {half, true, {}, {}}, {}, 0.0};
          if (upper) {
            support.displacement.assign(Dim, 0.0);
            support.displacement[0] = Table{{0.0, 1.0}, {0.0, strain * size}};
          }
          settings.supports.push_back(support);
        } else if (pressure != 0.0) {
          settings.tractions.push_back(
              {"load", {half, true, {}, {}}, {}, Table{{0.0, 0.1}, {0.0, pressure}}});
        }
      }
    }
    Vec<Dim> lower = Vec<Dim>::Constant(-1.0), higher = Vec<Dim>::Constant(4.0);
    physics = std::make_unique<QuasiStatic<Dim>>(points, Grid<Dim>(lower, higher, 1.0),
                                                 ShapeFunction::linear, std::vector<Solid>{solid},
                                                 settings, std::vector<Shape>{box});
  }
  void run(int steps) {
    for (int k = 0; k < steps; ++k) {
      iterations =
          std::max(iterations, physics->advance({1.0 / steps * k, 1.0 / steps, k}).iterations);
    }
  }
  double stress(Index p, int c) const { return physics->stress()[6 * p + c]; }
  std::span<const double> plastic_strain() {
    for (const Field& field : physics->fields()) {
      if (field.name == "plastic_strain") {
        return field.values;
      }
    }
    throw std::invalid_argument("no plastic strain");
  }

  Points points;
  std::unique_ptr<QuasiStatic<Dim>> physics;
  int iterations = 0;
};

}  // namespace

TEST_CASE("a bar pulled between supports follows the table of its hardening") {
  const double end = 0.02, slope = 0.2e8 / 0.04, young = steel.youngs_modulus;
  const double stress = (end + 3.0e8 / slope - 0.01) / (1.0 / young + 1.0 / slope);
  PulledBox<3> bar(hardening(), end);
  bar.run(4);
  double worst = 0.0, across = 0.0, strain = 0.0;
  for (Index p = 0; p < bar.points.size(); ++p) {
    worst = std::max(worst, std::abs(bar.stress(p, 0) / stress - 1.0));
    across = std::max({across, std::abs(bar.stress(p, 1)), std::abs(bar.stress(p, 3))});
    strain = std::max(strain, std::abs(bar.plastic_strain()[p] - (end - stress / young)));
  }
  INFO("stress " << worst << ", across " << across / stress << ", strain " << strain
                 << ", iterations " << bar.iterations);
  // The two supports give by 3/4 of the bandwidth of 1e-3 cells times stress over the modulus of
  // uniaxial strain, 1.1e-3: a strain of 8e-7 over two cells, and its share of the hardening.
  CHECK(strain < 1.5e-6);
  CHECK(worst < 2.5e-6);
  CHECK(across < 5e-7 * stress);
  CHECK(bar.iterations <= 6);
}

TEST_CASE("soil in triaxial compression ends at its strength, with and without dilatancy") {
  const LinearElastic soil{1e-9, 1e7, 0.3};
  const double friction = 30.0, cohesion = 1e3, cell = -2e4;
  const double passive = 3.0, expected = cell * passive - 2.0 * cohesion * std::sqrt(passive);
  for (const double dilatancy : {friction, 0.0}) {
    for (const Solid& solid :
         {Solid(DruckerPrager{soil, friction, dilatancy, cohesion, ConeFit::compression}),
          Solid(MohrCoulomb{soil, friction, dilatancy, cohesion})}) {
      PulledBox<3> sample(solid, -0.015, -cell);
      sample.run(10);
      double worst = 0.0;
      for (Index p = 0; p < sample.points.size(); ++p) {
        worst = std::max({worst, std::abs(sample.stress(p, 0) / expected - 1.0),
                          std::abs(sample.stress(p, 1) / cell - 1.0)});
      }
      INFO(std::visit([](const auto& one) { return one.kind; }, solid)
           << ", dilatancy " << dilatancy << ": " << worst << ", iterations " << sample.iterations);
      // Newton's tolerance on forces that the supports' own, 1e3 times stiffer, are part of; where
      // the last correction was one of many, what it left counts as often.
      CHECK(worst < (dilatancy > 0.0 ? 3e-7 : 4e-6));
      // Quadratic with the symmetric tangent of associated flow, linear without dilatancy: 20 to 90
      // iterations, as the last bits of the forces fall.
      CHECK(sample.iterations <= (dilatancy > 0.0 ? 6 : 150));
    }
  }
}
