#pragma once

#include <vector>

#include "lapilli/mpm/dynamics/dynamics_data.hpp"
#include "lapilli/mpm/dynamics/obstacles/contact.hpp"
#include "lapilli/mpm/dynamics/obstacles/rigid_motion.hpp"

namespace lapilli {

/// Below this share of the heaviest node at a foot a node is light. Nodes inside an obstacle that
/// the domains of points just reach are: an impulse that is shared with them throws them about and
/// hardly stops the body, and what nothing holds lets stress out (a block pressed between planes
/// on lines of the grid bore 8 % too little, one .1 cells off them 20 %).
inline constexpr double light_node = 0.015;

/// The light nodes inside the obstacle that the points of `contacts` reach, each as a contact of
/// its own that acts on it alone, with the normal and the gap of the nearest of these points.
template <int Dim>
std::vector<Contact<Dim>> find_light_nodes(const DynamicsData<Dim>& data,
                                           const std::vector<Contact<Dim>>& contacts);

/// Take them out of the nodes of contacts: one that is held and pushed as well would be thrown out,
/// and the heavy nodes beside it pushed on to make up for it.
template <int Dim>
void leave_out(const std::vector<Contact<Dim>>& nodes, std::vector<Contact<Dim>>& contacts);

/// Stop them at the obstacle, and push it where it is free. They slide on it: held along it too,
/// blocks that friction holds would gain energy. The friction of what they press falls to the
/// contacts beside them.
template <int Dim>
void hold_light_nodes(std::vector<Contact<Dim>>& nodes, const double* mass,
                      const AxisArrays<Dim>& velocity, RigidMotion& motion,
                      std::vector<Contact<Dim>>& contacts);

/// What that means for the velocity projected again (MUSL).
template <int Dim>
void match_light_nodes(const std::vector<Contact<Dim>>& nodes, const AxisArrays<Dim>& velocity);

}  // namespace lapilli
