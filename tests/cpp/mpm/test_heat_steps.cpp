#include <catch2/catch.hpp>

#include "lapilli/core/require.hpp"
#include "mpm/square_scenes.hpp"

namespace lapilli {
namespace {

using scenes::Trial;

template <int Dim>
double size_of(Physics& heat) {
  heat.refresh_output();
  double most = 0.0;
  for (const Field& field : heat.fields()) {
    if (field.components == 1) {
      for (const double value : field.values) {
        most = std::max(most, std::abs(value));
      }
    }
  }
  return most;
}

/// The largest stable step of an insulated body, 2 / (largest eigenvalue), by power iteration with
/// a step far beyond it: the fastest mode grows by |1 - step eigenvalue| a step.
template <int Dim>
double largest_stable_step(const Trial<Dim>& trial) {
  const auto points = trial.points();
  const auto heat = make_heat<Dim>(*points, trial.problem());
  const double step = 4.0 * heat->step_limit().hard;
  const int steps = 100;
  double before = 0.0;
  for (int k = 0; k < steps; ++k) {
    before = k == steps - 10 ? size_of<Dim>(*heat) : before;
    heat->advance({k * step, step, Index{k} + 1, true});
  }
  return 2.0 * step / (1.0 + std::pow(size_of<Dim>(*heat) / before, 0.1));
}

/// Whether noise has grown, on nodes or on points, after many steps.
template <int Dim>
bool grows(const Trial<Dim>& trial, double step) {
  const auto points = trial.points();
  const auto heat = make_heat<Dim>(*points, trial.problem());
  for (Index k = 0; k < 400; ++k) {
    heat->advance({static_cast<double>(k) * step, step, k + 1, true});
  }
  return !(size_of<Dim>(*heat) < 1.0);
}

template <int Dim>
void automatic_step_suits(const Trial<Dim>& trial, double least_share) {
  const auto points = trial.points();
  const auto heat = make_heat<Dim>(*points, trial.problem());
  const StepLimit limit = heat->step_limit();
  // Power iteration measures FLIP and `nodal`; the others must not grow at their hard limit.
  const bool measured = trial.settings.transfer == HeatTransfer::nodal ||
                        trial.settings.transfer == HeatTransfer::flip;
  const double largest = measured                   ? largest_stable_step(trial)
                         : grows(trial, limit.hard) ? 0.0
                                                    : limit.hard;
  INFO(Dim << "D, " << name_of(trial.settings.transfer) << ", " << name_of(trial.shape)
           << ", angle " << trial.layout.angle << ", jitter " << trial.layout.jitter << ", random "
           << trial.layout.random << ": automatic " << limit.automatic << ", hard " << limit.hard
           << ", largest stable " << largest << ", share " << limit.automatic / largest);
  CHECK(limit.automatic <= limit.hard);
  CHECK(limit.hard <= largest * (1.0 + 1e-3));  // power iteration comes from above
  CHECK(limit.automatic / largest >= least_share);
}

template <int Dim>
Trial<Dim> noisy(HeatTransfer transfer, ShapeFunction shape) {
  Trial<Dim> trial;
  trial.half = Dim == 3 ? 3.0 : 6.0;
  trial.settings.transfer = transfer;
  trial.shape = shape;
  trial.body.temperature = scenes::noise(-1.0, 1.0);
  return trial;
}

// The share of the largest stable step that the automatic one must reach on lattices is the bar of
// the design; 0.4 leaves room for scattered points, which must only be stable.
TEST_CASE("The automatic step is stable and at least 0.4 of the largest on lattice points") {
  const ShapeFunction shape =
      GENERATE(ShapeFunction::linear, ShapeFunction::gimp, ShapeFunction::bspline);
  const HeatTransfer transfer = GENERATE(HeatTransfer::nodal, HeatTransfer::flip);
  for (const double shift : {0.0, 0.5}) {
    Trial<1> rod = noisy<1>(transfer, shape);
    rod.centre[0] = shift;
    Trial<2> square = noisy<2>(transfer, shape);
    square.centre = Vec<2>::Constant(shift);
    automatic_step_suits(rod, 0.4);
    automatic_step_suits(square, 0.4);
  }
  automatic_step_suits(noisy<3>(transfer, shape), 0.4);
}

TEST_CASE("The hard limit is stable on turned, jittered and random points") {
  const ShapeFunction shape =
      GENERATE(ShapeFunction::linear, ShapeFunction::gimp, ShapeFunction::bspline);
  const HeatTransfer transfer = GENERATE(HeatTransfer::nodal, HeatTransfer::flip, HeatTransfer::pic,
                                         HeatTransfer::affine, HeatTransfer::tpic);
  if (shape == ShapeFunction::linear &&
      (transfer == HeatTransfer::tpic || transfer == HeatTransfer::affine)) {
    return;  // refused
  }
  for (const auto& layout : {scenes::Layout{20.0}, scenes::Layout{45.0, 0.1},
                             scenes::Layout{0.0, 0.25}, scenes::Layout{0.0, 0.0, true}}) {
    Trial<2> square = noisy<2>(transfer, shape);
    square.layout = layout;
    automatic_step_suits(square, 0.0);
    square.per_axis = 3;
    automatic_step_suits(square, 0.0);
  }
  Trial<3> cube = noisy<3>(transfer, shape);
  cube.layout.random = true;
  automatic_step_suits(cube, 0.0);
}

TEST_CASE("A step above the hard limit is refused with the number and the reason") {
  Trial<2> trial = noisy<2>(HeatTransfer::flip, ShapeFunction::gimp);
  const double hard = trial.start(1.0).physics().front()->step_limit().hard;
  CHECK_THROWS_WITH(trial.start(1.0, 1.01 * hard), Catch::Contains(message(hard)) &&
                                                       Catch::Contains(message(1.01 * hard)) &&
                                                       Catch::Contains("h^2/alpha"));
  CHECK_NOTHROW(trial.start(1.0, hard));
  trial.settings.transfer = HeatTransfer::nodal;
  CHECK_THROWS_WITH(trial.start(1.0, 10.0), Catch::Contains("Gershgorin"));
  trial.settings.transfer = HeatTransfer::tpic;
  trial.shape = ShapeFunction::linear;
  CHECK_THROWS_WITH(trial.start(1.0), Catch::Contains("linear"));
}

TEST_CASE("Convection of any strength is stable at the hard limit") {
  for (const HeatTransfer transfer :
       {HeatTransfer::nodal, HeatTransfer::flip, HeatTransfer::pic, HeatTransfer::affine}) {
    for (const double biot : {1.0, 1e6}) {
      for (const double angle : {0.0, 30.0}) {
        Trial<2> trial = noisy<2>(transfer, ShapeFunction::gimp);
        trial.layout.angle = angle;
        trial.settings.boundaries = {scenes::convection(biot, 0.0)};
        const double hard = trial.start(1.0).physics().front()->step_limit().hard;
        Simulation simulation = trial.start(1e9, hard);
        for (int k = 0; k < 200; ++k) {
          simulation.step();
        }
        scenes::Range range;
        range.include(scenes::field(simulation, "temperature"));
        INFO(name_of(transfer) << ", Biot " << biot << ", angle " << angle << ": " << range.low
                               << " to " << range.high);
        CHECK(range.beyond(-1.0, 1.0) == 0.0);
      }
    }
  }
}

}  // namespace
}  // namespace lapilli
