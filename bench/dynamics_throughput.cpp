#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>

#include "lapilli/core/parallel.hpp"
#include "lapilli/materials/mohr_coulomb.hpp"
#include "lapilli/mpm/dynamics/dynamics.hpp"

/// Throughput of explicit dynamics: million point-steps per second, double precision, soil that
/// yields under Mohr-Coulomb, with the share of points that do and the ratio of CPU to wall time.
namespace {

using namespace lapilli;

struct Setting {
  int cells;     // along each axis of the block
  int per_axis;  // points in a cell, along each axis
  ShapeFunction shape;
  StressUpdate update;
  VelocityTransfer transfer;
};

/// A block of soil under pressure, sheared and squeezed.
template <int Dim>
struct Block {
  explicit Block(const Setting& setting)
      : points(Dim),
        problem{Grid<Dim>(Vec<Dim>::Constant(-0.25), Vec<Dim>::Constant(1.25), 1.0 / setting.cells),
                setting.shape,
                {},
                {}} {
    const Index along = setting.cells * setting.per_axis;
    const double spacing = 1.0 / static_cast<double>(along);
    std::vector<double> positions, volumes;
    const auto count = static_cast<Index>(std::lround(std::pow(along, Dim)));
    for (Index k = 0; k < count; ++k) {
      for (Index axis = 0, rest = k; axis < Dim; ++axis, rest /= along) {
        positions.push_back((static_cast<double>(rest % along) + 0.5) * spacing);
      }
      volumes.push_back(std::pow(spacing, Dim));
    }
    points.append(positions, volumes, 0);
    MohrCoulomb soil;
    soil.elastic = {2000.0, 1e6, 0.3};
    soil.friction_angle = 30.0;
    DynamicsBody& body = problem.bodies.emplace_back();
    body.material = soil;
    body.half_width = 0.5 / setting.per_axis;
    body.velocity = [](const Vec3& x) {
      return Vec3(x[1] - 0.05 * x[0], -0.05 * x[1], 0.2 * x[0]);
    };
    body.stress = [](const Vec3&) { return SymmetricTensor(-1e3); };
    problem.settings.stress_update = setting.update;
    problem.settings.transfer = setting.transfer;
    solver = make_dynamics<Dim>(points, problem);
  }

  void step() {
    const double size = solver->step_limit().automatic;
    solver->advance({time, size, index++, false});
    time += size;
  }

  Points points;
  DynamicsProblem<Dim> problem;
  std::unique_ptr<Dynamics<Dim>> solver;
  double time = 0.0;
  Index index = 0;
};

constexpr int warm_steps = 30;

template <int Dim>
double yielding_share(const Setting& setting) {
  Block<Dim> block(setting);
  PointArray& work = block.solver->plastic_work();
  for (int k = 0; k < warm_steps; ++k) {
    std::fill(work.values().begin(), work.values().end(), 0.0);
    block.step();
  }
  Index yielding = 0;
  for (const double done : work.values()) {
    yielding += done > 0.0;
  }
  return static_cast<double>(yielding) / static_cast<double>(block.points.size());
}

double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <int Dim>
void momentum(benchmark::State& state, const Setting& setting) {
  set_thread_count(static_cast<int>(state.range(0)));
  const double share = yielding_share<Dim>(setting);
  Block<Dim> block(setting);
  for (int warm = 0; warm < warm_steps; ++warm) {
    block.step();
  }
  const double cpu = seconds(CLOCK_PROCESS_CPUTIME_ID), wall = seconds(CLOCK_MONOTONIC);
  for (auto _ : state) {
    block.step();
  }
  const double cpu_taken = seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu;
  const double wall_taken = seconds(CLOCK_MONOTONIC) - wall;
  const auto steps = static_cast<double>(state.iterations() * block.points.size());
  state.counters["Mps/s"] = 1e-6 * steps / wall_taken;
  state.counters["Mps/s/core"] = 1e-6 * steps / cpu_taken;
  state.counters["cpu/wall"] = cpu_taken / wall_taken;
  state.counters["yielding"] = share;
  set_thread_count(0);
}

/// The return mapping alone, over blocks that fit the first cache.
template <int components>
void return_mapping(benchmark::State& state) {
  constexpr int rows = 128;
  MohrCoulomb soil;
  soil.elastic = {2000.0, 1e6, 0.3};
  soil.friction_angle = 30.0;
  const MohrCoulombLaw ready(soil);
  alignas(32) double trial[components * rows], stress[components * rows];
  for (int k = 0; k < components * rows; ++k) {
    trial[k] = (k < 3 * rows ? -1e3 : 0.0) + 1.5e3 * std::sin(1.7 * k);
  }
  const double cpu = seconds(CLOCK_PROCESS_CPUTIME_ID), wall = seconds(CLOCK_MONOTONIC);
  for (auto _ : state) {
    std::copy(trial, trial + components * rows, stress);
    return_stresses<components>(ready, stress, nullptr, rows, rows);
    benchmark::DoNotOptimize(stress[0]);
    benchmark::ClobberMemory();
  }
  const double cpu_taken = seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu;
  const double wall_taken = seconds(CLOCK_MONOTONIC) - wall;
  const auto points = static_cast<double>(state.iterations() * rows);
  state.counters["Mps/s"] = 1e-6 * points / wall_taken;
  state.counters["Mps/s/core"] = 1e-6 * points / cpu_taken;
  state.counters["cpu/wall"] = cpu_taken / wall_taken;
}

void plane_strain(benchmark::State& state, const Setting& setting) { momentum<2>(state, setting); }
void space(benchmark::State& state, const Setting& setting) { momentum<3>(state, setting); }

#define LAPILLI_BENCH(dimension, name, ...) \
  BENCHMARK_CAPTURE(dimension, name, Setting{__VA_ARGS__})->Arg(1)->Arg(2)->UseRealTime()

constexpr auto linear = ShapeFunction::linear;
constexpr auto gimp = ShapeFunction::gimp;
constexpr auto usl = StressUpdate::usl;
constexpr auto musl = StressUpdate::musl;
constexpr auto flip = VelocityTransfer::flip;

LAPILLI_BENCH(plane_strain, linear_usl, 160, 2, linear, usl, flip);
LAPILLI_BENCH(plane_strain, linear_musl, 160, 2, linear, musl, flip);
LAPILLI_BENCH(plane_strain, gimp_usl, 160, 2, gimp, usl, flip);
LAPILLI_BENCH(plane_strain, gimp_musl, 160, 2, gimp, musl, flip);
LAPILLI_BENCH(plane_strain, gimp_musl_apic, 160, 2, gimp, musl, VelocityTransfer::apic);
LAPILLI_BENCH(space, linear_usl, 32, 2, linear, usl, flip);
LAPILLI_BENCH(space, linear_musl, 32, 2, linear, musl, flip);
LAPILLI_BENCH(space, gimp_usl, 32, 2, gimp, usl, flip);
BENCHMARK(return_mapping<4>)->Name("return_mapping/plane_strain");
BENCHMARK(return_mapping<6>)->Name("return_mapping/space");

}  // namespace
