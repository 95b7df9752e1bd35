#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"

namespace lapilli {

/// Steps of heat on points whose motion takes other steps: one of heat ends with a step of the
/// clock and covers all time since its last, several fit into one of the clock where conduction
/// bears less. It is due when the points have come `reach` cells, when heat's own step would be
/// used up, after `most_steps` of the clock, and where the clock was asked to stop. In between,
/// temperature is what it was and the rate of heat's last step times the time since.
class SubCycle {
 public:
  static constexpr Index most_steps = 16;   // of the clock, in one of heat
  static constexpr Index most_parts = 16;   // steps of heat in one of the clock
  static constexpr double reach = 0.1;      // cells
  static constexpr double own_share = 0.1;  // of heat's automatic step, before its error shows
  static constexpr double exchange_share = 0.01;  // of the time the surface takes to follow

  /// What is asked of the motion.
  struct Motion {
    std::function<double()> speed;  // of the fastest point, m/s
    std::function<double()> step;   // the one it takes by itself, s
  };

  SubCycle(Points& points, double cell, Motion motion);

  /// The longest step of the clock that pays where heat by itself takes `limit`: a whole number of
  /// these, or what the motion takes.
  double longest(double limit) const;

  /// What heat is to do now: `parts` steps of one size over the span of `step`.
  struct Due {
    Step step;
    Index parts;
  };
  /// Count a step of the clock; what is due at its end. `limit`: the step heat takes by itself, s.
  std::optional<Due> due(const Step& clock, double limit);

  /// Around a step of heat: what points carry (K), what the conditions have supplied (J), and the
  /// rate at which nodes of the surface come to the temperature of their surroundings (1/s).
  void before(const PointArray& temperature, std::span<const double> supplied);
  void after(const PointArray& temperature, std::span<const double> supplied, double exchange);

  /// What is ahead of heat stops until its next step: some of the points it was for have left.
  void stand_still();

  /// Time since heat's last step over the time that its changes took.
  double ahead() const { return pending_ / span_; }
  /// What heat changed of points, K, and supplied, J, over that time.
  const PointArray& change() const { return change_; }
  std::span<const double> supply() const { return supply_; }

  /// Steps of the clock in one of heat, the mean so far.
  double mean_steps() const;
  /// The same in words.
  std::string described() const;

  void save(Archive& archive) const;
  void load(const Archive& archive);

 private:
  Motion motion_;
  double reach_;                           // m
  PointArray change_;                      // K
  std::vector<double> supply_;             // J
  double begin_ = 0.0, pending_ = 0.0;     // s: where heat stands, and how far the clock is ahead
  double span_ = 1.0;                      // s, of the change
  double path_ = 0.0;                      // m, of the fastest point since heat's last step
  double exchange_ = 0.0;                  // 1/s
  double clock_size_ = 0.0;                // s, of the last step of the clock
  Index count_ = 0;                        // steps of the clock since then
  Index planned_ = 1;                      // at the most; doubled from the start on
  Index clock_steps_ = 0, own_steps_ = 0;  // in all, the pending ones left out
};

}  // namespace lapilli
