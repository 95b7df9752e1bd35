#include "lapilli/mpm/dynamics/solve_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "lapilli/core/parallel.hpp"
#include "lapilli/mpm/dynamics/grid_boundaries.hpp"

namespace lapilli {
namespace {

/// Below this share, under linear functions, the internal force strains as if the node had it:
/// their slope stays whole while the mass vanishes. Elsewhere points strain with the velocity that
/// moves them, or the force would work without the stress that restores it.
constexpr double light_share = 0.1;

/// A node on a wall (layer 0) or outside of it (layer 1) that carries mass.
struct WallNode {
  Index node;
  int field, face, layer;
  int normal;     // axis
  double inward;  // sign of the inward normal along it
};

/// Call body(wall node) wall by wall in a fixed order.
template <int Dim, class Body>
void for_each_wall_node(const DynamicsData<Dim>& data, int number, const Body& body) {
  const NodeField<Dim>& field = data.fields[number];
  const Grid<Dim>& grid = field.grid;
  const double* mass = data.nodes.mass();
  for (int face = 0; face < 2 * Dim; ++face) {
    if (data.walls[face].is_open()) {
      continue;
    }
    const int axis = face / 2, outward = face % 2 == 0 ? -1 : 1;
    const int padding = Grid<Dim>::padding;
    const int on_wall =
        (outward < 0 ? padding : data.grid.nodes(axis) - 1 - padding) - field.corner[axis];
    for (int layer = 0; layer < 2; ++layer) {
      const int at = on_wall + layer * outward;
      if (at < 0 || at >= grid.nodes(axis)) {
        continue;
      }
      const Index stride = grid.node_stride(axis);
      const Index block = stride * grid.nodes(axis);
      for (Index start = field.offset + at * stride; start < field.end(); start += block) {
        const Index from = std::max(start, data.nodes.first());
        const Index to = std::min(start + stride, data.nodes.last());
        for (Index node = from; node < to; ++node) {
          if (mass[node] > data.empty_node) {
            body(WallNode{node, number, face, layer, axis, -1.0 * outward});
          }
        }
      }
    }
  }
}

template <int Dim, class Body>
void for_each_wall_node(const DynamicsData<Dim>& data, const Body& body) {
  for (int field = 0; field < data.fields.count(); ++field) {
    for_each_wall_node(data, field, body);
  }
}

}  // namespace

NodeSums& NodeSums::operator+=(const NodeSums& other) {
  kinetic_before += other.kinetic_before;
  kinetic_after += other.kinetic_after;
  force_work += other.force_work;
  friction += other.friction;
  impact += other.impact;
  damping += other.damping;
  wall_impulse += other.wall_impulse;
  damping_impulse += other.damping_impulse;
  return *this;
}

template <int Dim>
NodeSums accelerate_nodes(DynamicsData<Dim>& data, double step) {
  const double floor = data.empty_node;
  const double light = light_share * full_cell(data);
  const bool limits = data.nodes.limits_strain(), damps = data.nodes.damps();
  const double* mass = data.nodes.mass();
  const Index first = data.nodes.first(), count = data.nodes.last() - first;
  std::vector<NodeSums> partial(static_cast<std::size_t>((count + piece_rows - 1) / piece_rows));
  parallel_ranges(count, [&](Index begin, Index end) {
    NodeSums& sums = partial[begin / piece_rows];
    for (int axis = 0; axis < Dim; ++axis) {
      double* velocity = data.nodes.velocity(axis) + first;
      double* increment = data.nodes.increment(axis) + first;
      double* strain_velocity = data.nodes.strain_velocity(axis) + first;
      double* kept = damps ? data.nodes.internal(axis) + first : nullptr;
      const double* m = mass + first;
      const double gravity = data.gravity[axis];
      double before = 0.0, after = 0.0, work = 0.0;
      for (Index node = begin; node < end; ++node) {
        if (m[node] > floor) {
          const double inverse = 1.0 / m[node];
          const double old = velocity[node] * inverse;
          const double internal = step * increment[node] * inverse;
          const double change = internal + step * gravity;
          before += m[node] * old * old;
          after += m[node] * (old + change) * (old + change);
          work += m[node] * internal * (old + 0.5 * change);
          velocity[node] = old + change;
          increment[node] = change;
          if (damps) {
            kept[node] = internal;
          }
          if (limits) {
            strain_velocity[node] =
                old + step * gravity + internal * std::min(1.0, m[node] / light);
          }
        } else {
          velocity[node] = increment[node] = strain_velocity[node] = 0.0;
        }
      }
      sums.kinetic_before += 0.5 * before;
      sums.kinetic_after += 0.5 * after;
      sums.force_work += work;
    }
  });
  NodeSums total;
  for (const NodeSums& sums : partial) {
    total += sums;
  }
  return total;
}

template <int Dim>
void hold_nodes(DynamicsData<Dim>& data, double step, WallFriction<Dim>* friction,
                const FreedNodes<Dim>* freed, NodeSums& total) {
  const double* mass = data.nodes.mass();
  if (friction != nullptr) {
    friction->begin_step(step);
  }
  for_each_wall_node(data, [&](const WallNode& place) {
    const auto [node, normal, inward] = std::tuple(place.node, place.normal, place.inward);
    const Wall::Kind kind = data.walls[place.face].kind;
    Vec<Dim> velocity, change, strain;
    for (int axis = 0; axis < Dim; ++axis) {
      strain[axis] = data.nodes.strain_velocity(axis)[node];
      velocity[axis] = data.nodes.velocity(axis)[node];
      change[axis] = data.nodes.increment(axis)[node];
    }
    const double free = freed != nullptr ? freed->share(place.node) : 0.0;
    double slows = 0.0;
    if (kind == Wall::Kind::frictional) {
      const double push = mass[node] * std::max(0.0, -inward * velocity[normal]);
      slows = friction->bear(data, place.field, place.face, place.layer, node, push) / mass[node];
      slows *= 1.0 - free;
    }
    const Vec<Dim> held = held_by<Dim>(kind, normal, inward, velocity, slows, free);
    const Vec<Dim> held_strain = held_by<Dim>(kind, normal, inward, strain, slows, free);
    const Vec<Dim> impulse = mass[node] * (held - velocity);
    // The wall's work over the step: its impulse times the mean of the velocity before and after.
    const Vec<Dim> middle = 0.5 * (held + velocity - change);
    const double across = impulse[normal] * middle[normal];
    total.impact += across;
    const Vec<Dim> force = mass[node] * (change - step * data.gravity.template head<Dim>());
    total.force_work += 0.5 * force.dot(held - velocity);
    total.friction += impulse.dot(middle) - across;
    total.kinetic_after += 0.5 * mass[node] * (held.squaredNorm() - velocity.squaredNorm());
    for (int axis = 0; axis < Dim; ++axis) {
      total.wall_impulse[axis] += impulse[axis];
      data.nodes.velocity(axis)[node] = held[axis];
      if (data.nodes.limits_strain()) {
        data.nodes.strain_velocity(axis)[node] = held_strain[axis];
      }
      data.nodes.increment(axis)[node] = change[axis] + held[axis] - velocity[axis];
    }
  });
}

template <int Dim>
void blend_nodes(DynamicsData<Dim>& data, double step) {
  const double floor = data.empty_node, scale = -data.settings.blend_rate * step;
  const Index first = data.nodes.first();
  parallel_ranges(data.nodes.last() - first, [&](Index begin, Index end) {
    const double* m = data.nodes.mass() + first;
    double* fade = data.nodes.fade() + first;
    for (Index node = begin; node < end; ++node) {
      fade[node] = m[node] > floor ? -std::expm1(scale * fade[node] / m[node]) : 0.0;
    }
    for (int axis = 0; axis < Dim; ++axis) {
      const double* velocity = data.nodes.velocity(axis) + first;
      const double* increment = data.nodes.increment(axis) + first;
      double* gain = data.nodes.gain(axis) + first;
      for (Index node = begin; node < end; ++node) {
        gain[node] = increment[node] + fade[node] * (velocity[node] - increment[node]);
      }
    }
  });
}

template <int Dim>
void divide_second_velocity(DynamicsData<Dim>& data) {
  const double floor = data.empty_node;
  const Index first = data.nodes.first();
  parallel_ranges(data.nodes.last() - first, [&](Index begin, Index end) {
    const double* m = data.nodes.mass() + first;
    for (int axis = 0; axis < Dim; ++axis) {
      double* velocity = data.nodes.second_velocity(axis) + first;
      for (Index node = begin; node < end; ++node) {
        velocity[node] = m[node] > floor ? velocity[node] / m[node] : 0.0;
      }
    }
  });
}

template <int Dim>
void hold_second_velocity(DynamicsData<Dim>& data, const FreedNodes<Dim>* freed) {
  for_each_wall_node(data, [&](const WallNode& place) {
    Vec<Dim> velocity;
    for (int axis = 0; axis < Dim; ++axis) {
      velocity[axis] = data.nodes.second_velocity(axis)[place.node];
    }
    // Along the wall it keeps what it has, as at obstacles.
    const Wall::Kind kind = data.walls[place.face].kind;
    const double free = freed != nullptr ? freed->share(place.node) : 0.0;
    Vec<Dim> held = held_by<Dim>(kind, place.normal, place.inward, velocity, 0.0, free);
    if (kind == Wall::Kind::frictional && data.nodes.velocity(place.normal)[place.node] == 0.0) {
      // What presses does not part: strained as if it did, a block that hits the wall gains energy.
      held[place.normal] = 0.0;
    }
    for (int axis = 0; axis < Dim; ++axis) {
      data.nodes.second_velocity(axis)[place.node] = held[axis];
    }
  });
}

template <int Dim>
void take_mean_velocity(DynamicsData<Dim>& data) {
  const Index first = data.nodes.first();
  parallel_ranges(data.nodes.last() - first, [&](Index begin, Index end) {
    for (int axis = 0; axis < Dim; ++axis) {
      double* velocity = data.nodes.velocity(axis) + first;
      const double* increment = data.nodes.increment(axis) + first;
      for (Index node = begin; node < end; ++node) {
        velocity[node] -= 0.5 * increment[node];
      }
    }
  });
}

template NodeSums accelerate_nodes<2>(DynamicsData<2>&, double);
template NodeSums accelerate_nodes<3>(DynamicsData<3>&, double);
template void hold_nodes<2>(DynamicsData<2>&, double, WallFriction<2>*, const FreedNodes<2>*,
                            NodeSums&);
template void hold_nodes<3>(DynamicsData<3>&, double, WallFriction<3>*, const FreedNodes<3>*,
                            NodeSums&);
template void blend_nodes<2>(DynamicsData<2>&, double);
template void blend_nodes<3>(DynamicsData<3>&, double);
template void divide_second_velocity<2>(DynamicsData<2>&);
template void divide_second_velocity<3>(DynamicsData<3>&);
template void hold_second_velocity<2>(DynamicsData<2>&, const FreedNodes<2>*);
template void hold_second_velocity<3>(DynamicsData<3>&, const FreedNodes<3>*);
template void take_mean_velocity<2>(DynamicsData<2>&);
template void take_mean_velocity<3>(DynamicsData<3>&);

}  // namespace lapilli
