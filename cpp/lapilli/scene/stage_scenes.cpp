#include "lapilli/scene/stage_scenes.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "lapilli/scene/place_errors.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/scene_file.hpp"
#include "lapilli/scene/stage_changes.hpp"

namespace lapilli {
namespace {

constexpr const char* path_of_stages = "stages";

std::string stage_path(std::size_t k) { return element_path(path_of_stages, k); }

void require_possible(const Scene& scene) {
  require_at(scene.dynamics && !scene.peridynamics, scene, path_of_stages,
             "need [dynamics]: other physics do not hand their state on to a next stage");
}

/// Names and ends of all stages, before anything is made of them.
void check_order(const Scene& scene) {
  double before = scene.time.end;
  std::set<std::string> names;
  for (std::size_t k = 0; k < scene.stages.size(); ++k) {
    const Stage& stage = scene.stages[k];
    require_at(!stage.name.empty(), scene, stage_path(k) + ".name", "must not be empty");
    require_at(names.insert(stage.name).second, scene, stage_path(k) + ".name", "is '", stage.name,
               "' as that of an earlier stage");
    require_at(stage.end > before, scene, stage_path(k) + ".end", "must be after ", before,
               " s, the end of ", k == 0 ? "the scene before it (time.end)" : "the stage before",
               ", got ", stage.end, " s");
    before = stage.end;
  }
}

StageScene first_of(Scene scene) {
  StageScene first;
  scene.stages.clear();
  first.body_before.assign(scene.bodies.size(), -1);
  first.body_number.resize(scene.bodies.size());
  std::iota(first.body_number.begin(), first.body_number.end(), Index{0});
  if (scene.dynamics) {
    first.obstacle_before.assign(scene.dynamics->obstacles.size(), -1);
    first.load_before.assign(scene.dynamics->boundaries.size(), -1);
  }
  first.scene = std::move(scene);
  return first;
}

/// Lines of the file belong to the whole scene, not to lists of which a stage has changed entries.
std::shared_ptr<const Places> file_of(const Scene& scene) {
  if (!scene.places) {
    return nullptr;
  }
  auto places = std::make_shared<Places>();
  places->source = scene.places->source;
  return places;
}

/// What moves by its mass goes on so, and what moves as it is told too.
void require_same_obstacles(const Scene& scene, std::size_t k, const StageScene& before,
                            const StageScene& next) {
  for (std::size_t one = 0; one < next.obstacle_before.size(); ++one) {
    const Obstacle& now = next.scene.dynamics->obstacles[one];
    const Obstacle& then =
        before.scene.dynamics->obstacles[static_cast<std::size_t>(next.obstacle_before[one])];
    require_at(now.mass.has_value() == then.mass.has_value(), scene, stage_path(k) + ".set",
               "gives obstacle ", now.name, " a mass or takes it: remove it and add another one");
    const bool starts_alike =
        now.velocity == then.velocity && now.revolutions_per_second == then.revolutions_per_second;
    require_at(!now.mass || starts_alike, scene, stage_path(k) + ".set", "sets the motion of ",
               now.name, ", an obstacle with a mass: it goes on with the motion that it has");
  }
}

/// Points keep their mass, whatever they are made of.
void require_same_densities(const Scene& scene, std::size_t k, const StageScene& before,
                            const StageScene& next) {
  const auto density = [](const Body& body) {
    const std::vector<Solid> solids = solids_in(body);
    return solids.empty() ? 0.0 : elastic_part(solids.front()).density;
  };
  for (std::size_t one = 0; one < next.body_before.size(); ++one) {
    const int earlier = next.body_before[one];
    if (earlier >= 0) {
      const double now = density(next.scene.bodies[one]);
      const double then = density(before.scene.bodies[static_cast<std::size_t>(earlier)]);
      require_at(now == then, scene, stage_path(k) + ".set", "makes body ",
                 next.scene.bodies[one].name, " of a density of ", now, " kg/m^3, it was ", then,
                 ": bodies that go on keep their mass");
    }
  }
}

StageScene after(const StageScene& before, const Scene& scene, std::size_t k) {
  const Stage& stage = scene.stages[k];
  StageScene next;
  next.name = stage.name;
  next.scene = before.scene;
  next.scene.initial_state.clear();
  next.scene.probes.clear();  // they are chosen once
  next.scene.places = file_of(scene);
  next.start = before.scene.time.end;
  next.scene.time.end = stage.end;
  next.at_rest = stage.reset_velocity;
  next.body_number = before.body_number;
  next.body_before.resize(before.scene.bodies.size());
  std::iota(next.body_before.begin(), next.body_before.end(), 0);
  for (Body& body : next.scene.bodies) {
    body.geostatic.reset();  // of the start
  }
  next.obstacle_before.resize(before.scene.dynamics->obstacles.size());
  std::iota(next.obstacle_before.begin(), next.obstacle_before.end(), 0);
  next.load_before.resize(before.scene.dynamics->boundaries.size());
  std::iota(next.load_before.begin(), next.load_before.end(), 0);
  remove_parts(scene, k, next);
  set_keys(scene, k, next);
  next.scene = with_resolved_files(std::move(next.scene));
  next.scene.places.reset();
  require_same_obstacles(scene, k, before, next);
  require_same_densities(scene, k, before, next);
  add_parts(scene, k, next);
  next.same_transfer = next.scene.dynamics->transfer == before.scene.dynamics->transfer;
  if (stage.reset_velocity) {
    next.changes.emplace_back("bodies come to rest");
  }
  return next;
}

}  // namespace

std::vector<StageScene> stage_scenes(Scene scene) {
  if (scene.stages.empty()) {
    std::vector<StageScene> all;
    all.push_back(first_of(std::move(scene)));
    return all;
  }
  require_possible(scene);
  check_order(scene);
  std::vector<StageScene> all{first_of(scene)};
  for (std::size_t k = 0; k < scene.stages.size(); ++k) {
    all.push_back(after(all.back(), scene, k));
  }
  return all;
}

std::vector<std::string> body_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Body& body : scene.bodies) {
    names.push_back(body.name);
  }
  for (const Stage& stage : scene.stages) {
    for (const Body& body : stage.add_bodies) {
      names.push_back(body.name);
    }
  }
  return names;
}

}  // namespace lapilli
