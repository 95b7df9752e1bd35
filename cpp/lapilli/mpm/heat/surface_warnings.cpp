#include "lapilli/mpm/heat/surface_warnings.hpp"

#include <algorithm>
#include <iterator>

#include "lapilli/mpm/heat/coarse_sources.hpp"
#include "lapilli/mpm/heat/drawn_gaps.hpp"
#include "lapilli/mpm/heat/meeting_conditions.hpp"
#include "lapilli/mpm/heat/slanted_interfaces.hpp"
#include "lapilli/mpm/heat/strong_ends.hpp"

namespace lapilli {

template <int Dim>
std::vector<Note> surface_warnings(std::span<const SurfaceFound> found,
                                   const HeatProblem<Dim>& problem, const ConditionAccount& account,
                                   double span, double time) {
  const double cell = problem.grid.cell_size();
  std::vector<Note> all;
  for (const std::vector<Note>& some :
       {slanted_interfaces(found, problem.bodies, cell),
        drawn_gaps(found, problem.bodies, cell, Dim), narrow_holds(found, problem.settings),
        regions_below(found, problem.settings, cell),
        coarse_sources<Dim>(found, problem, span, time),
        fluxes_beside(found, problem.settings, account),
        crossing_heat(found, problem.bodies, problem.settings, account, cell, time)}) {
    std::ranges::copy(some, std::back_inserter(all));
  }
  return all;
}

#define LAPILLI_INSTANTIATE(Dim)                                                                \
  template std::vector<Note> surface_warnings(std::span<const SurfaceFound>,                    \
                                              const HeatProblem<Dim>&, const ConditionAccount&, \
                                              double, double);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
