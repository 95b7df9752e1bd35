#pragma once

#include <optional>
#include <string>

#include "lapilli/core/value.hpp"

namespace lapilli {

/// What heat conduction needs to know of an obstacle to the motion. Without a temperature no heat
/// passes where material touches it.
struct HeatObstacle {
  std::string name;
  int number = 0;                       // among all obstacles of the scene
  std::optional<Value> temperature;     // K; at the start, of one that heat warms
  std::optional<Value> conductance;     // W/(m^2 K), of the contact; absent: perfect
  std::optional<double> heat_capacity;  // J/K; absent: its temperature is given
};

}  // namespace lapilli
