#include "lapilli/output/run_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string>
#include <system_error>

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

/// A lock outlives its process where a forked child still holds it.
bool is_dead(const Owner& owner) {
  return owner.host == host_name() && owner.process > 0 &&
         ::kill(static_cast<pid_t>(owner.process), 0) != 0 && errno == ESRCH;
}

bool is_still_there(int file, const std::filesystem::path& path) {
  struct stat open = {}, named = {};
  return ::fstat(file, &open) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

/// Open the file and lock it. Returns -1 to try again: its former owner has just taken it away.
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
    ::unlink(path.c_str());
    return -1;
  }
  throw OutputError(message("another run writes this output: process ", owner.process, " on ",
                            owner.host, " since ", owner.start, " (", path.string(),
                            "); wait for it, stop it, or choose another output"));
}

}  // namespace

RunLock::RunLock(const std::filesystem::path& output) : path_(with_ending(output, ".lock")) {
  for (int tries = 0; descriptor_ < 0; ++tries) {
    require(tries < 1000, "cannot lock '", path_.string(), "': others come and go");
    descriptor_ = open_and_lock(path_);
  }
  const std::string text =
      message(title, "\nprocess ", ::getpid(), "\nhost ", host_name(), "\nsince ", utc_now(), "\n");
  if (::ftruncate(descriptor_, 0) != 0 ||
      ::pwrite(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size())) {
    const int reason = errno;
    ::unlink(path_.c_str());
    ::close(descriptor_);
    errno = reason;
    fail(path_);
  }
}

RunLock::~RunLock() {
  // Taken away while it is held, so that nobody can lock a file that is about to go. A forked child
  // has a share in the lock, which closing alone would leave to it.
  ::unlink(path_.c_str());
  ::flock(descriptor_, LOCK_UN);
  ::close(descriptor_);
}

}  // namespace lapilli
