#include "lapilli/core/interruption.hpp"

#include <utility>

namespace lapilli {
namespace {

thread_local Interruption* current = nullptr;
constexpr std::chrono::milliseconds pause{50};

}  // namespace

Interruption::Interruption(std::function<void()> poll)
    : poll_(std::move(poll)), outer_(std::exchange(current, this)) {}

Interruption::~Interruption() { current = outer_; }

Interruption* Interruption::of_this_thread() { return current; }

void Interruption::ask() {
  if (std::this_thread::get_id() != owner_) {
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (now - asked_ >= pause) {
    asked_ = now;
    poll_();
  }
}

}  // namespace lapilli
