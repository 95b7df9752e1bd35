#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/geometry/fill.hpp"
#include "lapilli/mpm/quasi_static/equilibrium.hpp"
#include "lapilli/mpm/quasi_static/quasi_static.hpp"

namespace lapilli::test {

/// E = 1000 MPa, nu = 0.3, in N and mm: the material of every case of Cortis et al.
inline const LinearElastic elastic{1e-9, 1000.0, 0.3};
inline const double constrained_modulus = elastic.wave_modulus();

using Corners = std::vector<Vec<2>>;

/// A rectangle with its first corner at `corner`, sides along e1 and e2 = e1 turned by 90 degrees.
struct Rectangle {
  Vec<2> corner, e1, e2;
  double length, height;

  static Rectangle turned(double degrees, Vec<2> at, double along, double across) {
    double c = std::cos(degrees * std::numbers::pi / 180.0);
    double s = std::sin(degrees * std::numbers::pi / 180.0);
    c = std::abs(c) < 1e-15 ? 0.0 : c;
    s = std::abs(s) < 1e-15 ? 0.0 : s;
    return {at, {c, s}, {-s, c}, along, across};
  }
  Vec<2> at(double x, double y) const { return corner + x * e1 + y * e2; }
  Vec<2> local(const Vec<2>& x) const { return {(x - corner).dot(e1), (x - corner).dot(e2)}; }
  Corners corners() const { return {at(0, 0), at(length, 0), at(length, height), at(0, height)}; }
};

inline std::vector<std::vector<double>> numbers(const Corners& corners) {
  std::vector<std::vector<double>> rows;
  for (const Vec<2>& corner : corners) {
    rows.push_back({corner[0], corner[1]});
  }
  return rows;
}

inline Shape polygon(const Corners& corners) { return Polygon{numbers(corners)}; }

/// The grid of cells of size h on multiples of h (plus `origin`) that holds all places.
inline Grid<2> grid_around(const Corners& places, double h, double margin = 1.0,
                           Vec<2> origin = Vec<2>::Zero()) {
  Vec<2> low = places[0], high = places[0];
  for (const Vec<2>& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  for (int axis = 0; axis < 2; ++axis) {
    low[axis] = origin[axis] + h * (std::floor((low[axis] - origin[axis]) / h + 1e-9) - margin);
    high[axis] = origin[axis] + h * (std::ceil((high[axis] - origin[axis]) / h - 1e-9) + margin);
  }
  return Grid<2>(low, high, h);
}

/// m x m points per cell, the boxes cut by the shape: exact volume and centroid.
inline void fill_clipped(Points& points, const Grid<2>& grid, const Shape& shape, int m) {
  FillOptions options;
  options.clip = true;
  options.smallest_volume = 0.0;
  const Vec3 lower(grid.lower()[0], grid.lower()[1], 0.0);
  const FilledPoints filled = fill(shape, Lattice{lower, grid.cell_size(), m}, options, 2);
  points.append(filled.position, filled.volume, 0);
}

/// One wall of a linear problem: an open line, and its motion.
struct LineWall {
  Corners line;  // the material on its left
  HeldMotion kind = HeldMotion::fixed;
  Vec<2> motion = Vec<2>::Zero();
};

/// One linear load step, with every part open to the tests.
struct LinearProblem {
  LinearProblem(const Grid<2>& on, const Shape& body, int m) : grid(on) {
    fill_clipped(points, grid, body, m);
  }

  /// `change` may alter the facets before they are used.
  template <class Change>
  void solve(const std::vector<LineWall>& walls, const SupportScheme& scheme, double ghost,
             Vec<2> body_force, const Change& change) {
    weights.build(grid, points.position(), {});
    state = std::make_unique<CellState<2>>(grid, std::as_const(points).volume(), points.body(),
                                           weights, materials);
    std::vector<Facet<2>> facets;
    for (std::size_t w = 0; w < walls.size(); ++w) {
      for (auto& facet : cut_line(grid, walls[w].line, static_cast<int>(w))) {
        facets.push_back(facet);
      }
    }
    facets = facets_at_material(grid, *state, facets, true);
    loads.ghost = ghost;
    loads.ghost_pairs = ghost_pairs<2>(grid, *state, facets);
    loads.body_force.assign(points.size(), body_force);
    loads.walls.clear();
    for (Facet<2>& facet : facets) {
      change(facet);
      const LineWall& wall = walls[facet.surface];
      const std::vector<Vec<2>> motion(facet.points.size(), wall.motion);
      loads.walls.push_back(support_term<2>(grid, *state, facet, wall.kind, motion, scheme));
    }
    solids = std::make_unique<SolidState>(points, std::vector<Solid>{elastic});
    equilibrium =
        std::make_unique<Equilibrium<2>>(grid, std::as_const(points).volume(), points.body(),
                                         weights, *state, *solids, loads, system, solver);
    pivots = equilibrium->factorise();
    u = Eigen::VectorXd::Zero(system.unknowns());
    newton = solve_newton(
        u, [&](const auto& at) { return equilibrium->residual(at); },
        [&](const auto& force) { return equilibrium->correction(force); }, 1e-10, 10);
  }
  void solve(const std::vector<LineWall>& walls, const SupportScheme& scheme, double ghost,
             Vec<2> body_force = Vec<2>::Zero()) {
    solve(walls, scheme, ghost, body_force, [](Facet<2>&) {});
  }

  double volume() const {
    double sum = 0.0;
    for (double v : points.volume()) {
      sum += v;
    }
    return sum;
  }
  Mat<2> stress_at(Index p) const {
    return stress_of(elastic, equilibrium->strain(p, u)).block<2>();
  }
  Vec<2> moved(Index p) const { return equilibrium->displacement(p, u); }

  Grid<2> grid;
  Points points{2};
  std::vector<LinearElastic> materials{elastic};
  PointWeights<2> weights;
  std::unique_ptr<CellState<2>> state;
  Loads<2> loads;
  std::unique_ptr<SolidState> solids;
  NodeSystem<2> system;
  DirectSolver solver;
  std::unique_ptr<Equilibrium<2>> equilibrium;
  PivotReport pivots;
  NewtonReport newton;
  Eigen::VectorXd u;
};

inline const SupportScheme literal_scheme = SupportScheme::of(Enforcement::literal, 1e-6, 0.05);
inline const SupportScheme default_scheme = SupportScheme::of(Enforcement::mean_gap, 1e-3, 0.05);

}  // namespace lapilli::test
