#include "lapilli/mpm/heat/step_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/nodal_assembly.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"

namespace lapilli {

template <int Dim>
double fastest_rate(const StencilMatrix<Dim>& conduction, std::span<const double> lumped,
                    std::span<const NodeCoupling> couplings) {
  // The first scaling, C^-1/2, is one that nodes with next to no capacity do not spoil; then
  // D <- C^-1 |K| D (Collatz and Wielandt).
  std::vector<double> scaling(lumped.size(), 0.0);
  for (std::size_t place = 0; place < lumped.size(); ++place) {
    scaling[place] = lumped[place] > 0.0 ? 1.0 / std::sqrt(lumped[place]) : 0.0;
  }
  double fastest = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < 24; ++pass) {
    std::vector<double> sum = conduction.absolute_multiply(scaling);
    for (const NodeCoupling& coupling : couplings) {
      sum[coupling.node] += std::abs(coupling.rate) * scaling[coupling.source];
    }
    double bound = 0.0, largest = 0.0;
    for (std::size_t place = 0; place < sum.size(); ++place) {
      if (lumped[place] > 0.0) {
        sum[place] /= lumped[place];
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
double fastest_node(const StencilMatrix<Dim>& conduction, std::span<const double> lumped) {
  double fastest = 0.0;
  for (std::size_t place = 0; place < lumped.size(); ++place) {
    if (lumped[place] > 0.0) {
      const double rate = conduction.diagonal(static_cast<Index>(place));
      fastest = std::max(fastest, rate / lumped[place]);
    }
  }
  return fastest;
}

template <int Dim>
double fastest_carried_rate(const StencilMatrix<Dim>& conduction,
                            const StencilMatrix<Dim>& capacity, std::span<const double> lumped) {
  constexpr int powers = 60;
  constexpr double safety = 1.05;
  // Any start with something of all modes; signs that alternate have most of the fastest.
  std::vector<double> x(lumped.size(), 0.0), y(lumped.size(), 0.0);
  for (std::size_t place = 0; place < x.size(); ++place) {
    const auto mixed = static_cast<double>((place * 2654435761u) % 1000003u) / 1000003.0;
    x[place] = lumped[place] > 0.0 ? mixed - 0.5 : 0.0;
  }
  const auto apply = [&](const StencilMatrix<Dim>& matrix, const std::vector<double>& from,
                         std::vector<double>& to) {
    matrix.multiply(from.data(), [&](Index place, int count, const auto& product) {
      for (int k = 0; k < count; ++k) {
        const auto at = static_cast<std::size_t>(place + k);
        if (at < to.size()) {
          to[at] = lumped[at] > 0.0 ? product[k] / lumped[at] : 0.0;
        }
      }
    });
  };
  double rate = 0.0;
  for (int power = 0; power < powers; ++power) {
    apply(conduction, x, y);
    apply(capacity, y, x);
    // The square norm that makes the product symmetric is that of K; the largest entry does.
    double size = 0.0;
    for (const double value : x) {
      size = std::max(size, std::abs(value));
    }
    if (!(size > 0.0)) {
      return 0.0;
    }
    for (double& value : x) {
      value /= size;
    }
    rate = size;
  }
  return safety * rate;
}

double carried_limit(HeatTransfer transfer, ShapeFunction shape) {
  if (transfer == HeatTransfer::pic) {
    return 0.7;
  }
  return shape == ShapeFunction::bspline ? 1.5 : 1.0;
}

template <int Dim>
bool exchanges_strongly(const HeatProblem<Dim>& problem) {
  double conductivity = std::numeric_limits<double>::infinity();
  const double zero = absolute_zero(problem.settings);
  double hottest = 0.0;  // K
  for (const HeatBody& body : problem.bodies) {
    conductivity = std::min(conductivity, largest_conductivity(body.material));
    hottest = std::max(hottest, body.temperature.largest() - zero);
  }
  const auto& laws = problem.settings.boundaries;
  return std::any_of(laws.begin(), laws.end(), [&](const HeatBoundary& law) {
    return exchanges(law) &&
           largest_coefficient(law, hottest, zero) * problem.grid.cell_size() > conductivity;
  });
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
      const bool strong = transfer == HeatTransfer::flip && problem.settings.implicit_robin &&
                          exchanges_strongly(problem);
      // Beyond 3/8 h^2/alpha (in the plane) a node next to one held at ambient would pass it.
      limit.automatic = strong ? 0.3 * unit : 0.8 * limit.hard;
      limit.reason = message("explicit heat, ", name_of(transfer), ": ",
                             carried_limit(transfer, problem.shape), " h^2/alpha");
    }
    return limit;
  }
  const NodalOperators<Dim> operators = assemble_operators(
      points, problem, coefficients, std::vector<double>(capacity.begin(), capacity.end()), false);
  limit.hard = 2.0 / fastest_rate(*operators.conduction, operators.lumped);
  limit.automatic =
      std::min(0.6 * limit.hard, 1.0 / fastest_node(*operators.conduction, operators.lumped));
  limit.reason = "explicit heat, several materials: Gershgorin bound of the nodal operator";
  return limit;
}

#define LAPILLI_INSTANTIATE(Dim)                                                                \
  template double fastest_rate(const StencilMatrix<Dim>&, std::span<const double>,              \
                               std::span<const NodeCoupling>);                                  \
  template double fastest_carried_rate(const StencilMatrix<Dim>&, const StencilMatrix<Dim>&,    \
                                       std::span<const double>);                                \
  template double fastest_node(const StencilMatrix<Dim>&, std::span<const double>);             \
  template bool exchanges_strongly(const HeatProblem<Dim>&);                                    \
  template StepLimit explicit_step_limit(const Points&, const HeatProblem<Dim>&,                \
                                         const HeatCoefficients<Dim>&, std::span<const double>, \
                                         HeatTransfer);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
