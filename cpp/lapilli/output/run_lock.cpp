#include "lapilli/output/run_lock.hpp"

#include <fcntl.h>
#include <pthread.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "lapilli/core/require.hpp"
#include "lapilli/output/file.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/output/run_record.hpp"

namespace lapilli {
namespace {

constexpr const char* title = "lapilli writes this output";

struct Owner {
  long process = 0;
  std::string host, start;
};

/// The lock files that this process has open. A forked process would share the locks and keep them
/// beyond the end of its parent: it closes its copies.
struct OpenLocks {
  std::mutex busy;
  std::vector<int> files;
};

OpenLocks& open_locks() {
  static OpenLocks* const all = [] {
    pthread_atfork([] { open_locks().busy.lock(); }, [] { open_locks().busy.unlock(); },
                   [] {
                     for (const int file : open_locks().files) {
                       ::close(file);
                     }
                     open_locks().files.clear();
                     open_locks().busy.unlock();
                   });
    return new OpenLocks;
  }();
  return *all;
}

[[noreturn]] void fail(const std::filesystem::path& path) {
  const int reason = errno;
  throw OutputError(
      message("cannot lock '", path.string(), "': ", std::generic_category().message(reason)));
}

std::string host_name() {
  std::array<char, 256> name = {};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : "unknown";
}

std::string read_all(int file) {
  std::array<char, 1024> text = {};
  const ssize_t size = ::pread(file, text.data(), text.size(), 0);
  return std::string(text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
}

Owner owner_of(int file) {
  Owner owner;
  std::istringstream lines(read_all(file));
  std::string line;
  std::getline(lines, line);
  lines >> line >> owner.process >> line >> owner.host >> line >> owner.start;
  return owner;
}

/// Whether the text is of a process before the one that holds the lock, or of none.
bool is_dead(const Owner& owner) {
  return owner.process <= 0 ||
         (owner.host == host_name() && ::kill(static_cast<pid_t>(owner.process), 0) != 0 &&
          errno == ESRCH);
}

bool is_still_there(int file, const std::filesystem::path& path) {
  struct stat open = {}, named = {};
  return ::fstat(file, &open) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

/// Open the file and lock it. Returns -1 to try again: its former owner has just taken it away, or
/// its new one has yet to write its name. A file whose lock another holds is never removed.
int open_and_lock(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (file < 0) {
    fail(path);
  }
  const std::string text = read_all(file);
  if (!text.empty() && !text.starts_with(title)) {
    ::close(file);
    throw OutputError(message("'", path.string(), "' is not a lock of lapilli"));
  }
  if (::flock(file, LOCK_EX | LOCK_NB) == 0 || (errno != EWOULDBLOCK && errno != EINTR)) {
    // Some file systems know no locks: there the file alone must do.
    if (is_still_there(file, path)) {
      return file;
    }
    ::close(file);
    return -1;
  }
  const Owner owner = owner_of(file);
  ::close(file);
  if (is_dead(owner)) {
    return -1;
  }
  throw OutputError(message("another run writes this output: process ", owner.process, " on ",
                            owner.host, " since ", owner.start, " (", path.string(),
                            "); wait for it, stop it, or choose another output"));
}

}  // namespace

RunLock::RunLock(const std::filesystem::path& output)
    : path_(with_ending(output, ".lock")), process_(::getpid()) {
  for (int tries = 0; !take(); ++tries) {
    require(tries < 1000, "cannot lock '", path_.string(), "': others come and go");
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const std::string text =
      message(title, "\nprocess ", process_, "\nhost ", host_name(), "\nsince ", utc_now(), "\n");
  if (::ftruncate(descriptor_, 0) != 0 ||
      ::pwrite(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    const int reason = errno;
    give_up();
    errno = reason;
    fail(path_);
  }
}

RunLock::~RunLock() {
  if (::getpid() == process_) {  // not in a forked process that unwinds
    give_up();
  }
}

bool RunLock::take() {
  OpenLocks& all = open_locks();
  const std::lock_guard guard(all.busy);
  descriptor_ = open_and_lock(path_);
  if (descriptor_ >= 0) {
    all.files.push_back(descriptor_);
  }
  return descriptor_ >= 0;
}

void RunLock::give_up() {
  OpenLocks& all = open_locks();
  const std::lock_guard guard(all.busy);
  // Taken away while it is held, so that nobody can lock a file that is about to go.
  ::unlink(path_.c_str());
  std::erase(all.files, descriptor_);
  ::close(descriptor_);
}

}  // namespace lapilli
