#pragma once

#include <algorithm>
#include <vector>

#include "lapilli/core/first_failure.hpp"
#include "lapilli/core/vector.hpp"

#ifdef _OPENMP
#include <omp.h>
#endif

namespace lapilli {

/// Threads that the loops below may use (default: all processors). Does not touch other libraries.
int thread_count();

/// Which of the threads of a loop runs this, 0 .. thread_count()-1; 0 outside loops.
inline int thread_index() {
#ifdef _OPENMP
  return omp_get_thread_num();
#else
  return 0;
#endif
}

/// Set the number of threads of every following loop; 0 means all processors.
void set_thread_count(int threads);

// The loops below give the same bytes for any number of threads as long as iterations are
// independent: work is cut in pieces whose size does not depend on the threads, and partial sums
// are added in order. What a body throws leaves the loop: the exception of the earliest task.

/// Rows worked on as one piece by `parallel_ranges` and `parallel_sum`.
inline constexpr Index piece_rows = 2048;

/// Call body(task) for task = 0 .. tasks-1, each once, handed out dynamically.
template <class Body>
void parallel_tasks(Index tasks, const Body& body) {
  FirstFailure failure;
#ifdef _OPENMP
  const int threads = static_cast<int>(std::min<Index>(thread_count(), tasks));
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads) if (threads > 1)
#endif
  for (Index task = 0; task < tasks; ++task) {
    failure.attempt(task, [&] { body(task); });
  }
  failure.rethrow();
}

/// Call body(task) for task = 0 .. tasks-1, each thread a run of neighbouring tasks: for tasks that
/// cost about the same, so that a thread meets the same rows in every loop.
template <class Body>
void parallel_runs(Index tasks, const Body& body) {
  FirstFailure failure;
#ifdef _OPENMP
  const int threads = static_cast<int>(std::min<Index>(thread_count(), tasks));
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
#endif
  for (Index task = 0; task < tasks; ++task) {
    failure.attempt(task, [&] { body(task); });
  }
  failure.rethrow();
}

/// The tasks whose results a task needs.
struct TaskRange {
  Index first = 0, last = 0;  // both included
};

/// Call lead(task) for every task, and follow(task) as soon as lead has been called for all tasks
/// that `needs[task]` names: what `lead` leaves is met while it is still in the cache. Threads
/// share the tasks as in `parallel_runs`.
template <class Lead, class Follow>
void parallel_wave(const std::vector<TaskRange>& needs, const Lead& lead, const Follow& follow) {
  const auto tasks = static_cast<Index>(needs.size());
  std::vector<char> followed(needs.size(), 0);
  FirstFailure failure;  // a lead comes before every follower
  const auto run = [&](Index begin, Index end) {
    for (Index task = begin, next = begin; task < end; ++task) {
      failure.attempt(task, [&] { lead(task); });
      if (failure.before(tasks)) {
        continue;
      }
      for (; next <= task && needs[next].last <= task; ++next) {
        if (needs[next].first >= begin) {
          failure.attempt(tasks + next, [&] { follow(next); });
          followed[next] = 1;
        }
      }
    }
  };
  const auto follow_late = [&](Index task) {
    if (!followed[task]) {
      failure.attempt(tasks + task, [&] { follow(task); });
    }
  };
#ifdef _OPENMP
  const int threads = static_cast<int>(std::min<Index>(thread_count(), tasks));
#pragma omp parallel num_threads(threads) if (threads > 1)
  {
    const Index runs = omp_get_num_threads(), own = omp_get_thread_num();
    const auto begin = [&](Index k) { return k * (tasks / runs) + std::min(k, tasks % runs); };
    run(begin(own), begin(own + 1));
#pragma omp barrier
#pragma omp for schedule(dynamic, 1)
    for (Index task = 0; task < tasks; ++task) {
      follow_late(task);
    }
  }
#else
  run(0, tasks);
  for (Index task = 0; task < tasks; ++task) {
    follow_late(task);
  }
#endif
  failure.rethrow();
}

/// What a loop does a row: loops of a few operations a row are worth a second thread only from many
/// rows on.
enum class Work { heavy, light };

/// Call body(begin, end) over pieces of [0, rows).
template <class Body>
void parallel_ranges(Index rows, const Body& body, Work work = Work::heavy) {
  const Index pieces = (rows + piece_rows - 1) / piece_rows;
  FirstFailure failure;
#ifdef _OPENMP
  constexpr Index light_pieces = 64;
  const bool pays = work == Work::heavy || pieces >= light_pieces;
  const int threads = pays ? static_cast<int>(std::min<Index>(thread_count(), pieces)) : 1;
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
#endif
  for (Index piece = 0; piece < pieces; ++piece) {
    failure.attempt(piece,
                    [&] { body(piece * piece_rows, std::min(rows, (piece + 1) * piece_rows)); });
  }
  failure.rethrow();
}

/// Call body(row) for every row of [0, rows).
template <class Body>
void parallel_for(Index rows, const Body& body, Work work = Work::heavy) {
  const auto each = [&](Index begin, Index end) {
    for (Index row = begin; row < end; ++row) {
      body(row);
    }
  };
  parallel_ranges(rows, each, work);
}

/// Sum of body(row) over [0, rows): pieces are summed on their own, then in order.
/// `Sum` may be any type with += and a zero given by `zero`.
template <class Sum, class Body>
Sum parallel_sum(Index rows, Sum zero, const Body& body) {
  const Index pieces = (rows + piece_rows - 1) / piece_rows;
  std::vector<Sum> partial(static_cast<std::size_t>(pieces), zero);
  parallel_tasks(pieces, [&](Index piece) {
    Sum sum = zero;
    const Index end = std::min(rows, (piece + 1) * piece_rows);
    for (Index row = piece * piece_rows; row < end; ++row) {
      sum += body(row);
    }
    partial[static_cast<std::size_t>(piece)] = sum;
  });
  Sum total = zero;
  for (const Sum& sum : partial) {
    total += sum;
  }
  return total;
}

}  // namespace lapilli
