#include "lapilli/peridynamics/influence.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {

double BondWeight::operator()(double length) const {
  if (length >= horizon) {
    return 0.0;
  }
  const double share =
      volume_correction ? std::min(1.0, (horizon + 0.5 * spacing - length) / spacing) : 1.0;
  const double q = 2.0 * length / horizon;
  switch (influence) {
    case Influence::unity:
      return share;
    case Influence::spline:
      return share * (q < 1.0 ? 1.0 + q * q * (0.75 * q - 1.5) : 0.25 * std::pow(2.0 - q, 3));
    case Influence::gaussian:
      break;
  }
  return share * std::exp(-q * q);
}

double lattice_moment(int dimension, const BondWeight& weight) {
  const int reach = static_cast<int>(std::ceil(weight.horizon / weight.spacing));
  const int reach_y = dimension > 1 ? reach : 0;
  const int reach_z = dimension > 2 ? reach : 0;
  double moment = 0.0;
  for (int k = -reach_z; k <= reach_z; ++k) {
    for (int j = -reach_y; j <= reach_y; ++j) {
      for (int i = -reach; i <= reach; ++i) {
        const double squared = weight.spacing * weight.spacing * (i * i + j * j + k * k);
        moment += weight(std::sqrt(squared)) * squared;
      }
    }
  }
  return moment * std::pow(weight.spacing, dimension) / dimension;
}

}  // namespace lapilli
