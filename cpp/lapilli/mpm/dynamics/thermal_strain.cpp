#include "lapilli/mpm/dynamics/thermal_strain.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {

ThermalStrain::ThermalStrain(Points& points, const PointArray& temperature, PointArray& free_strain,
                             std::vector<double> coefficients)
    : points_(points),
      temperature_(temperature),
      free_strain_(free_strain),
      coefficients_(std::move(coefficients)),
      before_(points, 1) {
  for (double coefficient : coefficients_) {
    require(std::isfinite(coefficient), "thermal expansion must be finite (1/K), got ",
            coefficient);
  }
  for (Index body : points.body()) {
    require(body < static_cast<Index>(coefficients_.size()), "thermal expansion knows ",
            coefficients_.size(), " bodies, points belong to body ", body);
  }
  std::ranges::copy(temperature_.values(), before_.data());
}

void ThermalStrain::follow(const PointArray& change, std::function<double()> ahead) {
  change_ = &change;
  ahead_ = std::move(ahead);
}

StepReport ThermalStrain::advance(const Step& step) {
  const double ahead = change_ != nullptr ? ahead_() : 0.0;
  parallel_for(points_.size(), [&](Index row) {
    const double now = temperature_[row] + (ahead > 0.0 ? ahead * (*change_)[row] : 0.0);
    const double coefficient = coefficients_[points_.body()[row]];
    free_strain_[row] = coefficient * (now - before_[row]);
    before_[row] = now;
  });
  StepReport report;
  report.accepted = step.size;
  return report;
}

void ThermalStrain::save(Archive& archive) const {
  archive.write("thermal_expansion/before", before_.values());
}

void ThermalStrain::load(const Archive& archive) {
  archive.read("thermal_expansion/before", before_.values());
}

}  // namespace lapilli
