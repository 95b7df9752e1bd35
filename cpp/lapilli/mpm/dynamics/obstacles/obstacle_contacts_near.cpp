// Where the material is near an obstacle.
#include <algorithm>
#include <cmath>
#include <utility>

#include "lapilli/core/in_space.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/mpm/dynamics/obstacles/light_nodes.hpp"
#include "lapilli/mpm/dynamics/obstacles/nodes_around.hpp"
#include "lapilli/mpm/dynamics/obstacles/obstacle_contacts.hpp"
#include "lapilli/mpm/dynamics/touching_gap.hpp"

namespace lapilli {

/// Weights of linear functions at a place on the nodes that carry mass, less on light ones; false
/// where there are none.
template <int Dim>
bool ObstacleContacts<Dim>::place_on_nodes(const DynamicsData<Dim>& data, const Vec<Dim>& place,
                                           Contact<Dim>& contact) const {
  constexpr double least_weight = 1e-9, least_sum = 1e-3;
  const double* mass = data.nodes.mass();
  double sum = 0.0, heaviest = 0.0;
  const auto take = [&](Index node, double weight) {
    if (weight > least_weight && mass[node] > data.empty_node) {
      contact.node[contact.count] = node;
      contact.weight[contact.count++] = weight;
      heaviest = std::max(heaviest, mass[node]);
    }
  };
  if (!for_each_node_around(data, contact.row, place, take)) {
    return false;
  }
  for (int k = 0; k < contact.count; ++k) {
    contact.weight[k] *= std::min(1.0, mass[contact.node[k]] / (light_node * heaviest));
    sum += contact.weight[k];
  }
  for (int k = 0; k < contact.count; ++k) {
    contact.weight[k] /= sum;
  }
  return sum > least_sum;
}

template <int Dim>
Contact<Dim> ObstacleContacts<Dim>::contact_at(const DynamicsData<Dim>& data, Index row,
                                               const Vec3& x, double gap, double step) const {
  const double reaches = skin(data, row);
  const Vec3 normal = normal_at(x);
  Contact<Dim> contact;
  contact.row = row;
  contact.depth = std::max(0.0, -gap);
  contact.normal = normal.head<Dim>().normalized();
  const Vec3 foot = x - gap * normal;
  contact.foot = foot.head<Dim>();
  contact.wall = motion_.velocity(foot).template head<Dim>();
  contact.share = 1.0 - std::exp(-step / lags_[data.points.body()[row]]);
  const bool touches = gap <= reaches + touching_gap * data.grid.cell_size();
  contact.bonded =
      !obstacle_.separation && (touches || memory_[row * kept + stamp] == steps_ + bond);
  contact.bound = contact.bonded ? 0.0 : -std::max(0.0, gap - reaches) / step;
  contact.grip = touches || contact.bonded ? obstacle_.adhesion * face_of(data, row) * step : 0.0;
  return contact;
}

/// The material between a point and its surface swells and shrinks as the point does, by little:
/// where it flows its shape is not known.
template <int Dim>
double ObstacleContacts<Dim>::skin(const DynamicsData<Dim>& data, Index row) const {
  constexpr double most = 0.02;
  const double* start = skin_.data() + row * skin_.components();
  const double swelling = std::as_const(data.points).volume()[row] / start[1];
  return start[0] * std::clamp(swelling, 1.0 - most, 1.0 + most);
}

/// m^(Dim-1), of a point at a surface.
template <int Dim>
double ObstacleContacts<Dim>::face_of(const DynamicsData<Dim>& data, Index row) const {
  return std::as_const(data.points).volume()[row] / (2.0 * skin(data, row));
}

/// What take(row, add) adds of the points, in their order.
template <int Dim>
template <class Found, class Take>
std::vector<Found> ObstacleContacts<Dim>::near(const DynamicsData<Dim>& data,
                                               const Take& take) const {
  const Index count = data.points.size();
  std::vector<std::vector<Found>> found(
      static_cast<std::size_t>((count + piece_rows - 1) / piece_rows));
  parallel_ranges(count, [&](Index begin, Index end) {
    for (Index row = begin; row < end; ++row) {
      take(row, [&](const Found& one) { found[begin / piece_rows].push_back(one); });
    }
  });
  std::vector<Found> all;
  for (const auto& some : found) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

template <int Dim>
std::vector<SurfaceFoot<Dim>> ObstacleContacts<Dim>::feet(const DynamicsData<Dim>& data,
                                                          double travelled) const {
  return near<SurfaceFoot<Dim>>(data, [&](Index row, const auto& add) {
    const double touch = skin(data, row) + touching_gap * data.grid.cell_size();
    if (memory_[row * kept] - travelled > touch) {
      return;
    }
    const Vec3 x = in_space<Dim>(data.points.template position<Dim>(row));
    if (const double gap = clearance(x); gap <= touch) {
      const Vec3 normal = normal_at(x);
      const Vec3 foot = x - gap * normal;
      add({row, foot.head<Dim>(), normal.head<Dim>().normalized(), face_of(data, row)});
    }
  });
}

template <int Dim>
void ObstacleContacts<Dim>::find(const DynamicsData<Dim>& data, double step, double travelled,
                                 double reach) {
  const double h = data.grid.cell_size();
  contacts_ = near<Contact<Dim>>(data, [&](Index row, const auto& add) {
    const double zone = skin(data, row) + 0.5 * h;
    double& clear = memory_[row * kept];  // what it was, plus what had been travelled then
    if (clear - travelled > zone + reach) {
      return;
    }
    const Vec3 x = in_space<Dim>(data.points.template position<Dim>(row));
    const double gap = clearance(x);
    clear = gap + travelled - reach;
    if (gap < zone) {
      Contact<Dim> contact = contact_at(data, row, x, gap, step);
      // One that is inside acts where it is: nodes at the surface alone would not hold it.
      const Vec<Dim> at = gap < 0.0 ? Vec<Dim>(x.template head<Dim>()) : contact.foot;
      if (place_on_nodes(data, at, contact)) {
        add(contact);
      }
    }
  });
}

#define LAPILLI_INSTANTIATE(Dim)                                                               \
  template std::vector<SurfaceFoot<Dim>> ObstacleContacts<Dim>::feet(const DynamicsData<Dim>&, \
                                                                     double) const;            \
  template void ObstacleContacts<Dim>::find(const DynamicsData<Dim>&, double, double, double);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
