#pragma once

#include <map>

#include "lapilli/geometry/mesh.hpp"

namespace lapilli {

inline Mesh cube_mesh(double from = 0.0, double to = 1.0) {
  Mesh mesh;
  for (int k = 0; k < 8; ++k) {
    mesh.vertices.push_back({k & 1 ? to : from, k & 2 ? to : from, k & 4 ? to : from});
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

// An octahedron whose triangles are split in four `levels` times, vertices on the unit sphere.
inline Mesh ball_mesh(int levels) {
  Mesh mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), mesh.vertices.size());
      if (is_new) {
        const Vec3 at = (place(mesh.vertices[a]) + place(mesh.vertices[b])).normalized();
        mesh.vertices.push_back({at[0], at[1], at[2]});
      }
      return entry->second;
    };
    std::vector<std::vector<int>> finer;
    for (const auto& row : mesh.triangles) {
      const int a = row[0], b = row[1], c = row[2];
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  return mesh;
}

inline Mesh turned_inside_out(Mesh mesh) {
  for (auto& row : mesh.triangles) {
    std::swap(row[1], row[2]);
  }
  return mesh;
}

/// Both surfaces as one mesh.
inline Mesh joined(Mesh mesh, const Mesh& other) {
  const int count = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& row : other.triangles) {
    mesh.triangles.push_back({row[0] + count, row[1] + count, row[2] + count});
  }
  return mesh;
}

}  // namespace lapilli
