#include "lapilli/mpm/dynamics/obstacles/light_nodes.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/in_space.hpp"

namespace lapilli {
namespace {

/// A node and the contact whose point reaches it.
struct Reached {
  Index node;
  std::size_t contact;
};

/// Call body(node, place) for the nodes that the domain of a point touches.
template <int Dim, class Body>
void for_each_reached(const DynamicsData<Dim>& data, Index row, const Body& body) {
  const Index number = data.points.body()[row];
  const NodeField<Dim>& field = data.fields.of_body(number);
  const Grid<Dim>& grid = field.grid;
  const double reach = data.shape == ShapeFunction::linear ? 0.0 : data.half_widths[number];
  std::array<int, Dim> first, last;
  for (int axis = 0; axis < Dim; ++axis) {
    const double at =
        (data.points.position()[row * Dim + axis] - grid.origin()[axis]) * grid.inverse_cell_size();
    first[axis] = std::max(static_cast<int>(std::floor(at - reach)), 0);
    last[axis] = std::min(static_cast<int>(std::floor(at + reach)) + 1, grid.nodes(axis) - 1);
  }
  for (std::array<int, Dim> node = first;;) {
    const Index index = grid.node_index(node);
    body(field.offset + index, grid.node_position(index));
    int axis = 0;
    for (; axis < Dim && ++node[axis] > last[axis]; ++axis) {
      node[axis] = first[axis];
    }
    if (axis == Dim) {
      return;
    }
  }
}

}  // namespace

template <int Dim>
std::vector<Contact<Dim>> find_light_nodes(const DynamicsData<Dim>& data,
                                           const std::vector<Contact<Dim>>& contacts) {
  const double* mass = data.nodes.mass();
  std::vector<Reached> reached;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact<Dim>& contact = contacts[k];
    double heaviest = 0.0;
    for (int c = 0; c < contact.count; ++c) {
      heaviest = std::max(heaviest, mass[contact.node[c]]);
    }
    for_each_reached(data, contact.row, [&](Index node, const Vec<Dim>& place) {
      const bool touched = node >= data.nodes.first() && node < data.nodes.last();
      if (touched && mass[node] > data.empty_node && mass[node] < light_node * heaviest &&
          (place - contact.foot).dot(contact.normal) < 0.0) {
        reached.push_back({node, k});
      }
    });
  }
  std::ranges::sort(reached, [&](const Reached& a, const Reached& b) {
    const double nearer = contacts[a.contact].bound - contacts[b.contact].bound;
    return a.node != b.node ? a.node < b.node
           : nearer != 0.0  ? nearer > 0.0
                            : a.contact < b.contact;
  });
  std::vector<Contact<Dim>> nodes;
  for (std::size_t k = 0; k < reached.size(); ++k) {
    if (k == 0 || reached[k].node != reached[k - 1].node) {
      Contact<Dim> contact = contacts[reached[k].contact];
      contact.nearest = reached[k].contact;
      contact.count = 1;
      contact.node[0] = reached[k].node;
      contact.weight[0] = 1.0;
      contact.push = 0.0;
      contact.drag.setZero();
      nodes.push_back(contact);
    }
  }
  return nodes;
}

template <int Dim>
void leave_out(const std::vector<Contact<Dim>>& nodes, std::vector<Contact<Dim>>& contacts) {
  const auto is_light = [&](Index node) {
    const auto at =
        std::ranges::lower_bound(nodes, node, {}, [](const auto& n) { return n.node[0]; });
    return at != nodes.end() && at->node[0] == node;
  };
  constexpr double least_sum = 1e-3;
  for (Contact<Dim>& contact : contacts) {
    Contact<Dim> without = contact;
    double sum = 0.0;
    without.count = 0;
    for (int c = 0; c < contact.count; ++c) {
      if (!is_light(contact.node[c])) {
        without.node[without.count] = contact.node[c];
        without.weight[without.count++] = contact.weight[c];
        sum += contact.weight[c];
      }
    }
    if (without.count < contact.count && sum > least_sum) {
      for (int c = 0; c < without.count; ++c) {
        without.weight[c] /= sum;
      }
      contact = without;
    }
  }
}

template <int Dim>
void hold_light_nodes(std::vector<Contact<Dim>>& nodes, const double* mass,
                      const AxisArrays<Dim>& velocity, RigidMotion& motion,
                      std::vector<Contact<Dim>>& contacts) {
  Vec3 impulse = Vec3::Zero(), moment = Vec3::Zero();
  for (Contact<Dim>& contact : nodes) {
    const Vec3 foot = in_space<Dim>(contact.foot);
    contact.wall = motion.velocity(foot).template head<Dim>();
    const Vec<Dim> relative = contact.at_foot(velocity) - contact.wall;
    const double normal = relative.dot(contact.normal), m = mass[contact.node[0]];
    contact.push = contact.possible(m * (contact.bound - normal));
    contacts[contact.nearest].beside += contact.push;
    for (int axis = 0; axis < Dim; ++axis) {
      velocity[axis][contact.node[0]] += contact.impulse()[axis] / m;
    }
    const Vec3 given = in_space<Dim>(contact.impulse());
    impulse -= given;
    moment -= (foot - motion.center()).cross(given);
  }
  if (motion.is_free()) {
    motion.push(impulse, moment);
  }
}

template <int Dim>
void match_light_nodes(const std::vector<Contact<Dim>>& nodes, const AxisArrays<Dim>& velocity) {
  for (const Contact<Dim>& contact : nodes) {
    if (contact.acts()) {
      const double across = (contact.solved - contact.at_foot(velocity)).dot(contact.normal);
      for (int axis = 0; axis < Dim; ++axis) {
        velocity[axis][contact.node[0]] += across * contact.normal[axis];
      }
    }
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                                         \
  template std::vector<Contact<Dim>> find_light_nodes(const DynamicsData<Dim>&,          \
                                                      const std::vector<Contact<Dim>>&); \
  template void leave_out(const std::vector<Contact<Dim>>&, std::vector<Contact<Dim>>&); \
  template void hold_light_nodes(std::vector<Contact<Dim>>&, const double*,              \
                                 const AxisArrays<Dim>&, RigidMotion&,                   \
                                 std::vector<Contact<Dim>>&);                            \
  template void match_light_nodes(const std::vector<Contact<Dim>>&, const AxisArrays<Dim>&);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
