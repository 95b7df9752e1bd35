#include "lapilli/core/parallel.hpp"

#include <atomic>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

std::atomic<int> chosen_threads{0};

int processors() {
#ifdef _OPENMP
  return std::max(1, omp_get_num_procs());
#else
  return 1;
#endif
}

}  // namespace

int thread_count() {
  const int chosen = chosen_threads.load(std::memory_order_relaxed);
  return chosen > 0 ? chosen : processors();
}

void set_thread_count(int threads) {
  require(threads >= 0 && threads <= 4096, "threads must be 0 (all processors) to 4096, got ",
          threads);
  chosen_threads.store(threads, std::memory_order_relaxed);
}

}  // namespace lapilli
