#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "lapilli/core/parallel.hpp"

using namespace lapilli;

TEST_CASE("sums are the same bytes for any number of threads") {
  const auto term = [](Index row) { return std::sin(static_cast<double>(row)); };
  set_thread_count(1);
  const double alone = parallel_sum(100'001, 0.0, term);
  for (int threads : {2, 3, 4}) {
    set_thread_count(threads);
    REQUIRE(parallel_sum(100'001, 0.0, term) == alone);
  }
  set_thread_count(0);
  // sum of sin(k) for k < n has a closed form
  const double n = 100'001;
  REQUIRE(alone ==
          Approx(std::sin(0.5 * (n - 1)) * std::sin(0.5 * n) / std::sin(0.5)).margin(1e-9));
}

TEST_CASE("runs call every task once, neighbours in one thread") {
  for (int threads : {1, 3}) {
    set_thread_count(threads);
    std::vector<int> calls(100, 0), thread(100, -1);
    parallel_runs(100, [&](Index task) {
      ++calls[task];
      thread[task] = thread_index();
    });
    REQUIRE(std::all_of(calls.begin(), calls.end(), [](int count) { return count == 1; }));
    REQUIRE(std::is_sorted(thread.begin(), thread.end()));
  }
  set_thread_count(0);
}

TEST_CASE("a wave follows each task once, after all that the task needs") {
  const auto tasks = GENERATE(0, 1, 2, 40);
  const auto reach = GENERATE(0, 3, 1000);
  std::vector<TaskRange> needs;
  for (Index task = 0; task < tasks; ++task) {
    needs.push_back({std::max<Index>(0, task - reach), std::min<Index>(tasks - 1, task + reach)});
  }
  for (int threads : {1, 2, 4, 7}) {
    set_thread_count(threads);
    std::vector<int> led(tasks, 0), followed(tasks, 0);
    std::vector<char> early(tasks, 0);
    parallel_wave(
        needs, [&](Index task) { ++led[task]; },
        [&](Index task) {
          ++followed[task];
          for (Index other = needs[task].first; other <= needs[task].last; ++other) {
            early[task] = early[task] != 0 || led[other] != 1 ? 1 : 0;
          }
        });
    CAPTURE(tasks, reach, threads);
    REQUIRE(std::all_of(led.begin(), led.end(), [](int count) { return count == 1; }));
    REQUIRE(std::all_of(followed.begin(), followed.end(), [](int count) { return count == 1; }));
    REQUIRE(std::none_of(early.begin(), early.end(), [](char any) { return any != 0; }));
  }
  set_thread_count(0);
}

TEST_CASE("one thread follows a task as soon as it can") {
  set_thread_count(1);
  std::vector<TaskRange> needs;
  for (Index task = 0; task < 6; ++task) {
    needs.push_back({std::max<Index>(0, task - 1), std::min<Index>(5, task + 1)});
  }
  std::vector<Index> order;
  parallel_wave(
      needs, [&](Index task) { order.push_back(task); },
      [&](Index task) { order.push_back(-task); });
  REQUIRE(order == std::vector<Index>{0, 1, 0, 2, -1, 3, -2, 4, -3, 5, -4, -5});
  set_thread_count(0);
}

TEST_CASE("an absurd thread count is refused") {
  REQUIRE_THROWS_AS(set_thread_count(-1), std::invalid_argument);
}

TEST_CASE("a forked process goes on with one thread where its parent had more") {
  set_thread_count(2);
  parallel_tasks(8, [](Index) {});
  const pid_t child = fork();
  if (child == 0) {
    alarm(20);
    Index sum = 0;
    const bool alone = thread_count() == 1;
    parallel_runs(8, [&](Index task) { sum += task; });
    _exit(alone && sum == 28 ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  REQUIRE(WEXITSTATUS(status) == 0);
  REQUIRE(thread_count() == 2);
  set_thread_count(0);
}

namespace {

std::string message_of_row(Index row) { return "row " + std::to_string(row); }

std::string failure_of(const std::function<void()>& loop) {
  try {
    loop();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "none";
}

void fail_at(Index row, std::initializer_list<Index> rows) {
  if (std::find(rows.begin(), rows.end(), row) != rows.end()) {
    throw std::runtime_error(message_of_row(row));
  }
}

}  // namespace

TEST_CASE("the exception of the earliest task leaves a loop, for any number of threads") {
  const auto piece = piece_rows;
  const std::vector<TaskRange> needs = [] {
    std::vector<TaskRange> ranges;
    for (Index task = 0; task < 50; ++task) {
      ranges.push_back({std::max<Index>(0, task - 3), std::min<Index>(49, task + 3)});
    }
    return ranges;
  }();
  const auto nothing = [](Index) {};
  for (int threads : {1, 2, 3, 5}) {
    set_thread_count(threads);
    CAPTURE(threads);
    for (int repeat = 0; repeat < 20; ++repeat) {
      CHECK(failure_of([] {
              parallel_tasks(90, [](Index t) { fail_at(t, {7, 8, 61}); });
            }) == "row 7");
      CHECK(failure_of([] {
              parallel_runs(90, [](Index t) { fail_at(t, {31, 61, 89}); });
            }) == "row 31");
      CHECK(failure_of([&] {
              parallel_for(6 * piece, [&](Index r) { fail_at(r, {3 * piece + 5, 5 * piece}); });
            }) == message_of_row(3 * piece + 5));
      CHECK(failure_of([&] {
              parallel_sum(6 * piece, 0, [&](Index r) {
                fail_at(r, {4 * piece, 4 * piece + 1});
                return 1;
              });
            }) == message_of_row(4 * piece));
      CHECK(failure_of([&] {
              parallel_wave(
                  needs,
                  [](Index t) {
                    fail_at(t, {40, 45});
                  },
                  [](Index t) {
                    fail_at(t, {0, 12});
                  });
            }) == "row 40");
      CHECK(failure_of([&] {
              parallel_wave(needs, nothing, [](Index t) { fail_at(t, {22, 24, 26, 48}); });
            }) == "row 22");
    }
    CHECK_THROWS_AS(parallel_tasks(4, [](Index) { throw std::bad_alloc(); }), std::bad_alloc);
  }
  set_thread_count(0);
}
