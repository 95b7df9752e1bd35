#pragma once

#include <memory>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/materials/state_arrays.hpp"
#include "lapilli/mpm/dynamics/axis_arrays.hpp"
#include "lapilli/mpm/dynamics/cell_dilatation.hpp"
#include "lapilli/mpm/dynamics/dynamics_problem.hpp"
#include "lapilli/mpm/dynamics/grid_boundaries.hpp"
#include "lapilli/mpm/dynamics/stress_update.hpp"
#include "lapilli/mpm/transfer/cell_order.hpp"
#include "lapilli/mpm/transfer/node_fields.hpp"

namespace lapilli {

/// Nodal quantities, each an array over the nodes of the grid. `velocity` holds momentum until the
/// nodes are solved, `increment` the force; `strain_velocity` is the one that strains the points
/// (and gives TPIC its gradient): the same, except under linear functions, whose slope is whole on
/// nodes that carry next to nothing. `second_velocity` is what MUSL projects again and strains with
/// instead. With the blend, `fade` is the share of what points differ from a node by that they lose
/// to it in the step, and `gain` what the node hands them: its increment and that share of its
/// velocity.
template <int Dim>
class DynamicsNodes {
 public:
  DynamicsNodes(const Grid<Dim>& grid, ShapeFunction shape, const DynamicsSettings& settings);

  /// Whether light nodes strain with a velocity of their own.
  bool limits_strain() const { return limits_strain_; }
  /// Whether points forget at a rate of the nodes.
  bool fades() const { return fades_; }
  /// Whether local damping may act, which asks what of an increment is the internal force.
  bool damps() const { return damps_; }

  double* mass() { return array(0); }
  double* velocity(int axis) { return array(1 + axis); }
  double* increment(int axis) { return array(1 + Dim + axis); }
  double* strain_velocity(int axis) { return array(limited_ + axis); }
  double* second_velocity(int axis) { return array(1 + 2 * Dim + axis); }  // MUSL only
  double* gain(int axis) { return array(faded_ + axis); }                  // blended_apic only
  double* fade() { return array(faded_ + Dim); }                           // blended_apic only
  double* internal(int axis) { return array(damped_ + axis); }  // m/s a step; local damping only
  // The same along all axes.
  AxisArrays<Dim> velocities() { return arrays_from(1); }
  AxisArrays<Dim> increments() { return arrays_from(1 + Dim); }
  AxisArrays<Dim> strain_velocities() { return arrays_from(limited_); }
  AxisArrays<Dim> second_velocities() { return arrays_from(1 + 2 * Dim); }
  const double* mass() const { return array(0); }
  const double* velocity(int axis) const { return array(1 + axis); }
  const double* increment(int axis) const { return array(1 + Dim + axis); }
  const double* strain_velocity(int axis) const { return array(limited_ + axis); }
  const double* second_velocity(int axis) const { return array(1 + 2 * Dim + axis); }

  /// First and one-past-last node that points may touch, and zero what was projected there before.
  void clear(std::pair<int, int> layers);
  /// The same for nodes counted over several fields; makes room for them.
  void clear(Index count);
  /// Zero the second velocity alone.
  void clear_second_velocity();
  Index first() const { return first_; }
  Index last() const { return last_; }

 private:
  void clear_range(Index first, Index last);
  AxisArrays<Dim> arrays_from(int which) {
    AxisArrays<Dim> all;
    for (int axis = 0; axis < Dim; ++axis) {
      all.axis[axis] = array(which + axis);
    }
    return all;
  }
  double* array(int which) { return values_.data() + which * size_; }
  const double* array(int which) const { return values_.data() + which * size_; }

  bool limits_strain_, fades_, damps_;
  int arrays_;
  int limited_;  // first array of the strain velocity
  int faded_;    // first array of the gain
  int damped_;   // first array of the internal increment
  Index size_;   // of one array, with room for a quad past the last node
  Index layer_;  // nodes in one layer across the slowest axis
  Index first_ = 0, last_ = 0;
  LargeArray<double> values_;
};

/// Everything the phases of a momentum step work on.
template <int Dim>
struct DynamicsData {
  static constexpr int stress_components = Dim == 2 ? 4 : 6;

  DynamicsData(Points& of_points, const DynamicsProblem<Dim>& problem);

  /// Zero what is projected to the nodes of all fields.
  void clear_nodes();

  Grid<Dim> grid;
  ShapeFunction shape;
  DynamicsSettings settings;
  Vec3 gravity = Vec3::Zero();  // m/s^2
  Walls walls;
  std::vector<double> half_widths;        // by body, cells
  std::vector<StressMaterial> materials;  // by body
  Points& points;
  PointArray mass;                          // kg (per metre of depth in 2D)
  PointArray velocity;                      // m/s
  PointArray stress;                        // Pa; xx yy zz xy, and yz xz in 3D
  std::unique_ptr<PointArray> affine;       // gradient, 1/s; APIC: sum v (x_I - x) S, m2/s
  std::unique_ptr<PointArray> carried;      // m/s, what moved the point last; with `affine`
  std::unique_ptr<PointArray> opened;       // volume strain between grains that have parted
  std::unique_ptr<PointArray> strain_rate;  // 1/s, of the nodes around it, last; blended_apic
  std::unique_ptr<PointArray> deformation;  // incremental deformation gradient minus one, on demand
  PointArray* turned = nullptr;             // gradient of another physics that follows the points
  std::unique_ptr<PointArray> plastic;      // J dissipated since last taken, on demand
  std::unique_ptr<PointArray> free_strain;  // isotropic strain of the next step, on demand
  LargeArray<double> cell_strain;           // its means over cells
  StateArrays states;                       // of the solids
  double empty_node = 0.0;                  // kg; what lighter nodes could move is lost in rounding
  bool moves_with_mean = false;  // of the velocities before and after a step, not with the latter
  CellOrder<Dim> order;
  NodeFields<Dim> fields;
  DynamicsNodes<Dim> nodes;
  std::unique_ptr<CellDilatation<Dim>> dilatation;  // null where no body is averaged

 private:
  /// Of the arrays and operators that only some problems need.
  void make_optional_arrays(const DynamicsProblem<Dim>& problem);
  /// Mass, velocity and stress of every point.
  void start_points(const DynamicsProblem<Dim>& problem);
};

/// Mass of a cell full of the lightest material, kg.
template <int Dim>
double full_cell(const DynamicsData<Dim>& data);

/// What one sweep over the points found.
struct PointSums {
  double kinetic = 0.0;       // J, affine part included
  double plastic = 0.0;       // J dissipated in this step
  double strain_work = 0.0;   // J of the stress on the strain of this step
  double work_ahead = 0.0;    // J, half the work of the stress reached on this strain
  double expansion = 0.0;     // J given by the free strain of this step
  double speed = 0.0;         // m/s, largest of point and of its place
  double wave_speed = 0.0;    // m/s, largest
  double strain = 0.0;        // largest square of a strain of this step
  double least_volume = 1.0;  // least determinant of the incremental deformation
  bool outside = false;       // a point left the grid, or is not finite

  PointSums& operator+=(const PointSums& other);
};

}  // namespace lapilli
