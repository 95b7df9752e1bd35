#include "lapilli/scene/heat_obstacles.hpp"

namespace lapilli {

std::vector<HeatObstacle> heat_obstacles(const Scene& scene) {
  std::vector<HeatObstacle> all;
  const std::vector<Obstacle>& obstacles = scene.dynamics->obstacles;
  for (std::size_t k = 0; k < obstacles.size(); ++k) {
    const Obstacle& one = obstacles[k];
    if (one.temperature || !scene.heat->boundaries.empty()) {
      all.push_back({name_of(one, k), static_cast<int>(k), one.temperature, one.conductance,
                     one.heat_capacity});
    }
  }
  return all;
}

}  // namespace lapilli
