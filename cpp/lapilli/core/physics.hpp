#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/balance.hpp"
#include "lapilli/core/field.hpp"
#include "lapilli/core/vector.hpp"

namespace lapilli {

/// One step of the clock: from `time` over `size`.
struct Step {
  double time = 0.0;       // s, at the start of the step
  double size = 0.0;       // s
  Index index = 0;         // counts from 0
  bool output_due = true;  // whether somebody may look at the fields after this step
  bool last = false;       // whether the clock stops after it: at a frame, at the end
};

/// How large a step may be. Both are infinite for implicit solvers.
struct StepLimit {
  double hard = std::numeric_limits<double>::infinity();       // s; larger ones are refused
  double automatic = std::numeric_limits<double>::infinity();  // s; what step = "auto" takes
  std::string reason;                                          // "explicit heat, 0.8 h^2/alpha"
  double stop = std::numeric_limits<double>::infinity();       // s; no step goes beyond this time
  bool even = false;  // up to the next stop or frame, steps of one size suit best
};

/// What one physics did in one step.
struct StepReport {
  double accepted = 0.0;  // s; smaller than asked when a load step was halved
  int iterations = 0;     // of an implicit solve
  double residual = 0.0;  // of an implicit solve, relative
};

/// One physical process. Owns every field it evolves; absent physics is absent from the list.
class Physics {
 public:
  virtual ~Physics() = default;

  virtual std::string name() const = 0;  // "heat", "dynamics"
  virtual StepLimit step_limit() const = 0;
  /// Evolve its fields over one step. Throws RunError when the run cannot go on.
  virtual StepReport advance(const Step& step) = 0;
  /// Bring the point values of `fields()` up to date; called before anybody looks.
  virtual void refresh_output() {}
  virtual std::vector<Field> fields() = 0;
  virtual std::vector<Balance> balances() const { return {}; }
  /// Book what the points in these rows carry: they leave the simulation now, after the step.
  virtual void release(std::span<const Index>) {}
  /// Everything a bitwise resume needs, whether output shows it or not.
  virtual void save(Archive& archive) const = 0;
  virtual void load(const Archive& archive) = 0;
  /// Named numbers worth recording: negative area share, smallest pivot, density variation.
  virtual std::vector<std::pair<std::string, double>> diagnostics() const { return {}; }
};

}  // namespace lapilli
