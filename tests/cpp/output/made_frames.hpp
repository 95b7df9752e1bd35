#pragma once

#include <numeric>
#include <vector>

#include "lapilli/core/field.hpp"
#include "lapilli/core/points.hpp"

namespace lapilli::testing {

/// Points and fields whose numbers follow from id and frame alone, so that a reader in any language
/// can say what must be there: position (id, frame), temperature id + 1000 frame, velocity
/// (id, -frame), stress (id, frame, -id, -frame). The order of the points changes in every frame.
struct MadeFrames {
  explicit MadeFrames(Index count, bool moving = true) : points(2), moves(moving) {
    std::vector<double> positions(2 * count), volumes(count, 0.25);
    for (Index k = 0; k < count; ++k) {
      positions[2 * k] = static_cast<double>(k);
    }
    points.append(positions, volumes, 3);
  }

  void go_to(Index frame) {
    std::vector<Index> order(points.size());
    std::iota(order.rbegin(), order.rend(), Index{0});
    points.permute(order);
    temperature.clear(), velocity.clear(), stress.clear();
    for (Index row = 0; row < points.size(); ++row) {
      const auto id = static_cast<double>(points.id()[row]), step = static_cast<double>(frame);
      points.position()[2 * row + 1] = moves ? step : 0.0;
      temperature.push_back(id + 1000.0 * step);
      velocity.insert(velocity.end(), {id, -step});
      stress.insert(stress.end(), {id, step, -id, -step});
    }
  }

  std::vector<Field> fields() {
    return {{"temperature", "K", 1, temperature},
            {"velocity", "m/s", 2, velocity},
            {"stress", "Pa", 4, stress}};
  }

  Points points;
  bool moves;
  std::vector<double> temperature, velocity, stress;
};

}  // namespace lapilli::testing
