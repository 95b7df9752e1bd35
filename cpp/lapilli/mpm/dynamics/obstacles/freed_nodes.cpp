#include "lapilli/mpm/dynamics/obstacles/freed_nodes.hpp"

#include <algorithm>

#include "lapilli/core/in_space.hpp"

namespace lapilli {
namespace {

bool holds_along(const Wall& wall) {
  return wall.kind == Wall::Kind::no_slip || wall.kind == Wall::Kind::frictional;
}

/// Call body(way to half a cell inside of it, in cells) for each rough face that holds a node.
template <int Dim, class Body>
void for_each_rough_face(const DynamicsData<Dim>& data, const NodeField<Dim>& field, Index node,
                         const Body& body) {
  constexpr int padding = Grid<Dim>::padding;
  const auto at = field.grid.node_at(node - field.offset);
  for (int axis = 0; axis < Dim; ++axis) {
    const int number = at[axis] + field.corner[axis];
    const int beyond[] = {padding - number, number - (data.grid.nodes(axis) - 1 - padding)};
    for (int side = 0; side < 2; ++side) {
      if (beyond[side] >= 0 && holds_along(data.walls[2 * axis + side])) {
        body(Vec<Dim>((side == 0 ? 1.0 : -1.0) * (beyond[side] + 0.5) * Vec<Dim>::Unit(axis)));
      }
    }
  }
}

}  // namespace

template <int Dim>
FreedNodes<Dim>::FreedNodes(const DynamicsData<Dim>& data)
    : any_(std::ranges::any_of(data.walls, holds_along)) {}

template <int Dim>
void FreedNodes<Dim>::clear() {
  for (const Index node : nodes_) {
    shares_[node] = 0.0;
  }
  nodes_.clear();
}

/// Half a cell inwards counts too: an obstacle that ends on the face drags what lies on it as one
/// that reaches through it does.
template <int Dim>
void FreedNodes<Dim>::add(const DynamicsData<Dim>& data, const std::vector<Contact<Dim>>& contacts,
                          const std::function<double(const Vec3&)>& gap) {
  constexpr double whole = 0.25;  // cells, of the depth from which a node is not held at all
  if (!any_) {
    return;
  }
  const double h = data.grid.cell_size();
  shares_.resize(static_cast<std::size_t>(data.fields.node_count()), 0.0);
  for (const Contact<Dim>& contact : contacts) {
    const NodeField<Dim>& field = data.fields.of_body(data.points.body()[contact.row]);
    for (int k = 0; k < contact.count; ++k) {
      double& share = shares_[contact.node[k]];
      const double before = share;
      for_each_rough_face<Dim>(data, field, contact.node[k], [&](const Vec<Dim>& inward) {
        share = std::max(share, std::min(1.0, contact.depth / (whole * h)));
        const Vec<Dim> place = field.grid.node_position(contact.node[k] - field.offset);
        const auto is_inside = [&](const Vec<Dim>& at) { return gap(in_space<Dim>(at)) < 0.0; };
        if (share < 1.0 && (is_inside(place) || is_inside(place + h * inward))) {
          share = 1.0;
        }
      });
      if (before == 0.0 && share > 0.0) {
        nodes_.push_back(contact.node[k]);
      }
    }
  }
}

template class FreedNodes<2>;
template class FreedNodes<3>;

}  // namespace lapilli
