// Where the faces of an obstacle end.
#include <cmath>

#include "lapilli/core/in_space.hpp"
#include "lapilli/mpm/dynamics/obstacles/joint_contacts.hpp"
#include "lapilli/mpm/dynamics/obstacles/obstacle_contacts.hpp"
#include "lapilli/mpm/dynamics/touching_gap.hpp"

namespace lapilli {

/// No point need be asked again before it can have come near.
template <int Dim>
bool ObstacleContacts<Dim>::may_be_near_edge(const DynamicsData<Dim>& data,
                                             const Contact<Dim>& contact, double travelled) {
  // Edges that run at 45 degrees to the ways that are looked along are nearer by a root of two.
  constexpr double looked = 3.5, seen = Dim == 2 ? looked : looked / 1.42;  // cells
  const double h = data.grid.cell_size();
  double& until = memory_[contact.row * kept + edgeless];
  if (travelled < until) {
    return false;
  }
  if (is_near_edge(surface(), in_space<Dim>(contact.foot), in_space<Dim>(contact.normal), Dim,
                   looked * h)) {
    return true;
  }
  until = travelled + (seen - joint_zone) * h;
  return false;
}

template <int Dim>
void ObstacleContacts<Dim>::join_ends(const DynamicsData<Dim>& data, double step, double travelled,
                                      const std::function<bool(const Vec3&)>& is_held) {
  constexpr double deepest = 0.25;  // cells, to which material may be overtaken at an edge
  const double h = data.grid.cell_size();
  std::vector<EndContact<Dim>> ends;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    Contact<Dim>& contact = contacts_[k];
    if (contact.bonded || !may_be_near_edge(data, contact, travelled)) {
      continue;
    }
    contact.on_edge =
        is_on_edge(surface(), in_space<Dim>(contact.foot), in_space<Dim>(contact.normal), Dim, h);
    if (!yields(data.materials[data.points.body()[contact.row]].law)) {
      continue;
    }
    auto end =
        end_contact(data, surface(), contact, contact.on_edge, face_of(data, contact.row), is_held);
    if (end && end->gap <= skin(data, contact.row) + touching_gap * h && end->gap > -deepest * h) {
      end->contact = k;
      ends.push_back(*end);
    }
  }
  joint_ = join(data, ends, contacts_);
  std::erase_if(joint_, [](const auto& members) { return members.size() < 2; });
  for (const auto& members : joint_) {
    for (const std::size_t k : members) {
      contacts_[k].joint = true;
    }
  }
  for (const EndContact<Dim>& end : ends) {
    Contact<Dim>& contact = contacts_[end.contact];
    if (contact.joint) {
      contact.face = end.face;
      contact.normal = end.end.normal.template head<Dim>().normalized();
      contact.bound = -std::max(0.0, end.gap - skin(data, contact.row)) / step;
    }
  }
}

template void ObstacleContacts<2>::join_ends(const DynamicsData<2>&, double, double,
                                             const std::function<bool(const Vec3&)>&);
template void ObstacleContacts<3>::join_ends(const DynamicsData<3>&, double, double,
                                             const std::function<bool(const Vec3&)>&);

}  // namespace lapilli
