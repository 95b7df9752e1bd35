#include "lapilli/core/parallel.hpp"

#include <pthread.h>

#include <algorithm>
#include <atomic>

#include "lapilli/core/interruption.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/thread_limit.hpp"

namespace lapilli {
namespace {

std::atomic<int> chosen_threads{0};
std::atomic<bool> had_threads{false};  // whether a loop may have had more than one
std::atomic<bool> has_lost_threads{false};

// A forked process has one thread. The OpenMP library would wait for ever for the others that its
// parent had.
[[maybe_unused]] const int at_fork = pthread_atfork(nullptr, nullptr, [] {
  has_lost_threads.store(had_threads.load(std::memory_order_relaxed), std::memory_order_relaxed);
});

// 0: none.
thread_local int limit = 0;

// OMP_NUM_THREADS where the environment has it. Asked once, outside of any loop: inside of one the
// answer would be another.
int processors() {
#ifdef _OPENMP
  static const int all = std::max(1, omp_get_max_threads());
  return all;
#else
  return 1;
#endif
}

}  // namespace

// Every loop begins by asking this, which makes it the place where a long build can be stopped.
int thread_count() {
  allow_interruption();
  if (has_lost_threads.load(std::memory_order_relaxed)) {
    return 1;
  }
  const int chosen = chosen_threads.load(std::memory_order_relaxed);
  const int most = chosen > 0 ? chosen : processors();
  const int threads = limit > 0 ? std::min(limit, most) : most;
  if (threads > 1) {
    had_threads.store(true, std::memory_order_relaxed);
  }
  return threads;
}

int chosen_thread_count() { return chosen_threads.load(std::memory_order_relaxed); }

ThreadLimit::ThreadLimit(int threads) : before_(limit) { limit = threads; }

ThreadLimit::~ThreadLimit() { limit = before_; }

void set_thread_count(int threads) {
  require(threads >= 0 && threads <= 4096, "threads must be 0 (all processors) to 4096, got ",
          threads);
  chosen_threads.store(threads, std::memory_order_relaxed);
}

}  // namespace lapilli
