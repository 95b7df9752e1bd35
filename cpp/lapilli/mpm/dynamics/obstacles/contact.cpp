#include "lapilli/mpm/dynamics/obstacles/contact.hpp"

#include <algorithm>

#include "lapilli/core/in_space.hpp"
#include "lapilli/core/parallel.hpp"

namespace lapilli {
namespace {

/// Add impulses at the feet to the nodes, in the order of the contacts.
template <int Dim, class ImpulseOf>
void add_to_nodes(const std::vector<Contact<Dim>>& contacts, const double* mass,
                  const AxisArrays<Dim>& velocity, const ImpulseOf& impulse_of) {
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact<Dim>& contact = contacts[k];
    const Vec<Dim> impulse = impulse_of(k);
    for (int c = 0; c < contact.count; ++c) {
      const double share = contact.weight[c] / mass[contact.node[c]];
      for (int axis = 0; axis < Dim; ++axis) {
        velocity[axis][contact.node[c]] += share * impulse[axis];
      }
    }
  }
}

/// What the contacts give the nodes, a free obstacle loses: its velocity at every foot follows.
template <int Dim, class ImpulseOf>
void take_from_obstacle(std::vector<Contact<Dim>>& contacts, RigidMotion& motion,
                        const ImpulseOf& impulse_of) {
  Vec3 impulse = Vec3::Zero(), moment = Vec3::Zero();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Vec3 given = in_space<Dim>(impulse_of(k));
    impulse -= given;
    moment -= (in_space<Dim>(contacts[k].foot) - motion.center()).cross(given);
  }
  motion.push(impulse, moment);
  for (Contact<Dim>& contact : contacts) {
    contact.wall = motion.velocity(in_space<Dim>(contact.foot)).template head<Dim>();
  }
}

/// From the centre of an obstacle that can turn, m.
template <int Dim>
double arm_of(const Contact<Dim>& contact, const RigidMotion& motion) {
  return motion.is_free() ? (in_space<Dim>(contact.foot) - motion.center()).norm() : 0.0;
}

/// The mass that an impulse at each foot meets while all the others push as hard: the row sum of
/// the contacts' matrix, for which Jacobi sweeps converge. `crowd` is scratch over the nodes,
/// zero before and after.
template <int Dim>
void set_masses(std::vector<Contact<Dim>>& contacts, const double* mass, const RigidMotion& motion,
                std::vector<double>& crowd) {
  double arms = 0.0;
  for (const Contact<Dim>& contact : contacts) {
    for (int c = 0; c < contact.count; ++c) {
      crowd[contact.node[c]] += contact.weight[c];
    }
    arms += arm_of(contact, motion);
  }
  const double pushes = static_cast<double>(contacts.size()) * motion.inverse_mass();
  const double turns = arms * motion.inverse_inertia();
  for (Contact<Dim>& contact : contacts) {
    double inverse = pushes + turns * arm_of(contact, motion);
    for (int c = 0; c < contact.count; ++c) {
      inverse += contact.weight[c] * crowd[contact.node[c]] / mass[contact.node[c]];
    }
    contact.mass = 1.0 / inverse;
  }
  for (const Contact<Dim>& contact : contacts) {
    for (int c = 0; c < contact.count; ++c) {
      crowd[contact.node[c]] = 0.0;
    }
  }
}

/// Better impulses of one contact at the present velocity; returns what changes.
template <int Dim>
Vec<Dim> improve(Contact<Dim>& contact, double friction, const AxisArrays<Dim>& velocity) {
  const Vec<Dim> before = contact.impulse();
  const Vec<Dim> relative = contact.at_foot(velocity) - contact.wall;
  const double normal = relative.dot(contact.normal);
  contact.push = contact.possible(contact.push + contact.mass * (contact.bound - normal));
  contact.drag -= contact.mass * (relative - normal * contact.normal);
  contact.drag -= contact.drag.dot(contact.normal) * contact.normal;
  const double limit = contact.drag_limit(friction);
  const double drag = contact.drag.norm();
  if (drag > limit) {
    contact.drag *= limit / drag;
  }
  return contact.impulse() - before;
}

/// Add impulses at the feet to both sides.
template <int Dim, class ImpulseOf>
void give(std::vector<Contact<Dim>>& contacts, const double* mass, const AxisArrays<Dim>& velocity,
          RigidMotion& motion, const ImpulseOf& impulse_of) {
  add_to_nodes(contacts, mass, velocity, impulse_of);
  if (motion.is_free()) {
    take_from_obstacle(contacts, motion, impulse_of);
  }
}

}  // namespace

template <int Dim>
void begin_contacts(std::vector<Contact<Dim>>& contacts, const double* mass,
                    const AxisArrays<Dim>& velocity, RigidMotion& motion,
                    std::vector<double>& crowd) {
  set_masses(contacts, mass, motion, crowd);
  give(contacts, mass, velocity, motion, [&](std::size_t k) { return contacts[k].impulse(); });
}

template <int Dim>
void sweep_contacts(std::vector<Contact<Dim>>& contacts, double friction, const double* mass,
                    const AxisArrays<Dim>& velocity, RigidMotion& motion) {
  std::vector<Vec<Dim>> change(contacts.size());
  parallel_for(static_cast<Index>(contacts.size()),
               [&](Index k) { change[k] = improve(contacts[k], friction, velocity); });
  give(contacts, mass, velocity, motion, [&](std::size_t k) { return change[k]; });
}

template <int Dim>
void match_contacts(const std::vector<Contact<Dim>>& contacts, const double* mass,
                    const AxisArrays<Dim>& velocity) {
  std::vector<Vec<Dim>> change(contacts.size());
  parallel_for(static_cast<Index>(contacts.size()), [&](Index k) {
    const Contact<Dim>& contact = contacts[k];
    change[k] = Vec<Dim>::Zero();
    if (contact.acts()) {
      const double across = (contact.solved - contact.at_foot(velocity)).dot(contact.normal);
      change[k] = contact.mass * across * contact.normal;
    }
  });
  add_to_nodes(contacts, mass, velocity, [&](std::size_t k) { return change[k]; });
}

#define LAPILLI_INSTANTIATE(Dim)                                                                 \
  template void begin_contacts<Dim>(std::vector<Contact<Dim>>&, const double*,                   \
                                    const AxisArrays<Dim>&, RigidMotion&, std::vector<double>&); \
  template void sweep_contacts<Dim>(std::vector<Contact<Dim>>&, double, const double*,           \
                                    const AxisArrays<Dim>&, RigidMotion&);                       \
  template void match_contacts<Dim>(const std::vector<Contact<Dim>>&, const double*,             \
                                    const AxisArrays<Dim>&);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
