#include "lapilli/scene/body_volumes.hpp"

#include <cmath>

#include "lapilli/core/points.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/geometry/shape_volume.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/resolve_files.hpp"

namespace lapilli {
namespace {

// Points this near to the volume of their shape, as a share, are taken for it.
constexpr double allowed_share = 1e-3;

double volume_of_shape(const Scene& scene, const Body& body) {
  const auto [lattice, options] = lattice_of(scene, body);
  return volume_of(*body.shape, lattice, options, dimension_of(scene));
}

std::vector<BodyVolume> volumes_of_points(const Scene& scene, const Points& points) {
  std::vector<BodyVolume> all;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const std::string& name = scene.bodies[k].name;
    all.push_back({name.empty() ? message("body ", k) : name, 0, 0.0, {}});
  }
  for (Index row = 0; row < points.size(); ++row) {
    const auto body = static_cast<std::size_t>(points.body()[static_cast<std::size_t>(row)]);
    if (body < all.size()) {  // what follows are walls
      ++all[body].points;
      all[body].volume += points.volume()[static_cast<std::size_t>(row)];
    }
  }
  return all;
}

}  // namespace

std::vector<BodyVolume> body_volumes(const Scene& as_written, const Points& points) {
  const Scene scene = with_resolved_files(as_written);
  std::vector<BodyVolume> all = volumes_of_points(scene, points);
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (scene.bodies[k].shape) {
      all[k].of_shape = volume_of_shape(scene, scene.bodies[k]);
    }
  }
  return all;
}

std::vector<BodyVolume> body_volumes_at_start(const Scene& as_written, const Points& points) {
  const Scene scene = with_resolved_files(as_written);
  std::vector<BodyVolume> all = volumes_of_points(scene, points);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Body& body = scene.bodies[k];
    if (body.shape) {
      const bool is_sum_of_parts = is_filled_exactly(scene, body) || body.random;
      all[k].of_shape = is_sum_of_parts ? all[k].volume : volume_of_shape(scene, body);
    }
  }
  return all;
}

std::vector<std::string> volume_warnings(const std::vector<BodyVolume>& volumes, int dimension) {
  constexpr const char* sizes[] = {"length", "area", "volume"};
  std::vector<std::string> all;
  for (const BodyVolume& body : volumes) {
    const double share = body.of_shape ? body.volume / *body.of_shape - 1.0 : 0.0;
    if (std::abs(share) > allowed_share) {
      all.push_back(message("the points of ", body.name, " hold ",
                            0.01 * std::round(1e4 * std::abs(share)), " % ",
                            share > 0.0 ? "more" : "less", " ", sizes[dimension - 1],
                            " than its shape: set fill = \"exact\", or choose smaller cells"));
    }
  }
  return all;
}

}  // namespace lapilli
