#include "lapilli/mpm/dynamics/obstacles/obstacle_contacts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lapilli/core/in_space.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/dynamics/friction_lag.hpp"
#include "lapilli/mpm/dynamics/obstacles/light_nodes.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"

namespace lapilli {
namespace {

/// Farthest a surface can be from a centre: the corners of its box, or of the grid where it ends
/// nowhere.
template <int Dim>
double farthest(const Grid<Dim>& grid, const Shape& shape, const Vec3& center) {
  const Bounds box = bounds(shape);
  double most = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    double lower = box.lower[axis], upper = box.upper[axis];
    if (!std::isfinite(lower) || !std::isfinite(upper)) {
      lower = grid.lower()[axis];
      upper = grid.upper()[axis];
    }
    const double far = std::max(std::abs(lower - center[axis]), std::abs(upper - center[axis]));
    most += far * far;
  }
  return std::sqrt(most);
}

}  // namespace

template <int Dim>
ObstacleContacts<Dim>::ObstacleContacts(const DynamicsData<Dim>& data, const Obstacle& obstacle,
                                        std::string name, const PointSkins& skins,
                                        const DynamicsProblem<Dim>& problem, int earlier)
    : obstacle_(obstacle),
      name_(std::move(name)),
      skin_(data.points, 2),
      motion_(obstacle, Dim, "dynamics.obstacles: " + name_),
      reach_(farthest(data.grid, obstacle.shape, motion_.center())),
      friction_(obstacle.contact == ObstacleContact::no_slip
                    ? std::numeric_limits<double>::infinity()
                    : obstacle.friction),
      memory_(data.points, kept) {
  for (const StressMaterial& material : data.materials) {
    lags_.push_back(friction_lag(material, data.grid.cell_size()));
  }
  const PointStart* before = problem.start.get();
  if (before != nullptr && earlier >= 0) {
    motion_.go_on(*before->state, message("dynamics/obstacles/", earlier));
  } else {
    motion_.set_span(before != nullptr ? before->time : 0.0, 0.0);
    require_nothing_inside(data);
  }
  set_skins(data, skins, problem, earlier);
}

template <int Dim>
void ObstacleContacts<Dim>::set_skins(const DynamicsData<Dim>& data, const PointSkins& skins,
                                      const DynamicsProblem<Dim>& problem, int earlier) {
  const PointStart* before = problem.start.get();
  const Points& points = data.points;
  parallel_for(points.size(), [&](Index row) {
    const bool goes_on = before != nullptr && before->state && before->row[points.id()[row]] >= 0;
    const DynamicsBody& body = problem.bodies[static_cast<std::size_t>(points.body()[row])];
    double* skin = skin_.data() + row * skin_.components();
    skin[1] = points.volume()[row];
    skin[0] = goes_on ? skins.of(row) : skins.towards(points, body, row, [&](const Vec3& place) {
      return Vec3(-normal_at(place));
    });
  });
  const std::string known = message("dynamics/obstacles/", earlier, "/skins");
  if (before != nullptr && earlier >= 0 && before->state->contains(known)) {
    before->fetch(known, data.points, skin_);
  }
}

/// Impulses of the step before, those of points that were in contact then.
template <int Dim>
void ObstacleContacts<Dim>::start_from(double scale) {
  for (Contact<Dim>& contact : contacts_) {
    const double* memory = memory_.data() + contact.row * kept;
    const bool known = std::floor(memory[stamp]) == steps_ && steps_ > 0.0;
    contact.push = known ? scale * memory[held] : 0.0;
    contact.past = known ? scale * memory[held + 1 + Dim] : -1.0;
    for (int axis = 0; axis < Dim; ++axis) {
      contact.drag[axis] = known ? scale * memory[held + 1 + axis] : 0.0;
    }
  }
}

template <int Dim>
void ObstacleContacts<Dim>::keep() {
  for (const Contact<Dim>& contact : contacts_) {
    double* memory = memory_.data() + contact.row * kept;
    memory[held] = contact.push;
    std::copy_n(contact.drag.data(), Dim, memory + held + 1);
    memory[held + 1 + Dim] = std::max(0.0, contact.felt());
  }
}

template <int Dim>
void ObstacleContacts<Dim>::meet(DynamicsData<Dim>& data) {
  const AxisArrays<Dim> velocity = data.nodes.velocities();
  const AxisArrays<Dim> increment = data.nodes.increments();
  light_ = find_light_nodes(data, contacts_);
  leave_out(light_, contacts_);
  for (auto* contacts : {&contacts_, &light_}) {
    for (Contact<Dim>& contact : *contacts) {
      contact.approach = contact.at_foot(velocity);
      contact.start = contact.approach - contact.at_foot(increment);
    }
  }
}

template <int Dim>
void ObstacleContacts<Dim>::begin(DynamicsData<Dim>& data, double step,
                                  std::vector<double>& crowd) {
  const AxisArrays<Dim> velocity = data.nodes.velocities();
  start_from(last_step_ > 0.0 ? step / last_step_ : 0.0);
  hold_light_nodes<Dim>(light_, data.nodes.mass(), velocity, motion_, contacts_);
  begin_contacts<Dim>(contacts_, data.nodes.mass(), velocity, motion_, crowd);
}

template <int Dim>
void ObstacleContacts<Dim>::sweep(DynamicsData<Dim>& data) {
  const AxisArrays<Dim> velocity = data.nodes.velocities();
  sweep_contacts<Dim>(contacts_, joint_, friction_, data.nodes.mass(), velocity, motion_);
}

template <int Dim>
typename ObstacleContacts<Dim>::Work ObstacleContacts<Dim>::finish(DynamicsData<Dim>& data,
                                                                   double step) {
  const AxisArrays<Dim> velocity = data.nodes.velocities();
  keep();
  last_step_ = step;
  force_.setZero();
  torque_.setZero();
  Work work;
  book(contacts_, velocity, step, work);
  book(light_, velocity, step, work);
  work_ += work.given;
  return work;
}

template <int Dim>
void ObstacleContacts<Dim>::free_nodes(const DynamicsData<Dim>& data,
                                       FreedNodes<Dim>& nodes) const {
  for (const auto* contacts : {&contacts_, &light_}) {
    nodes.add(data, *contacts, [this](const Vec3& place) { return clearance(place); });
  }
}

/// What the impulses of the step did: they work on the mean of the velocities before and after it.
template <int Dim>
void ObstacleContacts<Dim>::book(std::vector<Contact<Dim>>& contacts,
                                 const AxisArrays<Dim>& velocity, double step, Work& work) {
  for (Contact<Dim>& contact : contacts) {
    const Vec<Dim> after = contact.at_foot(velocity), impulse = contact.impulse();
    contact.solved = after;
    const Vec<Dim> wall = motion_.mean_velocity(in_space<Dim>(contact.foot)).template head<Dim>();
    const Vec<Dim> slip = 0.5 * (contact.start + after) - wall;
    work.kinetic += impulse.dot(0.5 * (contact.approach + after));
    work.given += impulse.dot(wall);
    work.impact += contact.push * contact.normal.dot(slip);
    work.friction += contact.drag.dot(slip);
    const Vec3 given = in_space<Dim>(impulse);
    impulse_ += given;
    force_ -= given / step;
    torque_ -= (in_space<Dim>(contact.foot) - motion_.center()).cross(given) / step;
  }
}

template <int Dim>
void ObstacleContacts<Dim>::sweep_second(DynamicsData<Dim>& data) {
  const AxisArrays<Dim> velocity = data.nodes.second_velocities();
  match_contacts<Dim>(contacts_, data.nodes.mass(), velocity);
}

template <int Dim>
void ObstacleContacts<Dim>::finish_second(DynamicsData<Dim>& data) {
  const AxisArrays<Dim> velocity = data.nodes.second_velocities();
  match_light_nodes<Dim>(light_, velocity);
}

template <int Dim>
void ObstacleContacts<Dim>::finish_step() {
  steps_ += 1.0;
  for (const Contact<Dim>& contact : contacts_) {
    memory_[contact.row * kept + stamp] = steps_ + (contact.bonded ? bond : 0.0);
  }
}

template <int Dim>
Index ObstacleContacts<Dim>::touching() const {
  return std::count_if(contacts_.begin(), contacts_.end(),
                       [](const Contact<Dim>& contact) { return contact.acts(); });
}

template <int Dim>
void ObstacleContacts<Dim>::save(Archive& archive, const std::string& prefix) const {
  archive.write(prefix + "/memory", memory_.values());
  archive.write(prefix + "/skins", skin_.values());
  motion_.save(archive, prefix);
  std::vector<double> numbers;
  for (const Vec3* vector : {&force_, &torque_, &impulse_}) {
    numbers.insert(numbers.end(), vector->data(), vector->data() + 3);
  }
  numbers.insert(numbers.end(), {work_, steps_, last_step_});
  archive.write(prefix + "/numbers", std::span<const double>(numbers));
}

template <int Dim>
void ObstacleContacts<Dim>::load(const Archive& archive, const std::string& prefix) {
  archive.read(prefix + "/memory", memory_.values());
  archive.read(prefix + "/skins", skin_.values());
  motion_.load(archive, prefix);
  double numbers[12];
  archive.read(prefix + "/numbers", std::span<double>(numbers));
  const double* from = numbers;
  for (Vec3* vector : {&force_, &torque_, &impulse_}) {
    std::copy_n(from, 3, vector->data());
    from += 3;
  }
  work_ = numbers[9];
  steps_ = numbers[10];
  last_step_ = numbers[11];
}

template class ObstacleContacts<2>;
template class ObstacleContacts<3>;

}  // namespace lapilli
