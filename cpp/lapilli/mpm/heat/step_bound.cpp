#include "lapilli/mpm/heat/step_bound.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/nodal_assembly.hpp"

namespace lapilli {

template <int Dim>
double fastest_rate(const StencilMatrix<Dim>& conduction, std::span<const double> lumped,
                    std::span<const double> extra) {
  // The first scaling, C^-1/2, is one that nodes with next to no capacity do not spoil; then
  // D <- C^-1 |K| D (Collatz and Wielandt).
  std::vector<double> scaling(lumped.size(), 0.0);
  for (std::size_t place = 0; place < lumped.size(); ++place) {
    scaling[place] = lumped[place] > 0.0 ? 1.0 / std::sqrt(lumped[place]) : 0.0;
  }
  double fastest = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < 24; ++pass) {
    std::vector<double> sum = conduction.absolute_multiply(scaling);
    double bound = 0.0, largest = 0.0;
    for (std::size_t place = 0; place < sum.size(); ++place) {
      if (lumped[place] > 0.0) {
        sum[place] = (sum[place] + extra[place] * scaling[place]) / lumped[place];
        bound = std::max(bound, sum[place] / scaling[place]);
        largest = std::max(largest, sum[place]);
      }
    }
    fastest = std::min(fastest, bound);
    if (!(largest > 0.0)) {
      break;
    }
    for (std::size_t place = 0; place < sum.size(); ++place) {
      if (lumped[place] > 0.0) {
        scaling[place] = std::max(sum[place] / largest, 1e-200);
      }
    }
  }
  return fastest;
}

template <int Dim>
double fastest_node(const StencilMatrix<Dim>& conduction, std::span<const double> lumped,
                    std::span<const double> extra) {
  double fastest = 0.0;
  for (std::size_t place = 0; place < lumped.size(); ++place) {
    if (lumped[place] > 0.0) {
      const double rate = conduction.diagonal(static_cast<Index>(place)) + extra[place];
      fastest = std::max(fastest, rate / lumped[place]);
    }
  }
  return fastest;
}

double carried_limit(HeatTransfer transfer, ShapeFunction shape) {
  if (transfer == HeatTransfer::pic) {
    return 0.7;
  }
  return shape == ShapeFunction::bspline ? 1.5 : 1.0;
}

template <int Dim>
StepLimit explicit_step_limit(const Points& points, const HeatProblem<Dim>& problem,
                              const HeatCoefficients<Dim>& coefficients,
                              std::span<const double> capacity, HeatTransfer transfer) {
  const double h = problem.grid.cell_size();
  const bool affine = transfer == HeatTransfer::affine || transfer == HeatTransfer::tpic;
  StepLimit limit;
  if (coefficients.largest_diffusivity == 0.0) {
    limit.reason = "explicit heat: nothing conducts";
    return limit;
  }
  if (problem.bodies.size() == 1) {
    const double unit = h * h / coefficients.largest_diffusivity;
    if (affine) {
      const double width = coefficients.half_width.front();
      limit.hard = std::min(0.4, 1.6 * width) * unit;
      limit.automatic = 0.6 * limit.hard;
      limit.reason = "explicit heat with carried gradients: 0.4 h^2/alpha";
    } else {
      limit.hard = carried_limit(transfer, problem.shape) * unit;
      limit.automatic = 0.8 * limit.hard;
      limit.reason = message("explicit heat, ", name_of(transfer), ": ",
                             carried_limit(transfer, problem.shape), " h^2/alpha");
    }
    return limit;
  }
  const NodalOperators<Dim> operators = assemble_operators(
      points, problem, coefficients, std::vector<double>(capacity.begin(), capacity.end()), false);
  const std::vector<double> none(operators.lumped.size(), 0.0);
  limit.hard = 2.0 / fastest_rate(*operators.conduction, operators.lumped, none);
  limit.automatic =
      std::min(0.6 * limit.hard, 1.0 / fastest_node(*operators.conduction, operators.lumped, none));
  limit.reason = "explicit heat, several materials: Gershgorin bound of the nodal operator";
  return limit;
}

#define LAPILLI_INSTANTIATE(Dim)                                                                \
  template double fastest_rate(const StencilMatrix<Dim>&, std::span<const double>,              \
                               std::span<const double>);                                        \
  template double fastest_node(const StencilMatrix<Dim>&, std::span<const double>,              \
                               std::span<const double>);                                        \
  template StepLimit explicit_step_limit(const Points&, const HeatProblem<Dim>&,                \
                                         const HeatCoefficients<Dim>&, std::span<const double>, \
                                         HeatTransfer);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
