#include "lapilli/scene/validate_peridynamics.hpp"

#include <algorithm>
#include <set>

#include "lapilli/scene/place_errors.hpp"

namespace lapilli {
namespace {

// One fluid: every body holds what the section needs, and the same.
template <class Wanted>
void check_material(const Scene& scene, const std::string& section) {
  const Wanted* first = material_in<Wanted>(scene.bodies[0]);
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Wanted* material = material_in<Wanted>(scene.bodies[k]);
    const std::string path = element_path("bodies", k) + ".material";
    require_at(material != nullptr, scene, path, "has no ", Wanted::kind, " material, which [",
               section, "] needs");
    require_at(*material == *first, scene, path,
               "differs from that of body 0: a peridynamic scene has one fluid");
  }
}

void check_walls(const Scene& scene) {
  const std::vector<FluidWallBody>& walls = scene.peridynamics->walls;
  std::set<std::string> names;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const std::string path = element_path("peridynamics.walls", k);
    at_place(scene, path, [&] { check(walls[k], static_cast<int>(scene.grid.lower.size())); });
    require_at(names.insert(walls[k].name).second, scene, path + ".name", "is '", walls[k].name,
               "' as that of another wall: balances tell walls by their names");
    const auto& flow = scene.peridynamics->flow;
    const bool two_field = flow && (flow->laplacian == Laplacian::literal ||
                                    flow->laplacian == Laplacian::zero_energy);
    require_at(
        !two_field || walls[k].slip == Slip::no_slip, scene, path + ".slip",
        "free-slip needs peridynamics.flow.laplacian = \"corrected\" or \"compact\": with \"",
        flow ? name_of(flow->laplacian) : "", "\" the fluid sticks to every wall");
  }
}

void check_gravity(const Scene& scene) {
  const PeridynamicFlowSettings& flow = *scene.peridynamics->flow;
  const std::size_t given = flow.gravity.size();
  require_at(given == 0 || given == scene.grid.lower.size(), scene, "peridynamics.flow.gravity",
             "has ", given, " numbers, the grid has dimension ", scene.grid.lower.size());
  const bool pulls = std::any_of(flow.gravity.begin(), flow.gravity.end(),
                                 [](double component) { return component != 0.0; });
  const bool buoyant =
      scene.peridynamics->heat && material_in<Newtonian>(scene.bodies[0])->thermal_expansion != 0.0;
  require_at(!pulls || buoyant || flow.buoyancy == Buoyancy::full, scene,
             "peridynamics.flow.gravity",
             "does nothing: with buoyancy = \"reduced\" it acts by temperature and needs ",
             "[peridynamics.heat] and a thermal_expansion of the newtonian material");
}

}  // namespace

void validate_peridynamics(const Scene& scene) {
  if (!scene.peridynamics) {
    return;
  }
  require_at(!scene.heat, scene, "heat",
             "is of the material point method; give [peridynamics.heat] instead");
  require_at(!scene.quasi_static, scene, "quasi_static",
             "is of the material point method, which shares no scene with [peridynamics]");
  require_at(!scene.dynamics, scene, "dynamics",
             "is of the material point method, which shares no scene with [peridynamics]");
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    require_at(!scene.bodies[k].motion, scene, element_path("bodies", k) + ".motion",
               "has no meaning in [peridynamics]: a fluid moves by its flow");
  }
  require_at(scene.peridynamics->heat || scene.peridynamics->flow, scene, "peridynamics",
             "models nothing: give [peridynamics.heat], [peridynamics.flow] or both");
  check_walls(scene);
  if (scene.peridynamics->heat) {
    check_material<Thermal>(scene, "peridynamics.heat");
  }
  if (scene.peridynamics->flow) {
    check_material<Newtonian>(scene, "peridynamics.flow");
    check_gravity(scene);
  }
}

}  // namespace lapilli
