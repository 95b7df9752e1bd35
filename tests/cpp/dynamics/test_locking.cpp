// One dilatation a cell: nearly incompressible bodies are as right as others.
#include <catch2/catch.hpp>
#include <random>

#include "dynamics/fixtures.hpp"
#include "lapilli/core/require.hpp"

using namespace dynamics_test;

namespace {

constexpr double nearly = 0.4999;

/// Sink of the free end of a beam of 8 x 2, let go under its weight with one end in a wall, over
/// that at rest (quadratic elements): mean over three periods, with weights that leave out what
/// vibrates. `lift`: of the beam over the lines of the grid, in cells.
double sink_share(double poisson, ShapeFunction shape, double cell, std::optional<bool> b_bar,
                  double lift = 0.0) {
  constexpr double length = 8.0, height = 2.0, weight = 1e-6, period = 190.0;
  Run<2> run(Grid<2>({0.0, -6 * cell}, {length + 4 * cell, height + 6 * cell}, cell), shape);
  run.add({elastic(1.0, 1.0, poisson), 0.25, {}, {}}, 2,
          [&](const Vec<2>& x) { return x[0] < length && x[1] > 0.0 && x[1] < height; });
  std::vector<double> start(static_cast<std::size_t>(run.points.size()));
  for (Index row = 0; row < run.points.size(); ++row) {
    run.points.position()[2 * row + 1] += lift * cell;
    start[run.points.id()[row]] = run.points.position()[2 * row + 1];
  }
  run.no_slip(0, 0);
  run.problem.settings.gravity = {0.0, -weight};
  run.problem.settings.b_bar = b_bar;
  run.start();
  double sum = 0.0, weights = 0.0;
  while (run.time < 3.0 * period) {
    const double step = run.automatic_step();
    run.advance(step);
    const double window = std::pow(std::sin(M_PI * run.time / (3.0 * period)), 4);
    double count = 0.0, sink = 0.0;
    for (Index row = 0; row < run.points.size(); ++row) {
      const Vec<2> x = run.points.position<2>(row);
      if (x[0] > length - 0.5 * cell) {
        sink += start[run.points.id()[row]] - x[1];
        count += 1.0;
      }
    }
    sum += window * step * sink / count;
    weights += window * step;
  }
  return sum / weights / weight / (poisson == nearly ? 1205.9 : 1479.1);
}

}  // namespace

namespace {

/// Points of a disk or ball, off the lattice by up to half their spacing.
template <int Dim>
void shake(Points& points, double spacing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  for (double& x : points.position()) {
    x += spacing * part(random);
  }
}

/// A jittered ball of ten cells across that starts with a velocity or a stress.
template <int Dim>
std::unique_ptr<Run<Dim>> ball(ShapeFunction shape, StressUpdate update, bool b_bar,
                               DynamicsBody body) {
  auto run = std::make_unique<Run<Dim>>(
      Grid<Dim>(Vec<Dim>::Constant(-1.4), Vec<Dim>::Constant(1.4), 0.2), shape);
  run->add(std::move(body), 2, [](const Vec<Dim>& x) { return x.norm() < 1.0; });
  if (shape != ShapeFunction::linear || update == StressUpdate::musl) {
    shake<Dim>(run->points, 0.1);
  }
  run->problem.settings.stress_update = update;
  run->problem.settings.b_bar = b_bar;
  run->start();
  return run;
}

/// Largest difference between what one step makes of a ball with and without b_bar, over the
/// largest value without.
template <int Dim>
double difference(ShapeFunction shape, StressUpdate update, const DynamicsBody& body,
                  const PointArray& (Dynamics<Dim>::*field)() const) {
  auto with = ball<Dim>(shape, update, true, body), without = ball<Dim>(shape, update, false, body);
  const double step = without->automatic_step();
  with->advance(step);
  without->advance(step);
  const auto one = ((*with->solver).*field)().values(),
             other = ((*without->solver).*field)().values();
  double most = 0.0, largest = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k) {
    most = std::max(most, std::abs(one[k] - other[k]));
    largest = std::max(largest, std::abs(other[k]));
  }
  return most / largest;
}

template <int Dim>
void check_even(ShapeFunction shape, StressUpdate update) {
  CAPTURE(Dim, name_of(shape), name_of(update));
  // An even pressure pushes the nodes as it does without means, at the surface, too.
  CHECK(difference<Dim>(
            shape, update,
            {elastic(1000, 1e5, 0.45), 0.25, {}, [](const Vec3&) { return SymmetricTensor(-1e3); }},
            &Dynamics<Dim>::velocity) < 1e-11);
  if (shape == ShapeFunction::linear) {
    return;  // whose points carry no gradient
  }
  // An even strain strains as it does without means.
  const auto grow = [](const Vec3& x) {
    return Vec3(1e-8 * (0.3 * x[0] + 0.1 * x[1] + (Dim - 2) * (0.2 * x[0] - 0.1 * x[2])),
                2e-9 * x[1], (Dim - 2) * -1e-9 * x[2]);
  };
  CHECK(difference<Dim>(shape, update, {elastic(1000, 1e5, 0.45), 0.25, grow, {}},
                        &Dynamics<Dim>::stress) < 1e-11);
}

}  // namespace

TEST_CASE("an even stress and an even strain are those without means") {
  for (const ShapeFunction shape : {ShapeFunction::gimp, ShapeFunction::bspline}) {
    for (const StressUpdate update : all_updates) {
      check_even<2>(shape, update);
      check_even<3>(shape, update);
    }
  }
  check_even<2>(ShapeFunction::linear, StressUpdate::musl);
  check_even<3>(ShapeFunction::linear, StressUpdate::musl);
}

TEST_CASE("a nearly incompressible cantilever sinks as others do") {
  for (const ShapeFunction shape : {ShapeFunction::linear, ShapeFunction::gimp}) {
    CAPTURE(name_of(shape));
    // Two cells high, where only the cure is exact enough to be seen: without, 8 % of the sink.
    CHECK(sink_share(nearly, shape, 1.0, false) < 0.1);
    const double soft = sink_share(0.3, shape, 1.0, true);
    CHECK(sink_share(nearly, shape, 1.0, true) == Approx(soft).epsilon(0.01));
  }
  // Off the lines of the grid; four cells high, where others sink too little by 3 %.
  CHECK(sink_share(nearly, ShapeFunction::gimp, 1.0, {}, 0.37) == Approx(1.0).margin(0.12));
  CHECK(sink_share(nearly, ShapeFunction::gimp, 0.5, {}) == Approx(1.0).margin(0.01));
}

TEST_CASE("a nearly incompressible disk keeps the energy of its vibration") {
  for (const bool jitter : {false, true}) {
    Run<2> run(Grid<2>({-1.4, -1.4}, {1.4, 1.4}, 0.2), ShapeFunction::gimp);
    const auto start = [](const Vec3& x) { return Vec3(1e-6 * x[0], -1e-6 * x[1], 0); };
    run.add({elastic(1.0, 1.0, nearly), 0.25, start, {}}, 2,
            [](const Vec<2>& x) { return x.norm() < 1.0; });
    if (jitter) {
      shake<2>(run.points, 0.1);
    }
    run.start();
    const auto energy = [&] { return run.value("kinetic energy") + run.value("elastic energy"); };
    const double first = energy();
    for (int period = 0; period < 10; ++period) {
      run.until(run.time + 4.7);
      CHECK(energy() / first == Approx(1.0).margin(3e-3));
      CHECK(run.value("energy gained") / first < 1e-3);  // what the force lags behind the strain
    }
  }
}

TEST_CASE("bodies whose volume stays share the dilatation of cells unless told otherwise") {
  const auto is_averaged = [](const Solid& solid, std::optional<bool> b_bar) {
    DynamicsSettings settings;
    settings.b_bar = b_bar;
    return averages_dilatation(settings, solid);
  };
  VonMises metal;
  TabulatedMohrCoulomb hardening;
  hardening.friction_angle = {0.0, 10.0};
  CHECK_FALSE(is_averaged(elastic(1.0, 1.0, 0.4), {}));
  CHECK(is_averaged(elastic(1.0, 1.0, 0.41), {}));
  CHECK_FALSE(is_averaged(elastic(1.0, 1.0, 0.41), false));
  CHECK(is_averaged(elastic(1.0, 1.0, 0.4), true));
  CHECK(is_averaged(soil(1.0, 0.0, 1.0), {}));
  CHECK_FALSE(is_averaged(soil(1.0, 30.0), {}));
  CHECK(is_averaged(metal, {}));
  CHECK_FALSE(is_averaged(hardening, {}));
}
