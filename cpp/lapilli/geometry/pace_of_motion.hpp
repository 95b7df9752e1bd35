#pragma once

#include "lapilli/core/physics.hpp"
#include "lapilli/core/warnings.hpp"

namespace lapilli {

/// Keeps automatic steps short enough for prescribed motion where the result depends on where
/// bodies are in space (step_of_motion.hpp), and says so of a given step that is not. Moves
/// nothing.
class PaceOfMotion final : public Physics, public Warnings {
 public:
  /// `longest`: s.
  explicit PaceOfMotion(double longest) : longest_(longest) {}

  std::string name() const override { return "pace of motion"; }
  StepLimit step_limit() const override;
  StepReport advance(const Step& step) override;
  std::vector<Field> fields() override { return {}; }
  std::vector<Note> warnings() const override;
  void save(Archive&) const override {}
  void load(const Archive&) override {}

 private:
  double longest_, taken_ = 0.0;  // s; the longest step so far
};

}  // namespace lapilli
