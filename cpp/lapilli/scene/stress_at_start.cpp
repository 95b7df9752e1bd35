#include "lapilli/scene/stress_at_start.hpp"

#include <algorithm>

#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/place_errors.hpp"

namespace lapilli {
namespace {

double density_of(const Body& body) { return elastic_part(solids_in(body).front()).density; }

Vec3 gravity_at(const Scene& scene, double time) {
  return scene.dynamics->gravity_factor.at(time) * place(scene.dynamics->gravity);
}

}  // namespace

StressAtStart::StressAtStart(const Scene& scene, double time)
    : scene_(scene), gravity_(scene.dynamics ? gravity_at(scene, time) : Vec3(Vec3::Zero())) {
  const auto weighed = [](const Body& body) {
    return body.geostatic && body.geostatic->surface.empty();
  };
  if (std::none_of(scene.bodies.begin(), scene.bodies.end(), weighed)) {
    return;
  }
  std::vector<Overburden::Layer> layers;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const std::optional<Shape> shape = placed_shape(scene.bodies[k]);
    require_at(shape.has_value(), scene, element_path("bodies", k),
               "has no shape to be weighed by: geostatic without a surface needs shapes of all "
               "bodies");
    layers.push_back({*shape, density_of(scene.bodies[k])});
  }
  overburden_ = at_place(scene, "dynamics.gravity", [&] {
    return std::make_shared<const Overburden>(std::move(layers), gravity_, grid_bounds(scene));
  });
}

std::function<SymmetricTensor(const Vec3&)> StressAtStart::of(std::size_t body) const {
  const std::optional<GeostaticStress>& rest = scene_.bodies[body].geostatic;
  if (!rest) {
    return {};
  }
  const Vec3 gravity = gravity_;
  if (rest->surface.empty()) {
    return [rest = *rest, gravity, above = overburden_](const Vec3& at) {
      return stress_under(rest, above->at(at), gravity);
    };
  }
  return [rest = *rest, gravity, density = density_of(scene_.bodies[body])](const Vec3& at) {
    return stress_at(rest, at, gravity, density);
  };
}

}  // namespace lapilli
