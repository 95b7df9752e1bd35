#include <catch2/catch.hpp>

#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

struct BlockOptions {
  WallScheme scheme = WallScheme::of(WallForm::pointwise, 1e-6, 0.05);
  double ghost = 0.0;
  int m = 1;
  bool relocate = true;
  bool mirror_normals = false;
};

struct BlockResult {
  double displacement = 0.0, stress = 0.0, across = 0.0, shear = 0.0, volume = 0.0;
  Index points = 0;
  double condition = 0.0;
  PivotReport pivots;
};

/// Cortis et al. 5.1: a square of 100 mm turned about its corner, three rollers, the fourth moved by
/// 1 mm along e1. Relative errors in the mean over the points.
BlockResult solve_block(double degrees, const BlockOptions& options) {
  const Rectangle block = Rectangle::turned(degrees, Vec<2>::Zero(), 100.0, 100.0);
  const Corners c = block.corners();
  const Grid<2> grid = grid_around(c, 10.0);
  Points points(2);
  fill_clipped(points, grid, options.m,
               {{c[0], block.e1}, {c[1], -block.e1}, {c[0], block.e2}, {c[3], -block.e2}},
               options.relocate);
  PointWeights<2> weights;
  weights.build(grid, points, {});
  const std::vector<LinearElastic> materials{steel};
  CellState<2> state(grid, points, weights, materials);
  const std::vector<std::vector<Vec<2>>> lines{
      {c[3], c[0]}, {c[0], c[1]}, {c[1], c[2]}, {c[2], c[3]}};  // left, bottom, right, top
  std::vector<Facet<2>> facets;
  for (int k = 0; k < 4; ++k) {
    for (auto& facet : cut_line(grid, lines[k], k)) {
      facets.push_back(facet);
    }
  }
  facets = facets_at_material(grid, state, facets, true);
  Loads<2> loads;
  loads.ghost = options.ghost;
  loads.ghost_pairs = ghost_pairs<2>(grid, state, facets);
  for (Facet<2>& facet : facets) {
    if (options.mirror_normals) {
      for (auto& point : facet.points) {
        point.normal[1] = -point.normal[1];
      }
    }
    const std::vector<Vec<2>> motion(
        facet.points.size(), facet.surface == 2 ? block.e1 : Vec<2>(Vec<2>::Zero()));
    loads.walls.push_back(
        wall_term<2>(grid, state, facet, WallKind::roller, motion, options.scheme));
  }
  NodeSystem<2> system;
  DirectSolver solver;
  const std::vector<double> stress(6 * points.size(), 0.0);
  Equilibrium<2> equilibrium(grid, points, weights, state, materials, stress, loads, system, solver);
  BlockResult result;
  result.pivots = equilibrium.factorise();
  result.condition = solver.condition(system.lower());
  Eigen::VectorXd u = Eigen::VectorXd::Zero(system.unknowns());
  const NewtonReport newton = solve_newton(
      u, [&](const auto& at) { return equilibrium.residual(at); },
      [&](const auto& force) { return equilibrium.correction(force); }, 1e-10, 10);
  INFO("newton " << newton.iterations << " " << newton.residual);
  const double exact = 13.4615384615384615, exact_across = 5.76923076923076923;
  for (Index p = 0; p < points.size(); ++p) {
    const double v = points.volume()[p];
    const Vec<2> there = block.local(points.position<2>(p))[0] / 100.0 * block.e1;
    const Mat<2> s = stress_of(steel, equilibrium.strain(p, u)).block<2>();
    result.volume += v;
    result.displacement += v * (equilibrium.displacement(p, u) - there).norm() / there.norm();
    result.stress += v * std::abs(block.e1.dot(s * block.e1) / exact - 1.0);
    result.across = std::max(result.across,
                             std::abs(block.e2.dot(s * block.e2) / exact_across - 1.0));
    result.shear = std::max(result.shear, std::abs(block.e1.dot(s * block.e2)));
  }
  result.displacement /= result.volume;
  result.stress /= result.volume;
  result.points = points.size();
  std::printf("block %g: ru %.2e rs %.2e stt %.1e snt %.1e V %.12g n %ld cond %.1e dmin %.1e bad %ld newton %d %.1e\n", degrees,
              result.displacement, result.stress, result.across, result.shear, result.volume,
              result.points, result.condition, result.pivots.smallest, result.pivots.not_positive, newton.iterations, newton.residual);
  return result;
}

}  // namespace

TEST_CASE("contained block: pointwise and mean-gap pass the patch test") {
  for (double degrees : {0.0, 30.0, 45.0, 90.0}) {
    solve_block(degrees, {});
    BlockOptions o;
    o.scheme = WallScheme::of(WallForm::mean_gap, 1e-3, 0.05);
    o.ghost = 0.01;
    solve_block(degrees, o);
    o.ghost = 0;
    o.scheme = WallScheme::of(WallForm::penalty, 1e-6, 0.05);
    solve_block(degrees, o);
  }
  for (double degrees : {30.0, 45.0}) {
    BlockOptions o;
    o.mirror_normals = true;
    solve_block(degrees, o);
    o = {};
    o.relocate = false;
    solve_block(degrees, o);
    o = {};
    o.scheme.consistency = -1;
    solve_block(degrees, o);
    o.scheme.consistency = 0.5;
    solve_block(degrees, o);
  }
}
