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

/// The same of several that bear one traction.
template <int Dim>
void improve_together(std::vector<Contact<Dim>>& contacts, const std::vector<std::size_t>& members,
                      double friction, const AxisArrays<Dim>& velocity,
                      std::vector<Vec<Dim>>& change) {
  double push = 0.0, faces = 0.0, gain = 0.0, inverse = 0.0, limit = 0.0;
  Vec<Dim> drag = Vec<Dim>::Zero(), slip = Vec<Dim>::Zero(), normal = Vec<Dim>::Zero();
  for (const std::size_t k : members) {
    Contact<Dim>& contact = contacts[k];
    change[k] = -contact.impulse();
    const Vec<Dim> relative = contact.at_foot(velocity) - contact.wall;
    const double across = relative.dot(contact.normal);
    push += contact.push;
    drag += contact.drag;
    faces += contact.face;
    gain += contact.face * (contact.bound - across);
    slip += contact.face * (relative - across * contact.normal);
    normal += contact.face * contact.normal;
    inverse += contact.face * contact.face / contact.mass;
  }
  push = std::max(0.0, push / faces + gain / inverse);
  drag = drag / faces - slip / inverse;
  normal.normalize();
  drag -= drag.dot(normal) * normal;
  for (const std::size_t k : members) {
    Contact<Dim>& contact = contacts[k];
    contact.push = push * contact.face;
    limit += contact.drag_limit(friction);
  }
  if (const double size = faces * drag.norm(); size > limit) {
    drag *= limit / size;
  }
  for (const std::size_t k : members) {
    Contact<Dim>& contact = contacts[k];
    contact.drag = contact.face * drag;
    change[k] += contact.impulse();
  }
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
void sweep_contacts(std::vector<Contact<Dim>>& contacts, const JointContacts& joint,
                    double friction, const double* mass, const AxisArrays<Dim>& velocity,
                    RigidMotion& motion) {
  std::vector<Vec<Dim>> change(contacts.size());
  parallel_for(static_cast<Index>(contacts.size()), [&](Index k) {
    if (!contacts[k].joint) {
      change[k] = improve(contacts[k], friction, velocity);
    }
  });
  for (const auto& members : joint) {
    improve_together(contacts, members, friction, velocity, change);
  }
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
  template void sweep_contacts<Dim>(std::vector<Contact<Dim>>&, const JointContacts&, double,    \
                                    const double*, const AxisArrays<Dim>&, RigidMotion&);        \
  template void match_contacts<Dim>(const std::vector<Contact<Dim>>&, const double*,             \
                                    const AxisArrays<Dim>&);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
