#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "lapilli/core/vector.hpp"
#include "lapilli/mpm/dynamics/axis_arrays.hpp"
#include "lapilli/mpm/dynamics/obstacles/rigid_motion.hpp"

namespace lapilli {

/// One point of a body that an obstacle may touch: it acts at the point's foot on the surface, on
/// the nodes that carry mass around it.
template <int Dim>
struct Contact {
  static constexpr int corners = 1 << Dim;

  Index row = 0;                         // of the point
  std::size_t nearest = 0;               // of a light node: the contact whose friction it adds to
  double depth = 0.0;                    // m, of the point inside the obstacle
  double face = 0.0;                     // m^(Dim-1), of one of several that bear one traction
  bool joint = false;                    // whether it is one of these
  Vec<Dim> foot, normal, wall;           // m; out of the obstacle; its velocity there, m/s
  double bound = 0.0;                    // m/s, least normal speed that leaves an open gap open
  double grip = 0.0;                     // N s that adhesion bears in this step
  bool bonded = false;                   // it cannot part, and may pull
  bool on_edge = false;                  // of a sharp edge, which no face lies along
  int count = 0;                         // of nodes
  Index node[corners];                   //
  double weight[corners];                // linear functions at the foot; their sum is 1
  double mass = 0.0;                     // kg, that an impulse here meets
  double push = 0.0;                     // N s along the normal
  double beside = 0.0;                   // N s, of light nodes that it is the nearest to
  double past = -1.0;                    // N s, push that friction has felt so far; below 0: none
  double share = 1.0;                    // of the present push in what friction feels
  Vec<Dim> drag = Vec<Dim>::Zero();      // N s along the surface
  Vec<Dim> start = Vec<Dim>::Zero();     // m/s at the foot, before the step
  Vec<Dim> approach = Vec<Dim>::Zero();  // m/s, after the forces and before any impulse
  Vec<Dim> solved = Vec<Dim>::Zero();    // m/s, after all impulses

  Vec<Dim> impulse() const { return push * normal + drag; }
  /// N s, the push that bounds friction.
  double felt() const {
    const double present = push + beside;
    return past < 0.0 ? present : past + share * (present - past);
  }
  /// N s, that it bears along the surface.
  double drag_limit(double friction) const {
    if (std::isinf(friction)) {  // of what has parted nothing is left
      return bonded || (!on_edge && push + beside > 0.0) ? friction : grip;
    }
    const double bears = felt();
    return bears > 0.0 ? friction * bears + grip : bonded ? grip : 0.0;
  }
  /// N s, `push` or the nearest that it can give.
  double possible(double wanted) const { return bonded ? wanted : std::max(0.0, wanted); }
  bool acts() const { return bonded ? push != 0.0 : push > 0.0; }

  /// A nodal quantity at the foot.
  Vec<Dim> at_foot(const AxisArrays<Dim>& nodal) const {
    Vec<Dim> value = Vec<Dim>::Zero();
    for (int k = 0; k < count; ++k) {
      for (int axis = 0; axis < Dim; ++axis) {
        value[axis] += weight[k] * nodal[axis][node[k]];
      }
    }
    return value;
  }
};

// Impulses of the contacts with one obstacle that take the nodal velocity out of it, with Coulomb
// friction: projected Jacobi sweeps from the impulses that the contacts bring. The masses of the
// contacts are scaled so that all of them together do not overshoot. Where several obstacles hold
// the same nodes, each sweeps in turn.

/// Measured: one warm sweep gains energy in an impact, four do not.
inline constexpr int contact_sweeps = 4;

/// Find the masses and give the impulses that the contacts bring. Adds to `velocity` and, where it
/// is free, to `motion`; `crowd` is scratch over the nodes, zero before and after.
template <int Dim>
void begin_contacts(std::vector<Contact<Dim>>& contacts, const double* mass,
                    const AxisArrays<Dim>& velocity, RigidMotion& motion,
                    std::vector<double>& crowd);

/// Contacts that bear one traction: their mean velocity is held.
using JointContacts = std::vector<std::vector<std::size_t>>;

/// One sweep at the present velocity. friction = infinity: no slip.
template <int Dim>
void sweep_contacts(std::vector<Contact<Dim>>& contacts, const JointContacts& joint,
                    double friction, const double* mass, const AxisArrays<Dim>& velocity,
                    RigidMotion& motion);

/// One sweep that gives a velocity that was projected again (MUSL) what the contacts that push left
/// across the surface at their feet; along it too, blocks that friction holds would gain energy.
/// Books nothing.
template <int Dim>
void match_contacts(const std::vector<Contact<Dim>>& contacts, const double* mass,
                    const AxisArrays<Dim>& velocity);

}  // namespace lapilli
