#include "lapilli/peridynamics/wall_settings.hpp"

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

bool is_zero(const Value& value) { return value.is_constant() && value.at(0.0) == 0.0; }

}  // namespace

void check(const FluidWallSettings& wall, int dimension) {
  const std::string name = message("wall '", wall.name, "'");
  const auto useless = [&](const char* what, const char* wanted) {
    return message(" has a ", what, ", which does nothing where heat = \"", name_of(wall.heat),
                   "\": give heat = \"", wanted, "\" or leave it out");
  };
  require(!wall.temperature.is_function() && !wall.flux.is_function(), name,
          ": temperature and flux of a wall are numbers or tables in time");
  const bool convects = wall.heat == WallHeat::convection;
  require(!convects || wall.coefficient > 0.0, name, " has convection with a coefficient of ",
          wall.coefficient, " W/(m^2 K), which must be above 0");
  require(convects || wall.coefficient == 0.0, name, useless("coefficient", "convection"));
  require(wall.heat == WallHeat::flux || is_zero(wall.flux), name, useless("flux", "flux"));
  require(convects || wall.heat == WallHeat::temperature || is_zero(wall.temperature), name,
          useless("temperature", "temperature"));
  require(wall.velocity.empty() || static_cast<int>(wall.velocity.size()) == dimension,
          "velocity of ", name, " has ", wall.velocity.size(), " numbers in a scene of dimension ",
          dimension);
  require(!wall.moves || !wall.velocity.empty(), name,
          " has moves = true, which needs its velocity");
}

}  // namespace lapilli
