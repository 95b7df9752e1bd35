// Processor seconds (of all threads, so that other work on the machine does not count) of one load
// step of a square block of N x N cells, 4 points each, on rollers that fit no grid line, under its
// weight; phase by phase. Usage: load_step [cells a side ...]
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "lapilli/geometry/cell_fill.hpp"
#include "lapilli/geometry/fill.hpp"
#include "lapilli/mpm/quasi_static/quasi_static.hpp"

using namespace lapilli;

namespace {

class Stopwatch {
 public:
  double lap() {
    const std::clock_t now = std::clock();
    const double seconds = static_cast<double>(now - last_) / CLOCKS_PER_SEC;
    last_ = now;
    return seconds;
  }

 private:
  std::clock_t last_ = std::clock();
};

void measure(int cells) {
  const double h = 1.0 / cells, low = 0.3 * h, high = 1.0 - 0.4 * h;
  const LinearElastic elastic{1000.0, 1e9, 0.3};
  const Grid<2> grid(Vec<2>(0.0, 0.0), Vec<2>(1.0, 1.0), h);
  const Shape block = Box{{low, low}, {high, high}};
  Points points(2);
  const FilledPoints filled = fill_cells(block, Lattice{Vec3::Zero(), h, 2}, {}, 2);
  points.append(filled.position, filled.volume, 0);
  QuasiStaticSettings settings;
  const auto wall = [](const char* name, double x, double y, double out_x, double out_y) {
    const Shape half = HalfSpace{{x, y}, {out_x, out_y}};
    return SupportSettings{name, HeldMotion::roller, {half, false, {}, {}}, {}, 0.0};
  };
  settings.supports = {wall("left", low, 0.0, 1.0, 0.0), wall("right", high, 0.0, -1.0, 0.0),
                       wall("base", 0.0, low, 0.0, 1.0)};
  settings.body_force = {0.0, Table{{0.0, 1.0}, {0.0, -1e3}}};

  Stopwatch watch;
  QuasiStatic<2> physics(points, grid, ShapeFunction::linear, {elastic}, settings);
  const double set_up = watch.lap();
  physics.advance({0.0, 0.5, 0});
  const double first = watch.lap();
  physics.advance({0.5, 0.5, 1});
  const double second = watch.lap();

  // The same system by hand, to tell assembly from factorisation.
  const std::vector<LinearElastic> materials{elastic};
  const Boundary<2> boundary(settings);
  Reference<2> reference(points, false);
  reference.start(points, nullptr, 1.0);
  reference.locate(grid, points, materials, std::vector<char>{0}, boundary);
  Loads<2> loads;
  for (const Facet<2>& facet : reference.facets) {
    const std::vector<Vec<2>> still(facet.points.size(), Vec<2>::Zero());
    loads.walls.push_back(support_term<2>(grid, *reference.state, facet, HeldMotion::roller, still,
                                          SupportScheme::of(Enforcement::mean_gap, 1e-3, 0.05)));
  }
  loads.ghost = 0.01;
  loads.ghost_pairs = ghost_pairs<2>(grid, *reference.state, reference.facets);
  const SolidState solids(points, {elastic});
  NodeSystem<2> system;
  DirectSolver solver;
  watch.lap();
  Equilibrium<2> equilibrium(grid, std::as_const(points).volume(), points.body(), reference.weights,
                             *reference.state, solids, loads, system, solver);
  const double analysis = watch.lap();
  equilibrium.factorise();
  const double both = watch.lap();
  solver.factorise(system.lower());
  const double factor = watch.lap();
  std::printf("%6d %9lld %8.2f %8.2f %8.2f %8.2f %8.2f %8.2f %7.1f %%\n", cells,
              static_cast<long long>(system.unknowns()), set_up, first, second, analysis,
              both - factor, factor, 100.0 * (both - factor) / first);
}

}  // namespace

int main(int count, char** values) {
  std::printf("%6s %9s %8s %8s %8s %8s %8s %8s %9s\n", "cells", "unknowns", "set-up", "step 1",
              "step 2", "analyse", "assemble", "factor", "assembly");
  if (count < 2) {
    for (const int cells : {100, 200, 400}) {
      measure(cells);
    }
  }
  for (int k = 1; k < count; ++k) {
    measure(std::atoi(values[k]));
  }
}
