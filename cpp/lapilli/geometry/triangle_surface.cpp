#include "lapilli/geometry/triangle_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/random.hpp"

namespace lapilli {
namespace {

constexpr std::size_t leaf_size = 4;

double squared_distance(const Bounds& box, const Vec3& x) {
  return (box.lower - x).cwiseMax(x - box.upper).cwiseMax(0.0).squaredNorm();
}

bool crosses(const Bounds& box, const Vec3& from, const Vec3& inverse_direction) {
  const Vec3 a = (box.lower - from).cwiseProduct(inverse_direction);
  const Vec3 b = (box.upper - from).cwiseProduct(inverse_direction);
  return a.cwiseMax(b).minCoeff() >= std::max(0.0, a.cwiseMin(b).maxCoeff()) * (1.0 - 1e-12);
}

// Nearest place of the triangle a, b, c (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
Vec3 nearest_place(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a;
  const double d1 = ab.dot(x - a), d2 = ac.dot(x - a);
  if (d1 <= 0.0 && d2 <= 0.0) {
    return a;
  }
  const double d3 = ab.dot(x - b), d4 = ac.dot(x - b);
  if (d3 >= 0.0 && d4 <= d3) {
    return b;
  }
  const double beyond_ab = d1 * d4 - d3 * d2;
  if (beyond_ab <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    return a + d1 / (d1 - d3) * ab;
  }
  const double d5 = ab.dot(x - c), d6 = ac.dot(x - c);
  if (d6 >= 0.0 && d5 <= d6) {
    return c;
  }
  const double beyond_ac = d5 * d2 - d1 * d6;
  if (beyond_ac <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    return a + d2 / (d2 - d6) * ac;
  }
  const double beyond_bc = d3 * d6 - d5 * d4;
  if (beyond_bc <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  }
  const double whole = beyond_ab + beyond_ac + beyond_bc;
  return a + beyond_ac / whole * ab + beyond_ab / whole * ac;
}

}  // namespace

TriangleSurface::TriangleSurface(Triangles triangles, const std::string& name)
    : triangles_(std::move(triangles)) {
  check_usable(name);
  std::erase_if(triangles_.rows, [](const std::array<int, 3>& row) {
    return row[0] == row[1] || row[1] == row[2] || row[2] == row[0];
  });
  require(!triangles_.rows.empty(), name, ": the surface has no triangles");
  remove_copies();
  require_closed(name);
  sense_ = signed_volume() < 0.0 ? -1.0 : 1.0;
  nodes_.reserve(triangles_.rows.size());
  build(0, triangles_.rows.size());
  bounds_ = nodes_.front().box;
  covers_once_ = find_covers_once();
}

// A triangle given twice is meant once.
void TriangleSurface::remove_copies() {
  const auto turned = [](std::array<int, 3> row) {
    std::rotate(row.begin(), std::min_element(row.begin(), row.end()), row.end());
    return row;
  };
  std::set<std::array<int, 3>> known;
  std::erase_if(triangles_.rows,
                [&](const std::array<int, 3>& row) { return !known.insert(turned(row)).second; });
}

void TriangleSurface::check_usable(const std::string& name) const {
  const int count = static_cast<int>(triangles_.vertices.size());
  for (std::size_t k = 0; k < triangles_.vertices.size(); ++k) {
    require(triangles_.vertices[k].allFinite(), name, ": vertex ", k,
            " is not finite: ", text_of(triangles_.vertices[k]));
  }
  for (std::size_t k = 0; k < triangles_.rows.size(); ++k) {
    for (int vertex : triangles_.rows[k]) {
      require(vertex >= 0 && vertex < count, name, ": triangle ", k, " names vertex ", vertex,
              ", there are vertices 0 to ", count - 1);
    }
  }
}

void TriangleSurface::require_closed(const std::string& name) const {
  std::map<std::pair<int, int>, int> runs;  // forwards less backwards
  for (const auto& row : triangles_.rows) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = row[k], to = row[(k + 1) % 3];
      runs[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }
  std::size_t open = 0;
  const std::pair<const std::pair<int, int>, int>* example = nullptr;
  for (const auto& edge : runs) {
    if (edge.second != 0) {
      example = open++ == 0 ? &edge : example;
    }
  }
  if (example != nullptr) {
    const Vec3& a = triangles_.vertices[static_cast<std::size_t>(example->first.first)];
    const Vec3& b = triangles_.vertices[static_cast<std::size_t>(example->first.second)];
    require(false, name, ": the surface is not closed, or triangles are turned inside out: edge ",
            text_of(a), " to ", text_of(b), " lacks its other triangle (", open,
            open == 1 ? " such edge)" : " such edges)");
  }
}

double TriangleSurface::signed_volume() const {
  const Vec3& from = corner(0, 0);
  double six_times = 0.0;
  for (std::size_t k = 0; k < triangles_.rows.size(); ++k) {
    const Vec3 a = corner(k, 0) - from, b = corner(k, 1) - from, c = corner(k, 2) - from;
    six_times += a.dot(b.cross(c));
  }
  return six_times / 6.0;
}

double TriangleSurface::volume() const { return std::abs(signed_volume()); }

Vec3 TriangleSurface::normal(std::size_t triangle) const {
  const Vec3 a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
  return sense_ * (b - a).cross(c - a).normalized();
}

Bounds TriangleSurface::box_of(std::size_t first, std::size_t count) const {
  Bounds box{corner(first, 0), corner(first, 0)};
  for (std::size_t k = first; k < first + count; ++k) {
    for (std::size_t which = 0; which < 3; ++which) {
      box.lower = box.lower.cwiseMin(corner(k, which));
      box.upper = box.upper.cwiseMax(corner(k, which));
    }
  }
  return box;
}

std::size_t TriangleSurface::build(std::size_t first, std::size_t count) {
  const std::size_t self = nodes_.size();
  nodes_.push_back({box_of(first, count), first, count, 0});
  if (count <= leaf_size) {
    return self;
  }
  int axis = 0;
  (nodes_[self].box.upper - nodes_[self].box.lower).maxCoeff(&axis);
  const auto middle = [&](const std::array<int, 3>& row) {
    double sum = 0.0;
    for (int vertex : row) {
      sum += triangles_.vertices[static_cast<std::size_t>(vertex)][axis];
    }
    return sum;
  };
  const auto begin = triangles_.rows.begin() + static_cast<std::ptrdiff_t>(first);
  const std::size_t half = count / 2;
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half),
                   begin + static_cast<std::ptrdiff_t>(count),
                   [&](const auto& a, const auto& b) { return middle(a) < middle(b); });
  nodes_[self].count = 0;
  build(first, half);
  nodes_[self].right = build(first + half, count - half);
  return self;
}

TriangleSurface::Nearest TriangleSurface::nearest(const Vec3& x) const {
  Nearest best{x, std::numeric_limits<double>::infinity(), 0};
  std::array<std::size_t, 64> waiting{};
  std::size_t depth = 1;
  while (depth > 0) {
    const std::size_t at = waiting[--depth];
    const Node& node = nodes_[at];
    if (squared_distance(node.box, x) >= best.squared) {
      continue;
    }
    if (node.count == 0) {
      const std::size_t left = at + 1, right = node.right;
      const bool left_first =
          squared_distance(nodes_[left].box, x) <= squared_distance(nodes_[right].box, x);
      waiting[depth++] = left_first ? right : left;
      waiting[depth++] = left_first ? left : right;
      continue;
    }
    for (std::size_t k = node.first; k < node.first + node.count; ++k) {
      const Vec3 candidate = nearest_place(x, corner(k, 0), corner(k, 1), corner(k, 2));
      const double squared = (x - candidate).squaredNorm();
      if (squared < best.squared) {
        best = {candidate, squared, k};
      }
    }
  }
  return best;
}

// False where the ray comes so near to an edge that rounding could decide.
bool TriangleSurface::count_crossings(const Vec3& x, const Vec3& direction, int& winding) const {
  constexpr double grazing = 1e-9;
  const Vec3 inverse = direction.cwiseInverse();
  std::array<std::size_t, 64> waiting{};
  std::size_t depth = 1;
  winding = 0;
  while (depth > 0) {
    const std::size_t at = waiting[--depth];
    const Node& node = nodes_[at];
    if (!crosses(node.box, x, inverse)) {
      continue;
    }
    if (node.count == 0) {
      waiting[depth++] = at + 1;
      waiting[depth++] = node.right;
      continue;
    }
    for (std::size_t k = node.first; k < node.first + node.count; ++k) {
      // Moeller and Trumbore 1997.
      const Vec3 ab = corner(k, 1) - corner(k, 0), ac = corner(k, 2) - corner(k, 0);
      const Vec3 across = direction.cross(ac);
      const double facing = ab.dot(across);
      if (facing == 0.0) {
        continue;
      }
      const Vec3 from = x - corner(k, 0);
      const double u = from.dot(across) / facing;
      const double v = direction.dot(from.cross(ab)) / facing;
      const double least = std::min({u, v, 1.0 - u - v});
      const double way = ac.dot(from.cross(ab)) / facing;
      if (least < -grazing || way < 0.0) {
        continue;
      }
      if (least < grazing) {
        return false;
      }
      winding += facing > 0.0 ? -1 : 1;
    }
  }
  return true;
}

int TriangleSurface::winding(const Vec3& x) const {
  int count = 0;
  if (squared_distance(bounds_, x) > 0.0) {
    return count;
  }
  Random random(1);
  for (int draw = 0; draw < 32; ++draw) {
    const Vec3 direction(random.uniform(0.1, 1.0), random.uniform(0.1, 1.0),
                         random.uniform(0.1, 1.0));
    if (count_crossings(x, direction, count)) {
      break;
    }
  }
  return count;
}

}  // namespace lapilli
