#include "lapilli/mpm/dynamics/dynamics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/bounds.hpp"
#include "lapilli/mpm/dynamics/damp_nodes.hpp"
#include "lapilli/mpm/dynamics/early_stops.hpp"
#include "lapilli/mpm/dynamics/go_on.hpp"
#include "lapilli/mpm/dynamics/mean_free_strain.hpp"
#include "lapilli/mpm/dynamics/point_kernel.hpp"
#include "lapilli/mpm/dynamics/project_to_grid.hpp"
#include "lapilli/mpm/dynamics/stable_choice.hpp"
#include "lapilli/mpm/dynamics/update_points.hpp"

namespace lapilli {

template <int Dim>
Dynamics<Dim>::Dynamics(Points& points, const DynamicsProblem<Dim>& problem)
    : data_(points, problem) {
  require_stable_choice(data_);
  for (const DynamicsBody& body : problem.bodies) {
    spacing_.push_back(body.spacing);
  }
  start_affine(problem);
  if (problem.start && problem.start->state) {
    go_on(*problem.start, data_);
  } else {
    start_notes_ = early_stops(data_, problem.bodies);
  }
  if (problem.notes) {
    const std::vector<Note> notes = problem.notes();
    start_notes_.insert(start_notes_.end(), notes.begin(), notes.end());
  }
  data_.order.update(points);
  if (problem.bodies.size() > 1 || !problem.settings.contacts.empty()) {
    ContactGroups groups = contact_groups(data_, problem.bodies, problem.start.get());
    described_contacts_ = described(groups);
    contacts_ = make_contacts(data_, problem.bodies, std::move(groups));
  }
  wall_friction_ = make_wall_friction(data_);
  if (!problem.settings.boundaries.empty()) {
    loads_ = std::make_unique<SurfaceLoads<Dim>>(data_, problem);
  }
  if (!problem.settings.obstacles.empty()) {
    obstacles_ = std::make_unique<Obstacles<Dim>>(data_, problem);
  }
  ordering_ = points.ordering();
  for (Index row = 0; row < points.size(); ++row) {
    const StressMaterial& material = data_.materials[points.body()[row]];
    const double stiffness = material.wave_modulus * points.volume()[row] / data_.mass[row];
    wave_speed_ = std::max(wave_speed_, std::sqrt(stiffness));
    speed_ = std::max(speed_, Eigen::Map<const Vec<Dim>>(data_.velocity.data() + row * Dim).norm());
    total_mass_ += data_.mass[row];
  }
  kinetic_ = kinetic_energy();
  const double elastic = elastic_energy_stored();
  initial_energy_ = kinetic_ + potential_energy() + elastic;
  watch_ = EnergyWatch(elastic);
  initial_momentum_ = linear_momentum();
}

template <int Dim>
StepReport Dynamics<Dim>::advance(const Step& step) {
  if (data_.turned == nullptr && data_.points.carry_gradients()) {
    incremental_deformation();
  }
  keep_order(step.size);
  if (!data_.settings.gravity_factor.is_constant()) {
    turn_gravity(step);
  }
  book_waiting(step.size);
  project_to_grid(data_, step.size);
  if (loads_) {
    loads_->add_forces(data_, step.time, step.size);
  }
  const NodeSums nodes = solve_nodes(step);
  const double load_work_before = loads_ ? loads_->work() : 0.0;
  if (loads_) {
    loads_->book(data_, step.size);
  }
  const PointSums sums = move_points(step.size);
  stop_if_broken(sums);
  if (sums.outside) {
    find_outside();
  }
  book(step.size, nodes, sums, loads_ ? loads_->work() - load_work_before : 0.0);
  const double moved = step.size * std::max(speed_, sums.speed);
  drift_ += moved;
  if (obstacles_) {
    obstacles_->finish_step(step, moved, !data_.moves_with_mean, local_damping(step.time));
  }
  speed_ = sums.speed;
  wave_speed_ = sums.wave_speed;
  strain_rate_ = std::sqrt(sums.strain) / step.size;
  watch_energy(sums);
  if (open_energy_.is_due()) {
    look_at_energy(open_energy_);
  }
  carry_points();
  return {.accepted = step.size};
}

template <int Dim>
PointSums Dynamics<Dim>::move_points(double step) {
  PointSums velocities;
  if (data_.settings.stress_update == StressUpdate::musl) {
    velocities = update_velocities(data_, step);
    divide_second_velocity(data_);
    if (contacts_) {
      contacts_->push_second(data_, step);
    }
    if (obstacles_) {
      obstacles_->push_second(data_);
    }
    hold_second_velocity(data_, freed_nodes());
    if (data_.moves_with_mean) {
      take_mean_velocity(data_);
    }
  }
  if (data_.free_strain) {
    average_free_strain(data_);
  }
  PointSums sums = update_points(data_, step);
  sums.kinetic += velocities.kinetic;
  sums.speed = std::max(sums.speed, velocities.speed);
  return sums;
}

template <int Dim>
void Dynamics<Dim>::book(double step, const NodeSums& nodes, const PointSums& sums,
                         double load_work) {
  flows_.plastic += sums.plastic;
  flows_.expansion += sums.expansion;
  flows_.friction -= nodes.friction;
  flows_.impact -= nodes.impact;
  flows_.transfer += (kinetic_ - nodes.kinetic_before) + (nodes.kinetic_after - sums.kinetic);
  flows_.strain -= nodes.force_work - load_work + sums.strain_work;
  flows_.gravity += step * total_mass_ * data_.gravity;
  flows_.walls += nodes.wall_impulse;
  flows_.damping -= nodes.damping;
  flows_.damped += nodes.damping_impulse;
  kinetic_ = sums.kinetic;
}

/// The mean over the step; what the points' potential energy changes by, gravity puts in.
template <int Dim>
void Dynamics<Dim>::turn_gravity(const Step& step) {
  const Vec3 gravity = place(data_.settings.gravity) *
                       data_.settings.gravity_factor.mean(step.time, step.time + step.size);
  if (gravity == data_.gravity) {
    return;
  }
  const double before = potential_energy();
  data_.gravity = gravity;
  flows_.gravity_changes += potential_energy() - before;
}

/// Forces, then other bodies, then obstacles, then walls, which have the last word at the nodes
/// they share but for those inside of obstacles; damping takes from what all of them leave.
template <int Dim>
NodeSums Dynamics<Dim>::solve_nodes(const Step& step) {
  NodeSums sums = accelerate_nodes(data_, step.size);
  if (contacts_) {
    contacts_->push(data_, step.size, sums);
  }
  if (obstacles_) {
    obstacles_->push(data_, step, speed_, sums);
  }
  hold_nodes(data_, step.size, wall_friction_.get(), freed_nodes(), sums);
  if (const double damping = local_damping(step.time); damping > 0.0) {
    damp_nodes(data_, damping, sums);
  }
  if (data_.nodes.fades()) {
    blend_nodes(data_, step.size);
  }
  return sums;
}

/// The share in a step that begins at `time`.
template <int Dim>
double Dynamics<Dim>::local_damping(double time) const {
  const DynamicsSettings& settings = data_.settings;
  const bool is_over = settings.damping_until && time >= *settings.damping_until;
  return is_over ? 0.0 : settings.local_damping;
}

/// Gradients that other physics keep on the points turn and stretch with them.
template <int Dim>
void Dynamics<Dim>::carry_points() {
  if (data_.turned != nullptr || !data_.points.carry_gradients()) {
    data_.points.moved();
    return;
  }
  const double* gradient = data_.deformation->data();
  data_.points.template moved<Dim>([gradient](Index row) -> Mat<Dim> {
    using RowMajor = Eigen::Matrix<double, Dim, Dim, Eigen::RowMajor>;
    return Mat<Dim>::Identity() + Eigen::Map<const RowMajor>(gradient + row * Dim * Dim);
  });
}

/// Sort when points may have drifted half a cell: strips stay apart, and cells stay runs of points.
template <int Dim>
void Dynamics<Dim>::keep_order(double step) {
  const bool far = drift_ + step * speed_ > 0.5 * data_.grid.cell_size();
  if (far) {
    data_.order.sort(data_.points);
    data_.fields.place(data_.points);
    drift_ = 0.0;
  } else if (ordering_ != data_.points.ordering() || !data_.order.covers(data_.points)) {
    data_.order.update(data_.points);
  }
  ordering_ = data_.points.ordering();
}

template <int Dim>
void Dynamics<Dim>::stop_if_broken(const PointSums& sums) const {
  if (sums.outside && data_.settings.outside == Outside::stop) {
    require_inside(data_.grid, data_.points);
  }
  if (sums.least_volume > 0.0) {
    return;
  }
  for (Index row = 0; row < data_.points.size(); ++row) {
    if (!(data_.points.volume()[row] > 0.0)) {
      throw RunError(message("point ", data_.points.id()[row], " of body ",
                             data_.points.body()[row], ": its volume became ",
                             data_.points.volume()[row],
                             " in one step; the step is too large for this deformation"));
    }
  }
}

template <int Dim>
FindTouches Dynamics<Dim>::touches() {
  project_to_grid(data_, 0.0);
  contacts_->keep_touches(data_);
  return [this]() -> const std::vector<BodyTouch>& { return contacts_->touches(); };
}

template <int Dim>
const PointArray& Dynamics<Dim>::incremental_deformation() {
  if (!data_.deformation) {
    data_.deformation = std::make_unique<PointArray>(data_.points, Dim * Dim);
  }
  return *data_.deformation;
}

template <int Dim>
PointArray& Dynamics<Dim>::plastic_work() {
  if (!data_.plastic) {
    data_.plastic = std::make_unique<PointArray>(data_.points, 1);
  }
  return *data_.plastic;
}

template <int Dim>
PointArray& Dynamics<Dim>::free_strain() {
  if (!data_.free_strain) {
    data_.free_strain = std::make_unique<PointArray>(data_.points, 1);
  }
  return *data_.free_strain;
}

template <int Dim>
std::unique_ptr<Dynamics<Dim>> make_dynamics(Points& points, const DynamicsProblem<Dim>& problem) {
  return std::make_unique<Dynamics<Dim>>(points, problem);
}

template class Dynamics<2>;
template class Dynamics<3>;
template std::unique_ptr<Dynamics<2>> make_dynamics(Points&, const DynamicsProblem<2>&);
template std::unique_ptr<Dynamics<3>> make_dynamics(Points&, const DynamicsProblem<3>&);

}  // namespace lapilli
