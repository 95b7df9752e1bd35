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

[[noreturn]] void refuse(const Owner& owner, const std::filesystem::path& path,
                         const char* else_do) {
  throw OutputError(message("another run writes this output: process ", owner.process, " on ",
                            owner.host, " since ", owner.start, " (", path.string(),
                            "); wait for it, stop it, or choose another output", else_do));
}

/// A file that can be opened, and whether it was made here.
struct Opened {
  int file = -1;
  bool is_new = false;
};

/// No file: another has just taken it away.
Opened open_file(const std::filesystem::path& path) {
  constexpr int flags = O_RDWR | O_CLOEXEC | O_NOFOLLOW;
  const int made = ::open(path.c_str(), flags | O_CREAT | O_EXCL, 0666);
  if (made >= 0 || errno != EEXIST) {
    return {made >= 0 ? made : (fail(path), -1), true};
  }
  const int found = ::open(path.c_str(), flags);
  if (found < 0 && errno != ENOENT) {
    fail(path);
  }
  return {found, false};
}

/// Take the file of a dead process away, unless another did and there is one of a living by now.
void clear_away(int file, const std::filesystem::path& path) {
  const std::filesystem::path aside = with_ending(path, message('.', ::getpid()));
  if (::rename(path.c_str(), aside.c_str()) == 0 && !is_still_there(file, aside)) {
    static_cast<void>(::link(aside.c_str(), path.c_str()));
  }
  ::unlink(aside.c_str());
}

/// Where the file system knows no locks, whoever made the file holds it. Whether a process of
/// another host lives cannot be known.
bool is_held_by_making(const Opened& opened, const std::filesystem::path& path) {
  if (opened.is_new) {
    return true;
  }
  const Owner owner = owner_of(opened.file);
  if (owner.process <= 0) {
    return false;  // its maker has yet to write its name
  }
  if (!is_dead(owner)) {
    refuse(owner, path,
           "; if that process is gone, remove this file: the file system has no locks to tell");
  }
  clear_away(opened.file, path);
  return false;
}

/// Whether this process may have the file now; throws where another run has it.
bool is_granted(const Opened& opened, const std::filesystem::path& path) {
  if (::flock(opened.file, LOCK_EX | LOCK_NB) == 0) {
    return is_still_there(opened.file, path);
  }
  if (errno == EINTR) {
    return false;
  }
  if (errno != EWOULDBLOCK) {
    return is_held_by_making(opened, path);
  }
  const Owner owner = owner_of(opened.file);
  return is_dead(owner) ? false : (refuse(owner, path, ""), false);
}

/// Open the file and lock it. Returns -1 to try again: its former owner has just taken it away, or
/// its new one has yet to write its name. A file whose lock another holds is never removed.
int open_and_lock(const std::filesystem::path& path) {
  const Opened opened = open_file(path);
  if (opened.file < 0) {
    return -1;
  }
  try {
    const std::string text = read_all(opened.file);
    if (!text.empty() && !text.starts_with(title)) {
      throw OutputError(message("'", path.string(), "' is not a lock of lapilli"));
    }
    if (is_granted(opened, path)) {
      return opened.file;
    }
  } catch (...) {
    ::close(opened.file);
    throw;
  }
  ::close(opened.file);
  return -1;
}

}  // namespace

RunLock::RunLock(const std::filesystem::path& output)
    : path_(with_ending(output, ".lock")), process_(::getpid()) {
  for (int tries = 0; !take(); ++tries) {
    if (tries == 1000) {
      throw OutputError(message("cannot lock '", path_.string(),
                                "': others come and go; if there is no other run of this output, "
                                "remove this file"));
    }
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
