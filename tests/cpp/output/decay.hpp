#pragma once

#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/require.hpp"
#include "lapilli/core/simulation.hpp"

namespace lapilli::testing {

/// T' = -T explicitly, on points that drift and change their order; the automatic step follows the
/// state, so that a run gone on with from a state a bit off would soon step differently.
class Decay : public Physics {
 public:
  explicit Decay(Points& points, Index failing_step = -1)
      : points_(points), temperature_(points, 1), failing_step_(failing_step) {
    for (Index k = 0; k < points.size(); ++k) {
      temperature_[k] = 1.0 + 0.1 * static_cast<double>(k);
    }
    initial_ = heat();
  }

  std::string name() const override { return "decay"; }
  StepLimit step_limit() const override {
    return {0.5, 0.03 * (1.0 + temperature_[0] / 3.0), "explicit decay"};
  }
  StepReport advance(const Step& step) override {
    for (Index k = 0; k < points_.size(); ++k) {
      lost_ += step.size * temperature_[k];
      temperature_[k] -= step.size * temperature_[k];
      points_.position()[2 * k] += step.size * temperature_[k];
    }
    if (step.index == failing_step_) {
      throw RunError("point 3: temperature is not finite");
    }
    points_.moved();
    std::vector<Index> order(points_.size());
    std::iota(order.rbegin(), order.rend(), Index{0});
    points_.permute(order);
    return {step.size, 2, 1e-3};
  }
  std::vector<Field> fields() override { return {{"temperature", "K", 1, temperature_.values()}}; }
  std::vector<Balance> balances() const override {
    return {{"heat", "J", initial_, heat(), {{"decay", -lost_}}, 1.0}};
  }
  std::vector<std::pair<std::string, double>> diagnostics() const override {
    return {{"hottest", temperature_[0]}};
  }
  void save(Archive& archive) const override {
    archive.write("decay/temperature", temperature_.values());
    archive.write("decay/lost", lost_);
  }
  void load(const Archive& archive) override {
    archive.read("decay/temperature", temperature_.values());
    lost_ = archive.read_number("decay/lost");
  }

 private:
  double heat() const {
    return std::accumulate(temperature_.values().begin(), temperature_.values().end(), 0.0);
  }

  Points& points_;
  PointArray temperature_;
  Index failing_step_;
  double initial_ = 0.0, lost_ = 0.0;
};

inline Simulation made_simulation(double end, Index failing_step = -1) {
  auto points = std::make_unique<Points>(2);
  points->append(std::vector<double>{0, 0, 1, 0, 0, 1, 1, 1, 2, 2}, std::vector<double>(5, 0.5), 0);
  std::vector<std::unique_ptr<Physics>> physics;
  physics.push_back(std::make_unique<Decay>(*points, failing_step));
  return Simulation(std::move(points), std::move(physics), {.end = end});
}

}  // namespace lapilli::testing
