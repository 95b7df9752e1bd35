#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>

#include "lapilli/geometry/triangle_surface.hpp"

namespace lapilli {
namespace {

// Whether the segment from a to b passes through the inside of the triangle.
bool passes_through(const Vec3& a, const Vec3& b, const Vec3& p, const Vec3& q, const Vec3& r) {
  const Vec3 normal = (q - p).cross(r - p);
  const double from = normal.dot(a - p), to = normal.dot(b - p);
  // Segments that only touch do not cross; touching parts cover their places once.
  const double slack = 1e-12 * normal.norm() * ((b - a).norm() + (q - p).norm());
  if (std::min(from, to) >= -slack || std::max(from, to) <= slack) {
    return false;
  }
  const Vec3 x = a + from / (from - to) * (b - a);
  const auto inside = [&](const Vec3& u, const Vec3& v) {
    return normal.dot((v - u).cross(x - u)) >= 0.0;
  };
  return inside(p, q) && inside(q, r) && inside(r, p);
}

// Which part of the surface each triangle belongs to: parts share no vertex. Numbered from 0.
std::vector<int> surface_parts(const Triangles& triangles) {
  std::vector<int> parent(triangles.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int vertex) {
    while (parent[static_cast<std::size_t>(vertex)] != vertex) {
      int& up = parent[static_cast<std::size_t>(vertex)];
      vertex = up = parent[static_cast<std::size_t>(up)];
    }
    return vertex;
  };
  for (const auto& row : triangles.rows) {
    parent[static_cast<std::size_t>(root(row[1]))] = root(row[0]);
    parent[static_cast<std::size_t>(root(row[2]))] = root(row[0]);
  }
  std::map<int, int> number;
  std::vector<int> part;
  for (const auto& row : triangles.rows) {
    part.push_back(number.try_emplace(root(row[0]), static_cast<int>(number.size())).first->second);
  }
  return part;
}

}  // namespace

// Whether an edge of the triangle passes through a triangle of another part.
bool TriangleSurface::is_crossed(std::size_t triangle, const std::vector<int>& part) const {
  const Bounds own = box_of(triangle, 1);
  std::vector<std::size_t> waiting{0};
  while (!waiting.empty()) {
    const std::size_t at = waiting.back();
    waiting.pop_back();
    const Node& node = nodes_[at];
    if ((node.box.lower.array() > own.upper.array()).any() ||
        (own.lower.array() > node.box.upper.array()).any()) {
      continue;
    }
    if (node.count == 0) {
      waiting.push_back(at + 1);
      waiting.push_back(node.right);
    }
    for (std::size_t k = node.first; k < node.first + node.count; ++k) {
      for (std::size_t edge = 0; edge < 3 && part[k] != part[triangle]; ++edge) {
        if (passes_through(corner(triangle, edge), corner(triangle, (edge + 1) % 3), corner(k, 0),
                           corner(k, 1), corner(k, 2))) {
          return true;
        }
      }
    }
  }
  return false;
}

// The parts of the surface, joined by vertices, may touch but not cross, and each must have 0 on
// one side and its sense on the other.
bool TriangleSurface::find_covers_once() const {
  const std::vector<int> part = surface_parts(triangles_);
  std::vector<Bounds> boxes;
  std::vector<std::size_t> example;
  for (std::size_t k = 0; k < triangles_.rows.size(); ++k) {
    const auto which = static_cast<std::size_t>(part[k]);
    if (which >= boxes.size()) {
      boxes.resize(which + 1, box_of(k, 1));
      example.resize(which + 1, k);
    }
    const Bounds one = box_of(k, 1);
    boxes[which].lower = boxes[which].lower.cwiseMin(one.lower);
    boxes[which].upper = boxes[which].upper.cwiseMax(one.upper);
  }
  std::vector<bool> meets(boxes.size(), false);
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      const bool apart = (boxes[a].lower.array() > boxes[b].upper.array()).any() ||
                         (boxes[b].lower.array() > boxes[a].upper.array()).any();
      meets[a] = meets[a] || (a != b && !apart);
    }
  }
  for (std::size_t k = 0; k < triangles_.rows.size(); ++k) {
    if (meets[static_cast<std::size_t>(part[k])] && is_crossed(k, part)) {
      return false;
    }
  }
  for (std::size_t which = 0; which < boxes.size(); ++which) {
    const std::size_t k = example[which];
    const Vec3 middle = (corner(k, 0) + corner(k, 1) + corner(k, 2)) / 3.0;
    const double step = 1e-7 * (bounds_.upper - bounds_.lower).norm();
    for (const double side : {-step, step}) {
      const int around = winding(middle + side * normal(k));
      if (around != 0 && around != static_cast<int>(sense_)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace lapilli
