#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/heat_at_rest.hpp"

namespace lapilli {

template <int Dim>
std::unique_ptr<Physics> make_heat(Points& points, HeatProblem<Dim> problem) {
  return std::make_unique<HeatAtRest<Dim>>(points, std::move(problem));
}

template std::unique_ptr<Physics> make_heat(Points&, HeatProblem<1>);
template std::unique_ptr<Physics> make_heat(Points&, HeatProblem<2>);
template std::unique_ptr<Physics> make_heat(Points&, HeatProblem<3>);

}  // namespace lapilli
