#include "lapilli/scene/stage_changes.hpp"

#include <algorithm>

#include "lapilli/scene/place_errors.hpp"

namespace lapilli {
namespace {

std::string path_of(std::size_t k, const char* key) {
  return message(element_path("stages", k), ".", key);
}

const std::string& name_of(const Body& body) { return body.name; }
const std::string& name_of(const Obstacle& obstacle) { return obstacle.name; }
const std::string& name_of(const DynamicsBoundary& load) {
  return std::visit([](const auto& known) -> const std::string& { return known.name; }, load);
}

template <class T>
Index count_called(const std::vector<T>& list, const std::string& name) {
  return std::ranges::count_if(list, [&](const T& one) { return name_of(one) == name; });
}

template <class T>
void add_names(const std::vector<T>& list, std::vector<std::string>& names) {
  for (const T& one : list) {
    if (!name_of(one).empty()) {
      names.push_back(name_of(one));
    }
  }
}

/// Take out what is called so, and the same entries of lists beside it.
template <class T, class... Beside>
void take_out(std::vector<T>& list, const std::string& name, Beside&... beside) {
  for (std::size_t k = list.size(); k-- > 0;) {
    if (name_of(list[k]) == name) {
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(k));
      (beside.erase(beside.begin() + static_cast<std::ptrdiff_t>(k)), ...);
    }
  }
}

template <class Contact>
void drop_contacts_of(const std::string& body, std::vector<Contact>& contacts) {
  std::erase_if(contacts, [&](const Contact& contact) {
    return std::ranges::find(contact.bodies, body) != contact.bodies.end();
  });
}

void remove_one(const std::string& name, StageScene& stage) {
  DynamicsSettings& dynamics = *stage.scene.dynamics;
  take_out(stage.scene.bodies, name, stage.body_before, stage.body_number);
  take_out(dynamics.obstacles, name, stage.obstacle_before);
  take_out(dynamics.boundaries, name, stage.load_before);
  drop_contacts_of(name, dynamics.contacts);
  if (stage.scene.heat) {
    drop_contacts_of(name, stage.scene.heat->contacts);
  }
}

/// A name stands for one thing of a run: results call it by that.
void require_new(const Scene& scene, const std::string& name, const std::string& path) {
  const std::vector<std::string> known = body_names(scene);
  require_at(name.empty() || std::ranges::count(known, name) == 1, scene, path + ".name", "is '",
             name, "', which another body of this run is called");
}

}  // namespace

void remove_parts(const Scene& scene, std::size_t k, StageScene& stage) {
  const std::string path = path_of(k, "remove");
  for (const std::string& name : scene.stages[k].remove) {
    const DynamicsSettings& dynamics = *stage.scene.dynamics;
    std::vector<std::string> names;
    add_names(stage.scene.bodies, names);
    add_names(dynamics.obstacles, names);
    add_names(dynamics.boundaries, names);
    const Index found = count_called(stage.scene.bodies, name) +
                        count_called(dynamics.obstacles, name) +
                        count_called(dynamics.boundaries, name);
    require_at(found > 0 && !name.empty(), scene, path, "names '", name,
               "', which is no body, obstacle or load of the stage before",
               names.empty() ? "; none has a name" : suggestion(name, names));
    require_at(found == 1, scene, path, "names '", name, "', which ", found,
               " bodies, obstacles or loads are called");
    remove_one(name, stage);
    stage.changes.push_back(message("without ", name));
  }
  require_at(!stage.scene.bodies.empty(), scene, path, "leaves no body");
}

void add_parts(const Scene& scene, std::size_t k, StageScene& stage) {
  const Stage& added = scene.stages[k];
  DynamicsSettings& dynamics = *stage.scene.dynamics;
  Index number = static_cast<Index>(scene.bodies.size());
  for (std::size_t before = 0; before < k; ++before) {
    number += static_cast<Index>(scene.stages[before].add_bodies.size());
  }
  for (std::size_t b = 0; b < added.add_bodies.size(); ++b) {
    require_new(scene, added.add_bodies[b].name, element_path(path_of(k, "add_bodies"), b));
    stage.scene.bodies.push_back(added.add_bodies[b]);
    stage.body_before.push_back(-1);
    stage.body_number.push_back(number++);
    stage.changes.push_back(message("with body ", added.add_bodies[b].name));
  }
  for (const Obstacle& obstacle : added.add_obstacles) {
    dynamics.obstacles.push_back(obstacle);
    stage.obstacle_before.push_back(-1);
    stage.changes.push_back(message("with obstacle ", obstacle.name));
  }
  for (const DynamicsBoundary& load : added.add_boundaries) {
    dynamics.boundaries.push_back(load);
    stage.load_before.push_back(-1);
    stage.changes.push_back(
        message("with load ", std::visit([](const auto& one) { return one.kind; }, load)));
  }
}

}  // namespace lapilli
