#include "lapilli/core/parallel.hpp"

#include <pthread.h>

#include <atomic>

#include "lapilli/core/interruption.hpp"
#include "lapilli/core/require.hpp"

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

int processors() {
#ifdef _OPENMP
  return std::max(1, omp_get_num_procs());
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
  const int threads = chosen > 0 ? chosen : processors();
  if (threads > 1) {
    had_threads.store(true, std::memory_order_relaxed);
  }
  return threads;
}

void set_thread_count(int threads) {
  require(threads >= 0 && threads <= 4096, "threads must be 0 (all processors) to 4096, got ",
          threads);
  chosen_threads.store(threads, std::memory_order_relaxed);
}

}  // namespace lapilli
