#include "lapilli/mpm/dynamics/obstacles/joint_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/in_space.hpp"
#include "lapilli/mpm/dynamics/obstacles/nodes_around.hpp"

namespace lapilli {
namespace {

/// kg, of the nodes around a place in the field of a point, by linear functions.
template <int Dim>
double mass_around(const DynamicsData<Dim>& data, Index row, const Vec3& place) {
  double sum = 0.0;
  for_each_node_around<Dim>(data, row, place.head<Dim>(), [&](Index node, double weight) {
    sum += weight * data.nodes.mass()[node];
  });
  return sum;
}

/// Whether material is as dense a cell beyond the edge as at the foot.
template <int Dim>
bool goes_on(const DynamicsData<Dim>& data, Index row, const Vec3& edge, const Vec3& foot,
             const FaceEnd& end) {
  const double h = data.grid.cell_size();
  const Vec3 below = 1.5 * h * end.normal;
  const Vec3 beyond = edge + h * end.outwards + below;
  return mass_around<Dim>(data, row, beyond) > 0.5 * mass_around<Dim>(data, row, foot + below);
}

}  // namespace

template <int Dim>
std::optional<EndContact<Dim>> end_contact(const DynamicsData<Dim>& data,
                                           const ObstacleSurface& surface,
                                           const Contact<Dim>& contact, bool on_edge, double face,
                                           const std::function<bool(const Vec3&)>& is_held) {
  const double h = data.grid.cell_size(), zone = joint_zone * h;
  const double width = Dim == 2 ? face : std::sqrt(face);
  const Vec3 x = in_space<Dim>(data.points.template position<Dim>(contact.row));
  const Vec3 foot = in_space<Dim>(contact.foot), normal = in_space<Dim>(contact.normal);
  std::optional<EndContact<Dim>> nearest;
  for (const FaceEnd& end : face_ends(surface, x, foot, normal, Dim, zone, on_edge)) {
    const Vec3 edge = foot + std::max(0.0, end.distance) * end.outwards;
    const double covered = std::clamp(0.5 + end.distance / width, 0.0, 1.0);
    const bool nearer = !nearest || std::abs(end.distance) < std::abs(nearest->end.distance);
    if (end.distance < zone && covered > 0.0 && nearer && !is_held(edge + 0.5 * h * end.outwards) &&
        goes_on(data, contact.row, edge, foot, end)) {
      nearest = {0, end, edge - surface.motion.center(), covered * face,
                 (x - foot).dot(end.normal)};
    }
  }
  return nearest;
}

template <int Dim>
JointContacts join(const DynamicsData<Dim>& data, const std::vector<EndContact<Dim>>& ends,
                   const std::vector<Contact<Dim>>& contacts) {
  constexpr double same_face = 0.9;  // cosine
  const double h = data.grid.cell_size();
  const auto field_of = [&](const EndContact<Dim>& end) {
    return data.fields.index_of(data.points.body()[contacts[end.contact].row]);
  };
  // The cell along the edge; points of a lattice on it lie in the middle.
  const auto cell_of = [&](const EndContact<Dim>& end) {
    const Vec3 along = end.end.normal.cross(end.end.outwards);
    return Dim == 2 ? 0.0 : std::floor(along.dot(end.edge) / h + 0.37);
  };
  JointContacts joint;
  std::vector<const EndContact<Dim>*> first;
  for (const EndContact<Dim>& end : ends) {
    std::size_t k = 0;
    for (; k < first.size(); ++k) {
      const Vec3 way = end.edge - first[k]->edge;
      const bool together =
          way.norm() < (Dim == 2 ? 0.1 : 1.5) * h && std::abs(way.dot(end.end.outwards)) < 0.1 * h;
      if (together && end.end.normal.dot(first[k]->end.normal) > same_face &&
          end.end.outwards.dot(first[k]->end.outwards) > same_face &&
          cell_of(end) == cell_of(*first[k]) && field_of(end) == field_of(*first[k])) {
        break;
      }
    }
    if (k == first.size()) {
      first.push_back(&end);
      joint.emplace_back();
    }
    joint[k].push_back(end.contact);
  }
  return joint;
}

#define LAPILLI_INSTANTIATE(Dim)                                                             \
  template std::optional<EndContact<Dim>> end_contact(                                       \
      const DynamicsData<Dim>&, const ObstacleSurface&, const Contact<Dim>&, bool, double,   \
      const std::function<bool(const Vec3&)>&);                                              \
  template JointContacts join(const DynamicsData<Dim>&, const std::vector<EndContact<Dim>>&, \
                              const std::vector<Contact<Dim>>&);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
