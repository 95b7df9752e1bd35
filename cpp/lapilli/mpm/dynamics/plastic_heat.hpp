#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"

namespace lapilli {

/// Plastic work that becomes heat: hands heat what momentum dissipated in the step before. Goes
/// after heat and before momentum in the list of physics, in scenes that ask for it.
class PlasticHeat : public Physics {
 public:
  /// Called with the heat of a step, J, so that the owner of the temperature can book it.
  using Book = std::function<void(double)>;

  /// `work` (J since last taken) is owned by momentum, `temperature` (K) and `capacity` (J/K) by
  /// heat; `shares` by body. Throws std::invalid_argument unless they lie in [0, 1].
  PlasticHeat(Points& points, PointArray& work, PointArray& temperature, const PointArray& capacity,
              std::vector<double> shares, Book book);

  std::string name() const override { return "plastic heating"; }
  StepLimit step_limit() const override { return {}; }
  StepReport advance(const Step& step) override;
  std::vector<Field> fields() override { return {}; }
  void save(Archive&) const override {}
  void load(const Archive&) override {}

 private:
  const Points& points_;
  PointArray& work_;
  PointArray& temperature_;
  const PointArray& capacity_;
  std::vector<double> shares_;
  Book book_;
};

}  // namespace lapilli
