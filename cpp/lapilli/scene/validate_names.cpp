#include "lapilli/scene/validate_names.hpp"

#include <algorithm>
#include <map>

#include "lapilli/core/snake_case.hpp"
#include "lapilli/scene/place_errors.hpp"

namespace lapilli {
namespace {

/// The names of one group of columns, by what columns make of them.
class ColumnNames {
 public:
  ColumnNames(const Scene& scene, Mistakes& mistakes) : scene_(scene), mistakes_(mistakes) {}

  void reserve(std::initializer_list<const char*> entries) {
    for (const char* entry : entries) {
      places_.emplace(snake_case(entry), "an entry of the balance itself");
    }
  }

  /// `own` is empty where the element is called by `unnamed`.
  void take(const std::string& path, const std::string& own, const std::string& unnamed) {
    const std::string& name = own.empty() ? unnamed : own;
    const std::string place = own.empty() ? path : path + ".name";
    const auto entered = places_.emplace(snake_case(name), place);
    if (entered.second) {
      return;
    }
    mistakes_.gather([&] {
      require_at(false, scene_, place, own.empty() ? "is called '" : "is '", name,
                 "' as is that of ", entered.first->second,
                 ": columns of the history are told by their names");
    });
  }

 private:
  const Scene& scene_;
  Mistakes& mistakes_;
  std::map<std::string, std::string> places_;
};

/// Boundary conditions of heat or of dynamics, which are called by kind and number.
template <class Conditions>
void take_conditions(const Conditions& conditions, const std::string& list, ColumnNames& names) {
  for (std::size_t k = 0; k < conditions.size(); ++k) {
    std::visit(
        [&](const auto& one) {
          names.take(element_path(list, k), one.name, message(one.kind, " ", k + 1));
        },
        conditions[k]);
  }
}

void check_heat(const Scene& scene, Mistakes& mistakes) {
  ColumnNames names(scene, mistakes);
  const bool has_sources = std::ranges::any_of(scene.bodies, [](const Body& body) {
    return !body.source.is_constant() || body.source.at(0.0) != 0.0;
  });
  if (has_sources) {
    names.reserve({"source"});
  }
  if (scene.dynamics) {
    names.reserve({"plastic work", "removed points"});
  }
  take_conditions(scene.heat->boundaries, "heat.boundaries", names);
  for (std::size_t k = 0; scene.dynamics && k < scene.dynamics->obstacles.size(); ++k) {
    const Obstacle& obstacle = scene.dynamics->obstacles[k];
    if (obstacle.temperature) {
      names.take(element_path("dynamics.obstacles", k), obstacle.name, message("obstacle ", k));
    }
  }
  if (!scene.heat->contacts.empty()) {
    ColumnNames bodies(scene, mistakes);  // "heat from a to b"
    for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
      bodies.take(element_path("bodies", k), scene.bodies[k].name, message("body ", k));
    }
  }
}

void check_dynamics(const Scene& scene, Mistakes& mistakes) {
  ColumnNames names(scene, mistakes);
  names.reserve({"plastic", "wall friction", "wall impact", "transfer", "strain transfer",
                 "removed points", "damping", "changes of gravity", "expansion", "gravity", "walls",
                 "contact friction", "contact impact"});
  take_conditions(scene.dynamics->boundaries, "dynamics.boundaries", names);
  const auto& obstacles = scene.dynamics->obstacles;
  for (std::size_t k = 0; k < obstacles.size(); ++k) {
    names.take(element_path("dynamics.obstacles", k), obstacles[k].name, message("obstacle ", k));
  }
}

void check_supports(const Scene& scene, Mistakes& mistakes) {
  ColumnNames names(scene, mistakes);
  const auto& supports = scene.quasi_static->supports;
  for (std::size_t k = 0; k < supports.size(); ++k) {
    names.take(element_path("quasi_static.supports", k), supports[k].name, message(k + 1));
  }
}

}  // namespace

void validate_names(const Scene& scene, Mistakes& mistakes) {
  if (scene.heat) {
    check_heat(scene, mistakes);
  }
  if (scene.dynamics) {
    check_dynamics(scene, mistakes);
  }
  if (scene.quasi_static) {
    check_supports(scene, mistakes);
  }
}

}  // namespace lapilli
