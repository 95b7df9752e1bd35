#pragma once

#include <cstddef>

namespace lapilli {

/// Exchange with the surroundings on the diagonal of the nodes of one condition, added to their
/// increments (K); returns the heat (J). With `implicit` it is that of the end of the step,
///     (C + dt slope) dT = dt (others + rate),
/// of which `increment` holds dt others / C, and in a form that keeps the heat exact where a stiff
/// condition leaves a small difference of large rates. meet(k, slope, capacity) sees every node.
template <class Nodes, class Meet>
double exchange_on_diagonal(const Nodes& n, double step, bool implicit, const double* capacity,
                            double* increment, const Meet& meet) {
  double heat = 0.0;
  for (std::size_t k = 0; k < n.node.size(); ++k) {
    const double own = capacity[n.node[k]];
    if (!(own > 0.0)) {
      continue;
    }
    const double slope = implicit ? n.slope[k] : 0.0;
    double& before = increment[n.node[k]];
    const double rise = step * (n.rate[k] - slope * before) / (own + step * slope);
    meet(k, slope, own);
    before += rise;
    heat += own * rise;
  }
  return heat;
}

}  // namespace lapilli
