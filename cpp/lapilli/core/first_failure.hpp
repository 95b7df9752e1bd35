#pragma once

#include <atomic>
#include <exception>
#include <limits>
#include <mutex>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Carries an exception out of a parallel loop: the one of the earliest task that throws, whatever
/// the number of threads. Once a task has failed, later ones are left out and earlier ones still
/// run, because one of them may fail as well.
class FirstFailure {
 public:
  /// Call body() unless an earlier task has failed; keep what it throws.
  template <class Body>
  void attempt(Index task, const Body& body) noexcept {
    if (task > failed_.load(std::memory_order_relaxed)) {
      return;
    }
    try {
      body();
    } catch (...) {
      keep(task, std::current_exception());
    }
  }

  bool before(Index task) const { return failed_.load(std::memory_order_relaxed) < task; }

  /// Throw what was kept, if anything; called by one thread after the loop.
  void rethrow() const {
    if (exception_) {
      std::rethrow_exception(exception_);
    }
  }

 private:
  void keep(Index task, std::exception_ptr exception) noexcept {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (task < failed_.load(std::memory_order_relaxed)) {
      failed_.store(task, std::memory_order_relaxed);
      exception_ = std::move(exception);
    }
  }

  std::atomic<Index> failed_{std::numeric_limits<Index>::max()};
  std::mutex mutex_;
  std::exception_ptr exception_;
};

}  // namespace lapilli
