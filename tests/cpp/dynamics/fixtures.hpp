#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/simulation.hpp"
#include "lapilli/mpm/dynamics/dynamics.hpp"

/// Small momentum problems, built the way a scene would.
namespace dynamics_test {

using namespace lapilli;

inline LinearElastic elastic(double density, double young, double poisson) {
  return {density, young, poisson};
}

inline MohrCoulomb soil(double young, double friction, double cohesion = 0.0) {
  MohrCoulomb material;
  material.elastic = {2000.0, young, 0.3};
  material.friction_angle = friction;
  material.cohesion = cohesion;
  return material;
}

/// Points of a lattice of `per_axis` a cell wherever `inside` says so.
template <int Dim>
void fill(Points& points, const Grid<Dim>& grid, int per_axis,
          const std::function<bool(const Vec<Dim>&)>& inside, int body = 0) {
  const double spacing = grid.cell_size() / per_axis;
  std::vector<double> positions, volumes;
  Eigen::Matrix<Index, Dim, 1> count;
  Index total = 1;
  for (int axis = 0; axis < Dim; ++axis) {
    count[axis] = std::lround((grid.upper()[axis] - grid.lower()[axis]) / spacing);
    total *= count[axis];
  }
  for (Index k = 0; k < total; ++k) {
    Index rest = k;
    Vec<Dim> place;
    for (int axis = 0; axis < Dim; ++axis) {
      place[axis] = grid.lower()[axis] + (static_cast<double>(rest % count[axis]) + 0.5) * spacing;
      rest /= count[axis];
    }
    if (inside(place)) {
      positions.insert(positions.end(), place.data(), place.data() + Dim);
      volumes.push_back(std::pow(spacing, Dim));
    }
  }
  points.append(positions, volumes, body);
}

/// A problem, its points and the solver, and the step that its clock would take.
template <int Dim>
struct Run {
  Run(const Grid<Dim>& grid, ShapeFunction shape) : points(Dim), problem{grid, shape, {}, {}} {}

  void add(DynamicsBody body, int per_axis, const std::function<bool(const Vec<Dim>&)>& inside) {
    body.half_width = 0.5 / per_axis;
    fill<Dim>(points, problem.grid, per_axis, inside, static_cast<int>(problem.bodies.size()));
    problem.bodies.push_back(std::move(body));
  }
  static GridFace face(int axis, int side) { return static_cast<GridFace>(2 * axis + side); }
  void no_slip(int axis, int side) {
    problem.settings.grid_boundaries.push_back(NoSlipBoundary{face(axis, side)});
  }
  void roller(int axis, int side) {
    problem.settings.grid_boundaries.push_back(RollerBoundary{face(axis, side)});
  }
  void frictional(int axis, int side, double coefficient) {
    problem.settings.grid_boundaries.push_back(FrictionalBoundary{face(axis, side), coefficient});
  }
  void start(int threads = 1) {
    set_thread_count(threads);
    solver = make_dynamics<Dim>(points, problem);
  }

  double automatic_step() const { return solver->step_limit().automatic; }
  void advance(double size) {
    solver->advance({time, size, index++});
    time += size;
  }
  /// Automatic steps, the last one cut.
  void until(double end) {
    while (time < end * (1 - 1e-12)) {
      advance(std::min(automatic_step(), end - time));
    }
  }
  double value(const char* diagnostic) const {
    for (const auto& [name, number] : solver->diagnostics()) {
      if (name == diagnostic) {
        return number;
      }
    }
    throw std::invalid_argument(diagnostic);
  }

  Points points;
  DynamicsProblem<Dim> problem;
  std::unique_ptr<Dynamics<Dim>> solver;
  double time = 0.0;
  Index index = 0;
};

inline const VelocityTransfer all_transfers[] = {VelocityTransfer::blended_apic,
                                                 VelocityTransfer::flip, VelocityTransfer::apic,
                                                 VelocityTransfer::tpic};
inline const ShapeFunction all_shapes[] = {ShapeFunction::linear, ShapeFunction::gimp,
                                           ShapeFunction::bspline};
inline const StressUpdate all_updates[] = {StressUpdate::usl, StressUpdate::musl};

/// Under linear functions the affine transfers are refused, but for the blend.
inline bool is_refused(VelocityTransfer transfer, ShapeFunction shape) {
  return shape == ShapeFunction::linear &&
         (transfer == VelocityTransfer::apic || transfer == VelocityTransfer::tpic);
}

}  // namespace dynamics_test
