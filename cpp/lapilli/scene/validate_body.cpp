#include "lapilli/scene/validate_body.hpp"

#include <algorithm>

#include "lapilli/core/allowed.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/build_peridynamics.hpp"
#include "lapilli/scene/place_errors.hpp"

namespace lapilli {

void check_dimension(const Scene& scene, const std::vector<double>& list, const std::string& path) {
  require_at(list.empty() || list.size() == scene.grid.lower.size(), scene, path, "must have ",
             scene.grid.lower.size(), " numbers, as many as the grid has dimensions, got ",
             list.size());
}

namespace {

void check_axis(const Scene& scene, const std::vector<double>& axis, const std::string& path) {
  require_at(place(axis).norm() > 0.0, scene, path, "must have a length above 0");
}

template <class Known>
void check_material(const Known& material) {
  check(material);
}
// Couplings have no check beyond the range of their numbers.
void check_material(const ThermalExpansion&) {}
void check_material(const PlasticHeating&) {}

/// "elastic, mohr_coulomb": the kinds of a variant.
template <class... Kinds>
std::string kinds_of(const std::variant<Kinds...>*) {
  std::vector<std::string> kinds{Kinds::kind...};
  return joined(kinds);
}
std::string solid_kinds() { return kinds_of(static_cast<const Solid*>(nullptr)); }

bool is_coupling(const Material& material) {
  return std::holds_alternative<ThermalExpansion>(material) ||
         std::holds_alternative<PlasticHeating>(material);
}

/// Of the undeformed body, kg/m^3; 0 of a material without one.
struct DensityOf {
  double operator()(const HasElasticPart auto& solid) const { return solid.elastic_part().density; }
  double operator()(const Thermal& material) const { return material.density; }
  double operator()(const Newtonian& material) const { return material.density; }
  double operator()(const ThermalExpansion&) const { return 0.0; }
  double operator()(const PlasticHeating&) const { return 0.0; }
};

void check_motion(const Scene& scene, const Motion& motion, const std::string& path) {
  if (const auto* turn = std::get_if<Rotation>(&motion)) {
    require_at(dimension_of(scene) > 1, scene, path, "cannot turn a body in one dimension");
    check_dimension(scene, turn->center, path + ".center");
    check_axis(scene, turn->axis, path + ".axis");
  } else if (const auto* line = std::get_if<Translation>(&motion)) {
    check_dimension(scene, line->velocity, path + ".velocity");
  } else {
    require_at(dimension_of(scene) == 2, scene, path, "a swirl needs two dimensions");
    check_dimension(scene, std::get<Swirl>(motion).center, path + ".center");
  }
}

void check_dynamics_body(const Scene& scene, const Body& body, const std::string& path) {
  if (!scene.dynamics) {
    require_at(body.velocity.empty() || scene.peridynamics, scene, path + ".velocity",
               "has no effect without [dynamics] or [peridynamics]; a prescribed motion is "
               "`motion`");
    require_at(!body.geostatic, scene, path + ".geostatic", "has no effect without [dynamics]");
    require_at(body.spin.empty(), scene, path + ".spin", "has no effect without [dynamics]");
    return;
  }
  require_at(solids_in(body).size() == 1, scene, path + ".material", "has no solid material (",
             solid_kinds(), "), which [dynamics] needs");
  require_at(!body.motion, scene, path + ".motion",
             "contradicts [dynamics], which moves every body");
  if (body.geostatic) {
    check_dimension(scene, body.geostatic->surface, path + ".geostatic.surface");
    check_dimension(scene, body.geostatic->normal, path + ".geostatic.normal");
    require_at(body.geostatic->normal.empty() || !body.geostatic->surface.empty(), scene,
               path + ".geostatic.normal", "needs a surface, a place that it belongs to");
  }
  double density = 0.0;
  for (const Material& material : body.material) {
    const double here = std::visit(DensityOf(), material);
    require_at(density == 0.0 || here == 0.0 || here == density, scene, path + ".material",
               "has two densities, ", density, " and ", here,
               " kg/m^3; both are of the undeformed body and must agree");
    density = std::max(density, here);
  }
}

void check_place(const Scene& scene, const Body& body, const std::string& path) {
  check_dimension(scene, body.rotation_center, path + ".rotation_center");
  check_dimension(scene, body.translation, path + ".translation");
  check_dimension(scene, body.velocity, path + ".velocity");
  check_dimension(scene, body.spin_center, path + ".spin_center");
  const std::size_t rates = dimension_of(scene) == 3 ? 3 : 1;
  require_at(body.spin.empty() || (body.spin.size() == rates && dimension_of(scene) > 1), scene,
             path + ".spin", "needs ", rates == 3 ? "three numbers" : "one number",
             ", radians a second, in ", dimension_of(scene), " dimensions");
  require_at(body.spin_center.empty() || !body.spin.empty(), scene, path + ".spin_center",
             "has no effect without spin");
  check_axis(scene, body.rotation_axis, path + ".rotation_axis");
  require_at(body.rotation == 0.0 || dimension_of(scene) > 1, scene, path + ".rotation",
             "cannot turn a body in one dimension");
  if (body.motion) {
    check_motion(scene, *body.motion, path + ".motion");
  }
}

void check_body_material(const Scene& scene, const Body& body, const std::string& path) {
  int thermal = 0, newtonian = 0;
  for (const Material& material : body.material) {
    at_place(scene, path + ".material",
             [&] { std::visit([](const auto& known) { check_material(known); }, material); });
    require_at(!is_coupling(material) || (scene.heat && scene.dynamics), scene, path + ".material",
               "couples heat and motion, the scene needs both [heat] and [dynamics]");
    thermal += std::holds_alternative<Thermal>(material);
    newtonian += std::holds_alternative<Newtonian>(material);
  }
  require_at(thermal <= 1, scene, path + ".material", "has ", thermal, " thermal materials");
  require_at(newtonian <= 1, scene, path + ".material", "has ", newtonian, " newtonian materials");
  require_at(!scene.heat || thermal == 1, scene, path + ".material",
             "has no thermal material, which [heat] needs");
  const std::size_t solids = solids_in(body).size();
  require_at(solids <= 1, scene, path + ".material", "has ", solids, " solid materials");
  require_at(!scene.quasi_static || solids == 1, scene, path + ".material",
             "has no solid material (", solid_kinds(), "), which [quasi_static] needs");
  require_at(!scene.quasi_static || !body.motion, scene, path + ".motion",
             "contradicts [quasi_static], which moves the points itself");
  require_at(!body.fill || body.shape, scene, path + ".fill",
             "has no effect on a body without a shape");
  require_at(!scene.peridynamics || body.fill != Filling::exact || conducts_at_rest(scene), scene,
             path + ".fill",
             "must be \"lattice\" in peridynamic flow, whose operators need points of one volume");
  check_dynamics_body(scene, body, path);
}

}  // namespace

void validate_body(const Scene& scene, const Body& body, const std::string& path,
                   Mistakes& mistakes) {
  mistakes.gather([&] { check_place(scene, body, path); });
  mistakes.gather([&] { check_body_material(scene, body, path); });
}

}  // namespace lapilli
