#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/geometry/mesh.hpp"
#include "lapilli/geometry/polygon.hpp"

namespace lapilli {

/// The ground below heights on a regular grid, down to a flat bottom: in three dimensions two flat
/// triangles between four heights, in two dimensions straight lines between the heights of one row.
/// Up is the last axis. The distance to this surface is exact.
struct HeightField {
  static constexpr const char* kind = "height_field";
  std::string file;                         // ESRI ASCII grid, PNG or PGM; or values
  std::vector<std::vector<double>> values;  // rows from the far side, the largest y
  std::optional<double> spacing;            // m between heights; an ESRI grid knows it
  std::vector<double> origin;               // m, of the first height of the last row
  double scale = 1.0;                       // m per unit of the values; of images: of white
  double bottom = 0.0;                      // m, where the ground ends

  /// What `check` made of the members above; copies share it.
  mutable std::shared_ptr<const Mesh> mesh;        // three dimensions
  mutable std::shared_ptr<const Polygon> profile;  // two dimensions

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("file").file().text("ESRI ASCII grid of heights, PNG or PGM image"), self.file);
    visit(Key("values").text("heights, rows from the far side, where no file is given"),
          self.values);
    visit(Key("spacing").unit("m").positive().text("between heights; an ESRI grid knows it"),
          self.spacing);
    visit(Key("origin").unit("m").length(0, 2).text(
              "place of the first height of the last row; empty: that of the ESRI grid, or 0"),
          self.origin);
    visit(Key("scale").unit("m").positive().text("height of one unit; in images that of white"),
          self.scale);
    visit(Key("bottom").unit("m").required().text("where the ground ends, below all heights"),
          self.bottom);
  }

  double distance(const Vec3& x) const;
  Vec3 gradient(const Vec3& x) const;
  Bounds bounds() const;
  void check(int dimension) const;
};

}  // namespace lapilli
