#include "lapilli/geometry/height_field.hpp"

#include <cmath>

#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/esri_grid.hpp"
#include "lapilli/geometry/image_file.hpp"

namespace lapilli {
namespace {

bool is_image(const std::string& file) {
  return file.ends_with(".png") || file.ends_with(".PNG") || file.ends_with(".pgm") ||
         file.ends_with(".PGM") || file.ends_with(".ppm");
}

HeightGrid of_image(const std::string& file) {
  Image image = read_image(file);
  return {image.width, image.height, 0.0, 0.0, 0.0, std::move(image.brightness)};
}

HeightGrid of_values(const std::vector<std::vector<double>>& values) {
  HeightGrid grid;
  grid.height = static_cast<int>(values.size());
  grid.width = static_cast<int>(values.front().size());
  for (std::size_t row = 0; row < values.size(); ++row) {
    require(static_cast<int>(values[row].size()) == grid.width,
            "height_field: rows of values must be of one length, row 0 has ", grid.width, ", row ",
            row, " has ", values[row].size());
    grid.values.insert(grid.values.end(), values[row].begin(), values[row].end());
  }
  grid.spacing = 0.0;
  return grid;
}

// The heights with their spacing, place and scale; every one is finite and above the bottom.
HeightGrid heights_of(const HeightField& field) {
  const bool is_esri = !field.file.empty() && !is_image(field.file);
  HeightGrid grid = field.file.empty() ? of_values(field.values)
                    : is_esri          ? read_esri_grid(field.file)
                                       : of_image(field.file);
  if (field.spacing) {
    require_positive(*field.spacing, HeightField::kind, "spacing");
    require(!is_esri, "height_field: ", field.file, " gives its own spacing, ", grid.spacing,
            " m: leave spacing out");
    grid.spacing = *field.spacing;
  }
  require(grid.spacing > 0.0, "height_field: spacing is missing: the length between two heights");
  if (!field.origin.empty()) {
    grid.x = field.origin[0];
    grid.y = field.origin.size() > 1 ? field.origin[1] : 0.0;
  }
  for (std::size_t k = 0; k < grid.values.size(); ++k) {
    const int row = static_cast<int>(k) / grid.width, column = static_cast<int>(k) % grid.width;
    const auto name = [&](const char* what, double value) {
      require(false, "height_field: ", field.file, field.file.empty() ? "" : ": ", what, value,
              " in row ", row, ", column ", column, ", at ",
              text_of(Vec3(grid.x + column * grid.spacing,
                           grid.y + (grid.height - 1 - row) * grid.spacing, 0.0),
                      2),
              " m");
    };
    if (!std::isfinite(grid.values[k])) {
      name("there is no height, but ", grid.values[k]);
    }
    grid.values[k] *= field.scale;
    if (grid.values[k] <= field.bottom) {
      name("the height is not above the bottom: ", grid.values[k]);
    }
  }
  return grid;
}

Polygon profile_of(const HeightGrid& grid, double bottom) {
  Polygon profile;
  const double end = grid.x + (grid.width - 1) * grid.spacing;
  profile.vertices = {{grid.x, bottom}, {end, bottom}};
  for (int column = grid.width - 1; column >= 0; --column) {
    profile.vertices.push_back(
        {grid.x + column * grid.spacing, grid.values[static_cast<std::size_t>(column)]});
  }
  return profile;
}

class GroundTriangles {
 public:
  GroundTriangles(const HeightGrid& grid, double bottom) : grid_(grid), bottom_(bottom) {
    for (int row = 0; row < grid.height; ++row) {
      for (int column = 0; column < grid.width; ++column) {
        const auto k = static_cast<std::size_t>(row * grid.width + column);
        all_.vertices.push_back({grid.x + column * grid.spacing,
                                 grid.y + (grid.height - 1 - row) * grid.spacing, grid.values[k]});
      }
    }
    add_top();
    add_sides();
  }

  Triangles take() { return std::move(all_); }

 private:
  int vertex(int row, int column) const { return row * grid_.width + column; }

  void add_top() {
    for (int row = 0; row + 1 < grid_.height; ++row) {
      for (int column = 0; column + 1 < grid_.width; ++column) {
        const int a = vertex(row + 1, column), b = vertex(row + 1, column + 1),
                  c = vertex(row, column + 1), d = vertex(row, column);
        all_.rows.push_back({a, b, c});
        all_.rows.push_back({a, c, d});
      }
    }
  }

  // The rim, counter-clockwise seen from above.
  std::vector<int> rim() const {
    std::vector<int> around;
    const int right = grid_.width - 1, low = grid_.height - 1;
    for (int column = 0; column < right; ++column) {
      around.push_back(vertex(low, column));
    }
    for (int row = low; row > 0; --row) {
      around.push_back(vertex(row, right));
    }
    for (int column = right; column > 0; --column) {
      around.push_back(vertex(0, column));
    }
    for (int row = 0; row < low; ++row) {
      around.push_back(vertex(row, 0));
    }
    return around;
  }

  void add_sides() {
    const std::vector<int> top = rim();
    const int count = static_cast<int>(top.size()), first = static_cast<int>(all_.vertices.size());
    Vec3 middle = Vec3::Zero();
    for (const int k : top) {
      Vec3 below = all_.vertices[static_cast<std::size_t>(k)];
      below[2] = bottom_;
      all_.vertices.push_back(below);
      middle += below / count;
    }
    all_.vertices.push_back(middle);
    for (int k = 0; k < count; ++k) {
      const int next = (k + 1) % count;
      const int a = top[static_cast<std::size_t>(k)], b = top[static_cast<std::size_t>(next)];
      all_.rows.push_back({first + k, first + next, b});
      all_.rows.push_back({first + k, b, a});
      all_.rows.push_back({first + next, first + k, first + count});
    }
  }

  const HeightGrid& grid_;
  double bottom_;
  Triangles all_;
};

template <class Ask>
auto ask(const HeightField& field, const Ask& question) {
  require(field.mesh || field.profile,
          "height_field: asked before it was checked; call check(shape, dimension) first");
  return field.mesh ? question(*field.mesh) : question(*field.profile);
}

}  // namespace

double HeightField::distance(const Vec3& x) const {
  return ask(*this, [&](const auto& shape) { return shape.distance(x); });
}

Vec3 HeightField::gradient(const Vec3& x) const {
  return ask(*this, [&](const auto& shape) { return shape.gradient(x); });
}

Bounds HeightField::bounds() const {
  return ask(*this, [](const auto& shape) { return shape.bounds(); });
}

void HeightField::check(int dimension) const {
  require_dimension(dimension, 2, kind, "a box");
  require_positive(scale, kind, "scale");
  require(std::isfinite(bottom), "height_field: bottom must be finite, got ", bottom);
  require_numbers(origin, 0, static_cast<std::size_t>(dimension - 1), kind, "origin");
  require(file.empty() != values.empty(), file.empty()
                                              ? "height_field: give a file or values"
                                              : "height_field: give a file or values, not both");
  const HeightGrid grid = heights_of(*this);
  mesh = nullptr;
  profile = nullptr;
  if (dimension == 2) {
    require(grid.height == 1 && grid.width >= 2,
            "height_field: in two dimensions one row of at least two heights is needed, got ",
            grid.height, " x ", grid.width);
    profile = std::make_shared<const Polygon>(profile_of(grid, bottom));
    return;
  }
  require(grid.height >= 2 && grid.width >= 2,
          "height_field: in three dimensions at least 2 x 2 heights are needed, got ", grid.height,
          " x ", grid.width);
  Mesh ground;
  ground.surface = std::make_shared<const TriangleSurface>(GroundTriangles(grid, bottom).take(),
                                                           file.empty() ? kind : file);
  mesh = std::make_shared<const Mesh>(std::move(ground));
}

}  // namespace lapilli
