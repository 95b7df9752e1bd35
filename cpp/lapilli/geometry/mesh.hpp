#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/geometry/triangle_surface.hpp"

namespace lapilli {

/// Body inside a closed surface of triangles, from an STL file or given vertices and triangles. The
/// distance is exact. Parts that overlap are joined, but inside the other part the distance is that
/// to the nearest triangle, which may lie inside the body; surfaces that cross themselves otherwise
/// are not told apart from sound ones.
struct Mesh {
  static constexpr const char* kind = "mesh";
  std::string file;                           // STL, binary or text; or vertices and triangles
  double scale = 1.0;                         // m per unit of the file or the vertices
  std::vector<std::vector<double>> vertices;  // rows of 3
  std::vector<std::vector<int>> triangles;    // rows of 3 vertices, counted from 0

  /// What `check` made of the members above; copies share it.
  mutable std::shared_ptr<const TriangleSurface> surface;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("file").file().text("STL file of a closed surface, binary or text"), self.file);
    visit(Key("scale").unit("m").positive().text("length of one unit of the file"), self.scale);
    visit(Key("vertices").text("corners, where no file is given"), self.vertices);
    visit(Key("triangles").text("rows of three vertices, counted from 0"), self.triangles);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

}  // namespace lapilli
