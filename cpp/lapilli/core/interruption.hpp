#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace lapilli {

/// While one lives, the loops and long phases that its thread starts ask from time to time whether
/// to go on: `poll` throws to stop them. It is called by that thread alone, every twentieth of a
/// second at most. Only for work whose half-done results are thrown away, such as building.
class Interruption {
 public:
  explicit Interruption(std::function<void()> poll);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// The one this thread may be stopped by; null when there is none.
  static Interruption* of_this_thread();
  /// Does nothing in other threads than the one it was made in.
  void ask();

 private:
  std::function<void()> poll_;
  std::thread::id owner_ = std::this_thread::get_id();
  std::chrono::steady_clock::time_point asked_ = std::chrono::steady_clock::now();
  Interruption* outer_;
};

/// For long phases outside of parallel loops: throws when this thread is asked to stop.
inline void allow_interruption() {
  if (Interruption* interruption = Interruption::of_this_thread()) {
    interruption->ask();
  }
}

}  // namespace lapilli
