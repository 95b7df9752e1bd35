#include "lapilli/mpm/dynamics/obstacles/obstacles.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"

namespace lapilli {
namespace {

constexpr const char* axes[] = {"x", "y", "z"};

/// Where a free obstacle is and how it moves.
template <int Dim>
void add_motion(const std::string& name, const RigidMotion& motion,
                std::vector<std::pair<std::string, double>>& all) {
  for (int axis = 0; axis < Dim; ++axis) {
    all.emplace_back(message(name, " position ", axes[axis]), motion.center()[axis]);
    all.emplace_back(message(name, " velocity ", axes[axis]), motion.velocity_of_center()[axis]);
  }
  for (int axis = Dim == 2 ? 2 : 0; axis < 3; ++axis) {
    all.emplace_back(message(name, " spin ", axes[axis]), motion.spin()[axis]);
  }
  if (Dim == 2) {
    all.emplace_back(message(name, " angle"), motion.angle());
  }
  all.emplace_back(message(name, " kinetic energy"), motion.kinetic_energy());
}

}  // namespace

template <int Dim>
Obstacles<Dim>::Obstacles(const DynamicsData<Dim>& data, const DynamicsProblem<Dim>& problem)
    : skins_(data.points, problem.bodies, data.grid.cell_size(), problem.start.get()),
      freed_(data) {
  int index = 0;
  const PointStart* before = problem.start.get();
  for (const Obstacle& obstacle : data.settings.obstacles) {
    const std::string name = name_of(obstacle, static_cast<std::size_t>(index));
    const int earlier =
        before != nullptr && !before->obstacle.empty() ? before->obstacle[index] : -1;
    each_.push_back(
        std::make_unique<ObstacleContacts<Dim>>(data, obstacle, name, skins_, problem, earlier));
    ++index;
  }
}

template <int Dim>
void Obstacles<Dim>::push(DynamicsData<Dim>& data, const Step& step, double speed, NodeSums& sums) {
  // Where points act in the middle of the step, obstacles do too.
  const double ahead = data.moves_with_mean ? 0.0 : 0.5 * step.size;
  const Index first = data.nodes.first(), count = data.nodes.last() - first;
  crowd_.resize(static_cast<std::size_t>(data.fields.node_count()), 0.0);
  for (int axis = 0; axis < Dim; ++axis) {
    const double* velocity = data.nodes.velocity(axis) + first;
    before_[axis].assign(velocity, velocity + count);
  }
  for (const auto& one : each_) {
    one->motion().advance(step.time, ahead);
    one->motion().set_span(step.time, step.size);
    if (one->motion().is_free()) {
      one->motion().accelerate(step.time, step.size, data.gravity);
    }
  }
  const double reach = step.size * (speed + this->speed());
  for (const auto& one : each_) {
    one->find(data, step.size, travelled_, reach);
    one->join_ends(data, step.size, travelled_, [&](const Vec3& place) {
      return std::ranges::any_of(each_, [&](const auto& other) {
        return other != one && other->is_at(place, data.grid.cell_size());
      });
    });
    one->meet(data);
  }
  solve(data, step.size);
  for (const auto& one : each_) {
    const auto work = one->finish(data, step.size);
    given_ += work.given;
    sums.friction += work.friction;
    sums.impact += work.impact;
    sums.kinetic_after += work.kinetic;
  }
  freed_.clear();
  for (const auto& one : each_) {
    one->free_nodes(data, freed_);
  }
  const double* mass = data.nodes.mass() + first;
  for (int axis = 0; axis < Dim; ++axis) {
    const double* velocity = data.nodes.velocity(axis) + first;
    double* increment = data.nodes.increment(axis) + first;
    const double gravity = step.size * data.gravity[axis];
    double work = 0.0;
    for (Index node = 0; node < count; ++node) {
      const double change = velocity[node] - before_[axis][node];
      if (change != 0.0) {
        work += 0.5 * mass[node] * (increment[node] - gravity) * change;
        increment[node] += change;
        if (data.nodes.limits_strain()) {
          data.nodes.strain_velocity(axis)[first + node] += change;
        }
      }
    }
    sums.force_work += work;
  }
}

/// In turns: each after the other, the last would push what it shares into the first, step by step.
template <int Dim>
void Obstacles<Dim>::solve(DynamicsData<Dim>& data, double step) {
  for (const auto& one : each_) {
    one->begin(data, step, crowd_);
  }
  for (int sweep = 0; sweep < contact_sweeps; ++sweep) {
    for (const auto& one : each_) {
      one->sweep(data);
    }
  }
}

template <int Dim>
void Obstacles<Dim>::push_second(DynamicsData<Dim>& data) {
  for (int sweep = 0; sweep < contact_sweeps; ++sweep) {
    for (const auto& one : each_) {
      one->sweep_second(data);
    }
  }
  for (const auto& one : each_) {
    one->finish_second(data);
  }
}

template <int Dim>
void Obstacles<Dim>::finish_step(const Step& step, double moved, bool ahead, double damping) {
  const double done = ahead ? 0.5 * step.size : 0.0;
  double fastest = 0.0;
  for (const auto& one : each_) {
    fastest = std::max(fastest, one->speed());
    if (one->motion().is_free()) {
      if (damping > 0.0) {
        one->motion().damp(damping);
      }
      one->motion().finish(step.size, done);
    } else {
      one->motion().advance(step.time + done, step.size - done);
      one->motion().set_span(step.time + step.size, 0.0);
    }
    one->finish_step();
    fastest = std::max(fastest, one->speed());
  }
  travelled_ += moved + step.size * fastest;
}

template <int Dim>
double Obstacles<Dim>::speed() const {
  double fastest = 0.0;
  for (const auto& one : each_) {
    fastest = std::max(fastest, one->speed());
  }
  return fastest;
}

template <int Dim>
Vec3 Obstacles<Dim>::impulse() const {
  Vec3 sum = Vec3::Zero();
  for (const auto& one : each_) {
    sum += one->impulse();
  }
  return sum;
}

template <int Dim>
std::vector<std::pair<std::string, double>> Obstacles<Dim>::diagnostics() const {
  std::vector<std::pair<std::string, double>> all;
  for (const auto& one : each_) {
    for (int axis = 0; axis < Dim; ++axis) {
      all.emplace_back(message(one->name(), " force ", axes[axis]), one->force()[axis]);
    }
    for (int axis = Dim == 2 ? 2 : 0; axis < 3; ++axis) {
      all.emplace_back(message(one->name(), " torque ", axes[axis]), one->torque()[axis]);
    }
    all.emplace_back(message(one->name(), " work"), one->work());
    all.emplace_back(message(one->name(), " contacts"), static_cast<double>(one->touching()));
    if (one->motion().is_free()) {
      add_motion<Dim>(one->name(), one->motion(), all);
    }
  }
  return all;
}

template <int Dim>
std::vector<Balance::Entry> Obstacles<Dim>::work_entries() const {
  std::vector<Balance::Entry> entries;
  for (const auto& one : each_) {
    entries.push_back({one->name(), one->work()});
  }
  return entries;
}

template <int Dim>
std::vector<Balance::Entry> Obstacles<Dim>::impulse_entries(int axis) const {
  std::vector<Balance::Entry> entries;
  for (const auto& one : each_) {
    entries.push_back({one->name(), one->impulse()[axis]});
  }
  return entries;
}

template <int Dim>
void Obstacles<Dim>::save(Archive& archive, const std::string& prefix) const {
  for (std::size_t k = 0; k < each_.size(); ++k) {
    each_[k]->save(archive, message(prefix, "/", k));
  }
  skins_.save(archive, prefix);
  const double numbers[] = {travelled_, given_};
  archive.write(prefix + "/sums", std::span<const double>(numbers));
}

template <int Dim>
void Obstacles<Dim>::load(const Archive& archive, const std::string& prefix) {
  for (std::size_t k = 0; k < each_.size(); ++k) {
    each_[k]->load(archive, message(prefix, "/", k));
  }
  skins_.load(archive, prefix);
  double numbers[2];
  archive.read(prefix + "/sums", std::span<double>(numbers));
  travelled_ = numbers[0];
  given_ = numbers[1];
}

template class Obstacles<2>;
template class Obstacles<3>;

}  // namespace lapilli
