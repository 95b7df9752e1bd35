#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"

namespace lapilli {

/// Thermal expansion: hands momentum the free strain alpha dT of what temperature changed since the
/// step before. Goes between heat and momentum in the list of physics, in scenes that ask for it.
/// Not modelled: expansion that depends on direction or temperature.
class ThermalStrain : public Physics {
 public:
  /// `temperature` (K) and `free_strain` are arrays of the same points, owned by heat and dynamics;
  /// `coefficients` (1/K) by body. Throws std::invalid_argument unless they are finite.
  ThermalStrain(Points& points, const PointArray& temperature, PointArray& free_strain,
                std::vector<double> coefficients);
  /// Between steps of heat temperature goes on by `ahead()` times its last `change` (K), so that
  /// strain comes with every step and not all at once.
  void follow(const PointArray& change, std::function<double()> ahead);

  std::string name() const override { return "thermal expansion"; }
  StepLimit step_limit() const override { return {}; }
  StepReport advance(const Step& step) override;
  std::vector<Field> fields() override { return {}; }
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;

 private:
  const Points& points_;
  const PointArray& temperature_;
  PointArray& free_strain_;
  std::vector<double> coefficients_;
  PointArray before_;  // K
  const PointArray* change_ = nullptr;
  std::function<double()> ahead_;
};

}  // namespace lapilli
