#pragma once

namespace lapilli {

/// Threads that were set by `set_thread_count`, 0 where nobody did.
int chosen_thread_count();

/// While it lives, loops of the calling thread use at most so many threads.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  int before_;
};

}  // namespace lapilli
