#pragma once

#include <array>
#include <span>
#include <vector>

#include "lapilli/mpm/surface/nodal_surface.hpp"

namespace lapilli {

/// Faces of the grid that bodies rest against: x lower, x upper, y lower, ...
using ContactFaces = std::array<bool, 6>;

/// Keeps the contact of bodies with walls out of their free surface: normals are those of the body
/// and its image behind the wall, and of the closed surface of a wall node the covered part of the
/// wall is taken off.
template <int Dim>
class WallContact {
 public:
  WallContact(const Grid<Dim>& grid, const ContactFaces& faces) : grid_(grid), faces_(faces) {}

  bool any() const;
  /// The flags of `outside` with the cells behind walls inside.
  std::vector<unsigned char> without_walls(std::span<const unsigned char> outside) const;
  /// The sums of the body and its images behind the walls.
  NodalSums<Dim> mirrored(const NodalSums<Dim>& sums) const;
  /// Replace the areas of the mirrored body by those of the body alone: drops nodes behind walls,
  /// and gives those on a wall half of the image's area along it and what the wall leaves
  /// uncovered. `outside` flags cells as found, `sums` are those of the body.
  void take_off(NodalAreas<Dim>& areas, const NodalSums<Dim>& sums,
                std::span<const unsigned char> outside) const;
  /// The sums of the body for loads: normals from the body and its images, and of area vectors on
  /// and behind a wall no part that points into it. Nothing else changes, so that what acts along a
  /// wall still balances the stress beside it.
  NodalSums<Dim> without_contact(const NodalSums<Dim>& sums) const;

 private:
  /// Call body(axis, side, face, inward) for every wall: `face` is its layer of nodes, `inward` +1
  /// or -1.
  template <class Body>
  void for_each_wall(const Body& body) const;
  double uncovered(Index node, int axis, int inward, const NodalSums<Dim>& sums,
                   std::span<const unsigned char> outside) const;

  Grid<Dim> grid_;
  ContactFaces faces_;
};

}  // namespace lapilli
