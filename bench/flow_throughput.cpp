#include <benchmark/benchmark.h>

#include <ctime>

#include "lapilli/core/parallel.hpp"
#include "lapilli/scene/build.hpp"
#include "lapilli/scene/scene_file.hpp"

/// Throughput of peridynamic flow with heat: the cavity at a Rayleigh number of 1e4, once it flows.
/// Wall points count like any other; microseconds of processor time per point and step beside it.
namespace {

using namespace lapilli;

constexpr int warm_steps = 200;

double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Arguments: fluid points along a side, threads.
void cavity(benchmark::State& state) {
  set_thread_count(static_cast<int>(state.range(1)));
  Scene scene = load_scene(LAPILLI_EXAMPLES "/pd/cavity.toml");
  scene.grid.cell = 1.0 / static_cast<double>(state.range(0));
  const auto simulation = build(scene);
  for (int warm = 0; warm < warm_steps; ++warm) {
    simulation->step(scene.time.end, false);
  }
  const double cpu = seconds(CLOCK_PROCESS_CPUTIME_ID), wall = seconds(CLOCK_MONOTONIC);
  for (auto _ : state) {
    simulation->step(scene.time.end, false);
  }
  const double cpu_taken = seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu;
  const double wall_taken = seconds(CLOCK_MONOTONIC) - wall;
  const auto steps = static_cast<double>(state.iterations() * simulation->points().size());
  state.counters["Mps/s"] = 1e-6 * steps / wall_taken;
  state.counters["Mps/s/core"] = 1e-6 * steps / cpu_taken;
  state.counters["cpu/wall"] = cpu_taken / wall_taken;
  state.counters["us"] = 1e6 * cpu_taken / steps;
  set_thread_count(0);
}

BENCHMARK(cavity)->ArgsProduct({{80, 320}, {1, 2}})->ArgNames({"side", "threads"})->UseRealTime();

}  // namespace
