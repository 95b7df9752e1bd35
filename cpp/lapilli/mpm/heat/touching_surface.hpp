#pragma once

#include <span>
#include <vector>

#include "lapilli/mpm/heat/point_fields.hpp"
#include "lapilli/mpm/surface/surface_foot.hpp"

namespace lapilli {

/// A node around a surface that touches an obstacle.
template <int Dim>
struct TouchingNode {
  Index node = 0;
  double free_share = 0.0;    // of the surface of the node, which does not touch
  Vec3 place = Vec3::Zero();  // m, where it touches
};

/// What a foot exchanges with one of the nodes around it.
struct NodeLink {
  std::size_t slot = 0;  // of the node
  double area = 0.0;     // m^(dim-1)
  bool is_inner = true;  // whether the node lies in the material, not beyond the surface
};

/// A piece of surface that touches an obstacle, between the nodes below it and those beyond.
struct TouchingPiece {
  double area = 0.0;                // m^(dim-1)
  double conductivity = 0.0;        // W/(m K), across the surface
  double depth = 0.0, reach = 0.0;  // m, of the nodes below it and beyond, the mean
  double share_beyond = 0.0;        // of the linear functions
  std::size_t first_link = 0, links_end = 0;

  /// W/(m^2 K), between the obstacle and the nodes of one side, for a contact of this conductance
  /// (infinite: perfect). Nodes beyond the surface take the part of the contact that is theirs,
  /// those below it what the way to the surface lets through, less what conduction brings them from
  /// those beyond: the steady flux 1 / (1 / conductance + depth / conductivity) is exact.
  double coefficient(double conductance, bool is_inner) const;
};

/// A node beyond the surface that boxes of touching points just reach, and the one that takes its
/// heat: left to conduction, which ends at it, it would flatten the gradients of those points.
struct OuterNode {
  Index node = 0, heir = 0;
};

/// Where material touches an obstacle, for the nodes around.
template <int Dim>
struct TouchingSurface {
  std::vector<TouchingNode<Dim>> nodes;  // in the order of their numbers
  std::vector<TouchingPiece> pieces;
  std::vector<NodeLink> links;
  std::vector<OuterNode> outer;  // in the order of their numbers

  double area() const;
};

/// `feet` give places; their areas are scaled to that of the area vectors a_I = sum V grad S around
/// them, along the normal of the obstacle: exact where that is flat, corners of the body included.
/// `area_vector` and `capacity` are by node of the grid.
template <int Dim>
TouchingSurface<Dim> touching_surface(const Grid<Dim>& grid, ShapeFunction function,
                                      const Points& points,
                                      const std::vector<SurfaceFoot<Dim>>& feet,
                                      const HeatCoefficients<Dim>& coefficients,
                                      const std::vector<Vec<Dim>>& area_vector,
                                      const std::vector<double>& capacity);

}  // namespace lapilli
