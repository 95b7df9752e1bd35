#include "lapilli/mpm/heat/conditions/ambient_over_step.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {

double ambient_over(const Value& coefficient, const Value& ambient, int power, double zero,
                    double begin, double end) {
  if (ambient.is_constant()) {
    return ambient.at(begin);
  }
  const double share = coefficient.is_function() ? 1.0 : coefficient.mean(begin, end);
  if (!(share > 0.0)) {
    return ambient.mean(begin, end);
  }
  const double mean = mean_of_product({&coefficient, &ambient}, begin, end, [&](double time) {
    const double factor = coefficient.is_function() ? 1.0 : coefficient.at(time);
    return factor * std::pow(ambient.at(time) - zero, power);
  });
  return zero + (power == 1 ? mean / share : std::pow(std::max(mean / share, 0.0), 1.0 / power));
}

}  // namespace lapilli
