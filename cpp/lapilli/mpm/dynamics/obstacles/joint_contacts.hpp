#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "lapilli/mpm/dynamics/dynamics_data.hpp"
#include "lapilli/mpm/dynamics/obstacles/contact.hpp"
#include "lapilli/mpm/dynamics/obstacles/obstacle_surface.hpp"

namespace lapilli {

/// A contact near the end of a face of an obstacle, beyond which the material goes on, free: beside
/// a footing, below a tool. Functions of the grid cannot part there. Held point by point, the node
/// at the end would go with the obstacle and carry half a cell of what is free along, up to one and
/// a half cells where the face ends just behind a node. What yields is held by one traction over
/// the last cells of the face instead, as flow makes it anyway, and their mean velocity.
template <int Dim>
struct EndContact {
  std::size_t contact = 0;
  FaceEnd end;
  Vec3 edge;          // m, from the centre of the obstacle
  double face = 0.0;  // m^(Dim-1), of the point's that the obstacle covers
  double gap = 0.0;   // m, from the plane of the face
};

/// Cells from its end over which a face bears one traction. Measured, strip footings at 16 places:
/// 1.5 cells .5 % more load, 1 cell 2 %.
inline constexpr double joint_zone = 2.0;

/// Of the ends of faces beside a contact's point the one that it belongs to, if any. `face`:
/// m^(Dim-1), of the point; `is_held`: whether another obstacle is at a place.
template <int Dim>
std::optional<EndContact<Dim>> end_contact(const DynamicsData<Dim>& data,
                                           const ObstacleSurface& surface,
                                           const Contact<Dim>& contact, bool on_edge, double face,
                                           const std::function<bool(const Vec3&)>& is_held);

/// Those that bear one traction, a list for each end (in space: and cell along it).
template <int Dim>
JointContacts join(const DynamicsData<Dim>& data, const std::vector<EndContact<Dim>>& ends,
                   const std::vector<Contact<Dim>>& contacts);

}  // namespace lapilli
