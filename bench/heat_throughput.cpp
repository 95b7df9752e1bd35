#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>

#include "lapilli/core/parallel.hpp"
#include "lapilli/scene/build.hpp"

/// Throughput of heat conduction: million point-steps per second, double precision, with the ratio
/// of CPU to wall time that tells whether the threads had their cores to themselves.
namespace {

using namespace lapilli;

struct Setting {
  int dimension;
  int cells;            // along each axis
  int points_per_cell;  // in a full cell
  bool moving;
  ShapeFunction shape;
  HeatTransfer transfer;
  bool convection;
};

Scene scene_of(const Setting& setting) {
  const auto axes = static_cast<std::size_t>(setting.dimension);
  Scene scene;
  scene.grid.cell = 1.0 / setting.cells;
  // A margin of two cells, for bodies that move.
  scene.grid.lower.assign(axes, -2.0 * scene.grid.cell);
  scene.grid.upper.assign(axes, 1.0 + 2.0 * scene.grid.cell);
  scene.grid.shape_function = setting.shape;
  Body body;
  Box box;
  box.lower.assign(axes, 0.0);
  box.upper.assign(axes, 1.0);
  body.shape = Shape(box);
  body.points_per_cell = setting.points_per_cell;
  Thermal material;
  material.density = 1.0;
  material.specific_heat = 1.0;
  material.conductivity = 1.0;
  body.material = {material};
  body.temperature = Value(ArrayFunction(
      [](std::span<const Vec3> x, std::span<const double>, double, std::span<double> temperature) {
        for (std::size_t k = 0; k < x.size(); ++k) {
          temperature[k] = std::sin(7.0 * x[k][0]) * std::cos(5.0 * x[k][1]);
        }
      }));
  if (setting.moving) {
    Translation motion;
    motion.velocity.assign(axes, 1.0);
    body.motion = motion;
  }
  scene.bodies = {body};
  HeatSettings heat;
  heat.transfer = setting.transfer;
  if (setting.convection) {
    Convection law;
    law.coefficient = 1.0;
    law.ambient = 1.0;
    heat.boundaries = {law};
  }
  scene.heat = heat;
  scene.time.end = 1e9;
  scene.time.step = 0.2 * scene.grid.cell * scene.grid.cell;
  return scene;
}

double seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void heat(benchmark::State& state, const Setting& setting) {
  set_thread_count(static_cast<int>(state.range(0)));
  const auto simulation = build(scene_of(setting));
  const double end = simulation->end();
  for (int warm = 0; warm < 3; ++warm) {
    simulation->step(end, false);
  }
  const double cpu = seconds(CLOCK_PROCESS_CPUTIME_ID), wall = seconds(CLOCK_MONOTONIC);
  for (auto _ : state) {
    simulation->step(end, false);
  }
  const double cpu_taken = seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu;
  const double wall_taken = seconds(CLOCK_MONOTONIC) - wall;
  const auto steps = static_cast<double>(state.iterations() * simulation->points().size());
  state.counters["Mps/s"] = 1e-6 * steps / wall_taken;
  state.counters["Mps/s/core"] = 1e-6 * steps / cpu_taken;
  state.counters["cpu/wall"] = cpu_taken / wall_taken;
  set_thread_count(0);
}

#define LAPILLI_BENCH(name, ...) \
  BENCHMARK_CAPTURE(heat, name, Setting{__VA_ARGS__})->Arg(1)->Arg(2)->UseRealTime()

constexpr auto linear = ShapeFunction::linear;
constexpr auto gimp = ShapeFunction::gimp;
constexpr auto flip = HeatTransfer::flip;

LAPILLI_BENCH(moving_2d_linear_flip, 2, 200, 4, true, linear, flip, false);
LAPILLI_BENCH(moving_2d_gimp_affine_convection, 2, 200, 4, true, gimp, HeatTransfer::affine, true);
LAPILLI_BENCH(moving_3d_linear_flip, 3, 40, 8, true, linear, flip, false);
LAPILLI_BENCH(moving_3d_gimp_affine_convection, 3, 40, 8, true, gimp, HeatTransfer::affine, true);
LAPILLI_BENCH(rest_2d_linear_flip_4, 2, 200, 4, false, linear, flip, false);
LAPILLI_BENCH(rest_2d_linear_flip_16, 2, 200, 16, false, linear, flip, false);
LAPILLI_BENCH(rest_2d_gimp_kept_convection_4, 2, 200, 4, false, gimp, HeatTransfer::nodal, true);
LAPILLI_BENCH(rest_3d_linear_flip_8, 3, 40, 8, false, linear, flip, false);
LAPILLI_BENCH(rest_3d_gimp_kept_convection_8, 3, 40, 8, false, gimp, HeatTransfer::nodal, true);

}  // namespace
