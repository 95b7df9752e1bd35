#include "lapilli/core/diagnostics.hpp"

namespace lapilli {

std::vector<std::pair<std::string, double>> diagnostics_of(Simulation& simulation) {
  std::vector<std::pair<std::string, double>> all;
  for (const auto& physics : simulation.physics()) {
    physics->refresh_output();
    for (const auto& [name, value] : physics->diagnostics()) {
      all.emplace_back(physics->name() + "/" + name, value);
    }
  }
  return all;
}

}  // namespace lapilli
