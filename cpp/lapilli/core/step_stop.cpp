#include "lapilli/core/step_stop.hpp"

#include <utility>

namespace lapilli {
namespace {

thread_local StepStop* current = nullptr;

}  // namespace

StepStop::StepStop(std::function<bool()> unwanted)
    : unwanted_(std::move(unwanted)), outer_(std::exchange(current, this)) {}

StepStop::~StepStop() { current = outer_; }

std::unique_ptr<Interruption> StepStop::stoppable() {
  if (current == nullptr || !current->unwanted_) {
    return nullptr;
  }
  return std::make_unique<Interruption>([unwanted = current->unwanted_] {
    if (unwanted()) {
      throw StepStopped("stopped within the step");
    }
  });
}

}  // namespace lapilli
