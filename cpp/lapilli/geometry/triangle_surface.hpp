#pragma once

#include <array>
#include <string>
#include <vector>

#include "lapilli/geometry/bounds.hpp"

namespace lapilli {

/// Triangles that share vertices, as read from a file or given.
struct Triangles {
  std::vector<Vec3> vertices;            // m
  std::vector<std::array<int, 3>> rows;  // vertices of each triangle
};

/// A closed surface of triangles, ready to be asked: bounding boxes in a binary tree.
class TriangleSurface {
 public:
  /// The nearest place of the surface.
  struct Nearest {
    Vec3 place;
    double squared;  // squared distance
    std::size_t triangle;
  };

  /// Triangles with a repeated vertex are left out. `name` stands in messages. Throws
  /// std::invalid_argument if an index or a coordinate is unusable, or the surface is not closed,
  /// naming an edge: each must be run through as often one way as the other.
  TriangleSurface(Triangles triangles, const std::string& name);

  const Bounds& bounds() const { return bounds_; }
  const Triangles& triangles() const { return triangles_; }
  /// -1 where all normals point in, otherwise 1.
  double sense() const { return sense_; }
  /// Whether the surface winds around every place once or not at all: no parts overlap, and parts
  /// within others are holes. (A part that crosses itself is not told apart.)
  bool covers_once() const { return covers_once_; }
  /// Enclosed volume (m^3), positive; parts that overlap count twice.
  double volume() const;
  Nearest nearest(const Vec3& x) const;
  /// How often the surface winds around `x`, from the crossings of a ray; the ray is drawn anew
  /// where it grazes an edge. Inside is where this is not zero, so overlapping parts are joined.
  int winding(const Vec3& x) const;
  /// Unit normal of a triangle, pointing out.
  Vec3 normal(std::size_t triangle) const;

 private:
  struct Node {
    Bounds box;
    std::size_t first = 0, count = 0;  // triangles of a leaf
    std::size_t right = 0;             // the left child follows its parent
  };

  const Vec3& corner(std::size_t triangle, std::size_t which) const {
    return triangles_.vertices[static_cast<std::size_t>(triangles_.rows[triangle][which])];
  }
  void check_usable(const std::string& name) const;
  void require_closed(const std::string& name) const;
  void remove_copies();
  bool find_covers_once() const;
  bool is_crossed(std::size_t triangle, const std::vector<int>& part) const;
  double signed_volume() const;
  std::size_t build(std::size_t first, std::size_t count);
  Bounds box_of(std::size_t first, std::size_t count) const;
  bool count_crossings(const Vec3& x, const Vec3& direction, int& winding) const;

  Triangles triangles_;
  std::vector<Node> nodes_;
  Bounds bounds_;
  double sense_ = 1.0;
  bool covers_once_ = true;
};

}  // namespace lapilli
