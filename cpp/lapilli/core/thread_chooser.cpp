#include "lapilli/core/thread_chooser.hpp"

#include <algorithm>

namespace lapilli {
namespace {

// A trial is long enough to be told from the noise of one step, and rare enough to cost next to
// nothing where it is slow.
constexpr double trial_seconds = 8e-3;
constexpr int trial_steps = 4;
constexpr double trials_apart = 40.0;  // in the length of one
constexpr double worth = 0.95;         // of the time with the present number

}  // namespace

int ThreadChooser::threads(int most) {
  if (most != most_) {
    *this = {};
    most_ = chosen_ = tried_ = most;
  }
  return tried_;
}

void ThreadChooser::took(double seconds) {
  if (most_ < 2) {
    return;
  }
  spent_ += seconds;
  ++steps_;
  if (tried_ == chosen_ && spent_ < patience_) {
    return;
  }
  if (steps_ >= trial_steps && spent_ >= trial_seconds) {
    end_trial();
  }
}

void ThreadChooser::end_trial() {
  const double mean = spent_ / steps_;
  const double length = spent_;
  spent_ = 0.0;
  steps_ = 0;
  if (tried_ == chosen_) {
    best_ = mean;
    const int next = direction_ < 0 ? chosen_ / 2 : std::min(2 * chosen_, most_);
    direction_ = -direction_;
    tried_ = next >= 1 ? next : chosen_;
    return;
  }
  if (mean < worth * best_) {
    direction_ = tried_ < chosen_ ? -1 : 1;  // on in the same direction, at once
    chosen_ = tried_;
    patience_ = 0.0;
    return;
  }
  tried_ = chosen_;
  patience_ = trials_apart * length;
}

}  // namespace lapilli
