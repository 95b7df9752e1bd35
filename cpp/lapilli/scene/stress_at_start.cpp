#include "lapilli/scene/stress_at_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/geometry/checks.hpp"
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

BearableK0::Stress StressAtStart::by_k0(std::size_t body, const Vec3& at) const {
  GeostaticStress rest = *scene_.bodies[body].geostatic;
  if (rest.surface.empty()) {
    return [rest, weight = overburden_->at(at), gravity = gravity_](double k0) mutable {
      rest.k0 = k0;
      return stress_under(rest, weight, gravity);
    };
  }
  return
      [rest, at, gravity = gravity_, density = density_of(scene_.bodies[body])](double k0) mutable {
        rest.k0 = k0;
        return stress_at(rest, at, gravity, density);
      };
}

std::function<SymmetricTensor(const Vec3&)> StressAtStart::of(std::size_t body) const {
  const std::optional<GeostaticStress>& rest = scene_.bodies[body].geostatic;
  if (!rest) {
    return {};
  }
  const BearableK0 bearable(solids_in(scene_.bodies[body]).front());
  return [this, body, bearable, k0 = rest->k0](const Vec3& at) {
    const BearableK0::Stress stress = by_k0(body, at);
    const std::optional<double> borne = bearable.nearest(stress, k0);
    Worst& worst = worst_[body];
    ++worst.asked;
    if (borne && *borne == k0) {
      return stress(k0);
    }
    ++worst.not_borne;
    const double away = borne ? std::abs(*borne - k0) : std::numeric_limits<double>::infinity();
    if (away > worst.away) {
      worst.away = away;
      worst.place = at;
      worst.borne = bearable.range(stress);
    }
    return stress(borne.value_or(k0));
  };
}

std::vector<Note> StressAtStart::notes() const {
  std::vector<Note> all;
  for (const auto& [body, worst] : worst_) {
    if (worst.not_borne == 0) {
      continue;
    }
    const Body& which = scene_.bodies[body];
    const std::string name =
        which.name.empty() ? message("body ", body) : message("body '", which.name, "'");
    const std::string at = text_of(worst.place, dimension_of(scene_));
    Note said = note("dynamics.k0-beyond-strength", "geostatic k0 = ", which.geostatic->k0,
                     " is more than the strength of ", name, " bears at ", worst.not_borne, " of ",
                     worst.asked, " points: at ", at);
    said.text += worst.borne ? message(" it bears ", worst.borne->lower, " to ", worst.borne->upper,
                                       ", and such points start with the nearest that they bear")
                             : message(" it bears none, and the body starts to yield at once");
    all.push_back(std::move(said));
  }
  return all;
}

}  // namespace lapilli
