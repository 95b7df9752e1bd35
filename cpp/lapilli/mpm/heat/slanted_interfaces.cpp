#include "lapilli/mpm/heat/slanted_interfaces.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/in_brackets.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {

std::vector<Note> slanted_interfaces(std::span<const SurfaceFound> found,
                                     const std::vector<HeatBody>& bodies, double cell_size) {
  // Measured at 45 degrees, ratios of 2 to 1000 and layers of 1 to 10 cells: cells that a layer is
  // too thin by at each interface, for every power of ten.
  constexpr double lost = 0.15;
  constexpr double allowed = 0.02;
  std::size_t worst = 0;
  double share = 0.0;  // of its thickness
  for (std::size_t body = 0; body < found.size(); ++body) {
    const SurfaceFound& own = found[body];
    if (own.slanted > 0.0 && own.volume > 0.0 && std::isfinite(own.better)) {
      const double thinner = lost * std::log10(own.better) * (1.0 - 1.0 / own.better);
      const double now = thinner * own.slanted * cell_size / own.volume;
      worst = now > share ? body : worst;
      share = std::max(share, now);
    }
  }
  if (!(share > allowed)) {
    return {};
  }
  const SurfaceFound& own = found[worst];
  const double conductivity = largest_conductivity(bodies[worst].material);
  const std::string excess =
      share < 0.5 ? message("up to ", std::lround(100.0 * share / (1.0 - share)), " %")
                  : std::string("several times");
  const std::string name = in_brackets(bodies[worst].name);
  const double bond = 1e3 * conductivity * own.slanted / own.volume;
  const double digits = std::pow(10.0, std::floor(std::log10(bond)));
  return {note("heat.slanted-interface", "bodies.", worst, name, " touches a body that conducts ",
               std::lround(own.better), " times better, at an angle to the grid: ", excess,
               " too much heat may cross it; give it more cells across or, exact at any angle, "
               "the pair a [[heat.contacts]] entry of a conductance of ",
               std::ceil(bond / digits) * digits, " W/(m^2 K)")};
}

}  // namespace lapilli
