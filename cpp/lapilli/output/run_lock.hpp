#pragma once

#include <sys/types.h>

#include <filesystem>

namespace lapilli {

/// Held by the one run that writes an output, in `run.vtkhdf.lock` beside it: the file says which
/// process of which host, and since when. The system gives the lock up when the process ends,
/// however it ends; the file goes when the run does. Forked processes have no share in it.
class RunLock {
 public:
  /// Throws OutputError naming the other run when there is one, or when the file cannot be made.
  explicit RunLock(const std::filesystem::path& output);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

 private:
  bool take();  // false: try again
  void give_up();

  std::filesystem::path path_;
  pid_t process_;
  int descriptor_ = -1;
};

}  // namespace lapilli
