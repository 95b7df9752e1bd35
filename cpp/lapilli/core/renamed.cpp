#include "lapilli/core/renamed.hpp"

#include <algorithm>
#include <utility>

namespace lapilli {
namespace {

constexpr std::pair<std::string_view, std::string_view> renamed[] = {
    {"momentum", "dynamics"},
    {"walls", "grid_boundaries"},
    {"walls", "supports"},
    {"monitors", "probes"},
    {"wall_form", "enforcement"},
    {"ghost", "ghost_penalty"},
    {"largest_iterations", "max_iterations"},
    {"largest_halvings", "max_cutbacks"},
    {"largest_penetration", "max_penetration"},
    {"stepping", "time_integration"},
    {"theta", "implicit"},
    {"kept", "nodal"},
    {"Temperature", "PrescribedTemperature"},
    {"ImplicitWall", "Support"},
    {"Momentum", "Dynamics"},
    {"implicit_exchange", "implicit_robin"},
    {"pic_share", "pic_fraction"},
    {"step_safety", "courant"},
    {"friction", "friction_angle"},
    {"dilation", "dilatancy_angle"},
    {"lateral", "k0"},
    {"expansion", "thermal_expansion"},
    {"dissipation", "viscous_dissipation"},
    {"clip", "fill"},
    {"ledger", "balance"},
};

}  // namespace

std::string new_name(std::string_view old, const std::vector<std::string>& candidates) {
  for (const auto& [before, now] : renamed) {
    if (before == old && std::find(candidates.begin(), candidates.end(), now) != candidates.end()) {
      return std::string(now);
    }
  }
  return {};
}

}  // namespace lapilli
