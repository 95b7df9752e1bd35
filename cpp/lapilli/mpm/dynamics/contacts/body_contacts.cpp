#include "lapilli/mpm/dynamics/contacts/body_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

/// Nodes of three bodies and more are improved so often, pair after pair.
constexpr int sweeps = 8;

}  // namespace

template <int Dim>
BodyContacts<Dim>::BodyContacts(const DynamicsData<Dim>& data,
                                const std::vector<DynamicsBody>& bodies, ContactGroups groups)
    : groups_(std::move(groups)),
      shared_(data, bodies),
      force_(groups_.pairs.size(), Vec3::Zero()) {}

/// Better impulses of the nodes of one pair at the present velocity.
template <int Dim>
void BodyContacts<Dim>::improve(const double* mass, const AxisArrays<Dim>& velocity, double step,
                                std::size_t pair, std::vector<Impulse>& all) {
  const std::span<SharedNode<Dim>> nodes = shared_.of(pair);
  if (nodes.empty()) {
    return;
  }
  const ContactLaw& law = groups_.laws[pair];
  Impulse* impulses = all.data() + (nodes.data() - shared_.all().data());
  parallel_for(static_cast<Index>(nodes.size()), [&](Index k) {
    const SharedNode<Dim>& node = nodes[k];
    Impulse& impulse = impulses[k];
    Vec<Dim> apart;
    for (int axis = 0; axis < Dim; ++axis) {
      apart[axis] = velocity[axis][node.second] - velocity[axis][node.first];
    }
    const double m = 1.0 / (1.0 / mass[node.first] + 1.0 / mass[node.second]);
    const double bound = -std::max(0.0, node.gap) / step;
    const double normal = apart.dot(node.normal);
    const Impulse old = impulse;
    impulse.push = std::max(0.0, old.push + m * (bound - normal));
    impulse.drag -= m * (apart - normal * node.normal);
    const double limit = most_drag(law, node, impulse, step), drag = impulse.drag.norm();
    if (drag > limit) {
      impulse.drag *= limit / drag;
    }
    const Vec<Dim> change = (impulse.push - old.push) * node.normal + impulse.drag - old.drag;
    for (int axis = 0; axis < Dim; ++axis) {
      velocity[axis][node.first] -= change[axis] / mass[node.first];
      velocity[axis][node.second] += change[axis] / mass[node.second];
    }
  });
}

/// The impulses that a nodal velocity needs, added to it.
template <int Dim>
std::vector<typename BodyContacts<Dim>::Impulse> BodyContacts<Dim>::solve(
    const double* mass, const AxisArrays<Dim>& velocity, double step) {
  std::vector<Impulse> impulses(shared_.all().size());
  const bool crowded = shared_.touched().size() < 2 * shared_.all().size();
  for (int sweep = 0; sweep < (crowded ? sweeps : 1); ++sweep) {
    for (std::size_t pair = 0; pair < groups_.pairs.size(); ++pair) {
      improve(mass, velocity, step, pair, impulses);
    }
  }
  return impulses;
}

template <int Dim>
void BodyContacts<Dim>::push(DynamicsData<Dim>& data, double step, NodeSums& sums) {
  shared_.find(data, groups_.pairs);
  const std::vector<Index>& touched = shared_.touched();
  before_.resize(touched.size());
  const AxisArrays<Dim> velocity = data.nodes.velocities();
  for (int axis = 0; axis < Dim; ++axis) {
    for (std::size_t k = 0; k < touched.size(); ++k) {
      before_[k][axis] = velocity[axis][touched[k]];
    }
  }
  impulses_ = solve(data.nodes.mass(), velocity, step);
  if (data.nodes.limits_strain()) {
    // Light nodes strain with part of the force; the impulse against the whole of it is too much.
    solve(data.nodes.mass(), data.nodes.strain_velocities(), step);
  }
  book(data, step, sums);
  if (keeps_touches_) {
    find_touches(data);
  }
}

template <int Dim>
void BodyContacts<Dim>::keep_touches(const DynamicsData<Dim>& data) {
  keeps_touches_ = true;
  shared_.find(data, groups_.pairs);
  impulses_.assign(shared_.all().size(), {});
  find_touches(data);
}

template <int Dim>
void BodyContacts<Dim>::find_touches(const DynamicsData<Dim>& data) {
  touches_.clear();
  for (std::size_t pair = 0; pair < groups_.pairs.size(); ++pair) {
    const auto [first, second] = groups_.pairs[pair];
    for (const SharedNode<Dim>& node : shared_.of(pair)) {
      if (node.touches || impulses_[&node - shared_.all().data()].push > 0.0) {
        BodyTouch touch{data.grid.node_index(node.at), first, second, node.face};
        touch.normal.template head<Dim>() = node.normal;
        touch.beyond = node.beyond;
        touches_.push_back(touch);
      }
    }
  }
}

/// Where bodies press, their strains are those of one: the velocity across is that of the solved
/// nodes, whatever its sign, and that along too where friction holds.
template <int Dim>
void BodyContacts<Dim>::push_second(DynamicsData<Dim>& data, double step) {
  const double* mass = data.nodes.mass();
  for (std::size_t pair = 0; pair < groups_.pairs.size(); ++pair) {
    const ContactLaw& law = groups_.laws[pair];
    for (const SharedNode<Dim>& node : shared_.of(pair)) {
      const Impulse& impulse = impulses_[&node - shared_.all().data()];
      if (!impulse.acts()) {
        continue;
      }
      Vec<Dim> apart;
      for (int axis = 0; axis < Dim; ++axis) {
        const double* velocity = data.nodes.second_velocity(axis);
        apart[axis] = velocity[node.second] - velocity[node.first];
      }
      const double limit = most_drag(law, node, impulse, step);
      const bool holds = impulse.drag.norm() < (1.0 - 1e-9) * limit;
      const double across = apart.dot(node.normal);
      Vec<Dim> change = Vec<Dim>::Zero();
      if (impulse.push > 0.0) {
        change = -(std::max(0.0, node.gap) / step + across) * node.normal;
      }
      if (holds) {
        change -= apart - across * node.normal;
      }
      change /= 1.0 / mass[node.first] + 1.0 / mass[node.second];
      for (int axis = 0; axis < Dim; ++axis) {
        double* velocity = data.nodes.second_velocity(axis);
        velocity[node.first] -= change[axis] / mass[node.first];
        velocity[node.second] += change[axis] / mass[node.second];
      }
    }
  }
}

/// What the impulses did: they work on the mean of the velocities before and after the step.
template <int Dim>
void BodyContacts<Dim>::book(DynamicsData<Dim>& data, double step, NodeSums& sums) {
  touching_ = 0.0;
  const std::span<SharedNode<Dim>> all = shared_.all();
  double friction = 0.0, impact = 0.0;
  for (std::size_t pair = 0; pair < groups_.pairs.size(); ++pair) {
    const std::span<SharedNode<Dim>> nodes = shared_.of(pair);
    force_[pair].setZero();
    for (const SharedNode<Dim>& node : nodes) {
      const Impulse& impulse = impulses_[&node - all.data()];
      if (!impulse.acts()) {
        continue;
      }
      touching_ += 1.0;
      Vec<Dim> slip;
      for (int axis = 0; axis < Dim; ++axis) {
        const double *velocity = data.nodes.velocity(axis), *change = data.nodes.increment(axis);
        // The increment is still that of the forces alone.
        const auto start = [&](Index k) { return before_[shared_.slot(k)][axis] - change[k]; };
        slip[axis] = 0.5 * (velocity[node.second] + start(node.second) - velocity[node.first] -
                            start(node.first));
      }
      impact += impulse.push * node.normal.dot(slip);
      friction += impulse.drag.dot(slip);
      force_[pair].template head<Dim>() += (impulse.push * node.normal + impulse.drag) / step;
    }
  }
  impact_ += impact;
  friction_ += friction;
  const double* mass = data.nodes.mass();
  for (std::size_t k = 0; k < shared_.touched().size(); ++k) {
    const Index node = shared_.touched()[k];
    for (int axis = 0; axis < Dim; ++axis) {
      double& increment = data.nodes.increment(axis)[node];
      const double change = data.nodes.velocity(axis)[node] - before_[k][axis];
      sums.kinetic_after += mass[node] * change * (before_[k][axis] + 0.5 * change);
      sums.force_work += 0.5 * mass[node] * (increment - step * data.gravity[axis]) * change;
      increment += change;
    }
  }
}

template <int Dim>
std::vector<std::pair<std::string, double>> BodyContacts<Dim>::diagnostics() const {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::vector<std::pair<std::string, double>> all{
      {"contact friction", -friction_}, {"contact impact", -impact_}, {"contact nodes", touching_}};
  for (std::size_t pair = 0; pair < groups_.pairs.size(); ++pair) {
    for (int axis = 0; axis < Dim; ++axis) {
      all.emplace_back(message(groups_.laws[pair].name, " force ", axes[axis]), force_[pair][axis]);
    }
  }
  return all;
}

template <int Dim>
void BodyContacts<Dim>::save(Archive& archive, const std::string& name) const {
  std::vector<double> numbers{friction_, impact_, touching_};
  for (const Vec3& force : force_) {
    numbers.insert(numbers.end(), force.data(), force.data() + 3);
  }
  archive.write(name + "/numbers", std::span<const double>(numbers));
  if (!keeps_touches_) {
    return;
  }
  std::vector<Index> where;
  std::vector<double> area;
  for (const BodyTouch& touch : touches_) {
    where.insert(where.end(), {touch.node, touch.first, touch.second});
    area.push_back(touch.area);
  }
  archive.write(name + "/touches", std::span<const Index>(where));
  archive.write(name + "/touching_area", std::span<const double>(area));
}

template <int Dim>
void BodyContacts<Dim>::load(const Archive& archive, const std::string& name) {
  std::vector<double> numbers(3 + 3 * force_.size());
  archive.read(name + "/numbers", std::span<double>(numbers));
  friction_ = numbers[0];
  impact_ = numbers[1];
  touching_ = numbers[2];
  for (std::size_t k = 0; k < force_.size(); ++k) {
    force_[k] = Eigen::Map<const Vec3>(numbers.data() + 3 + 3 * k);
  }
  if (!keeps_touches_) {
    return;
  }
  const std::vector<Index> where = archive.read_indices(name + "/touches");
  const std::vector<double> area = archive.read_numbers(name + "/touching_area");
  touches_.clear();
  for (std::size_t k = 0; k < area.size(); ++k) {
    touches_.push_back({where[3 * k], static_cast<int>(where[3 * k + 1]),
                        static_cast<int>(where[3 * k + 2]), area[k]});
  }
}

template <int Dim>
std::unique_ptr<BodyContacts<Dim>> make_contacts(DynamicsData<Dim>& data,
                                                 const std::vector<DynamicsBody>& bodies,
                                                 ContactGroups groups) {
  if (groups.pairs.empty()) {
    data.fields = NodeFields<Dim>(data.grid);
    return nullptr;
  }
  data.fields.split(groups.field_of_body);
  data.fields.place(data.points);
  return std::make_unique<BodyContacts<Dim>>(data, bodies, std::move(groups));
}

template class BodyContacts<2>;
template class BodyContacts<3>;
template std::unique_ptr<BodyContacts<2>> make_contacts(DynamicsData<2>&,
                                                        const std::vector<DynamicsBody>&,
                                                        ContactGroups);
template std::unique_ptr<BodyContacts<3>> make_contacts(DynamicsData<3>&,
                                                        const std::vector<DynamicsBody>&,
                                                        ContactGroups);

}  // namespace lapilli
