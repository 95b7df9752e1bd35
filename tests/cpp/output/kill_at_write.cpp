// Preloaded into a writer: kills the process with SIGKILL just before its k-th call that changes a
// file, k from KILL_AT_WRITE. With KILL_HALF_WAY set, half of the bytes of that call still arrive.
// Standard output is not counted. With FAIL_AT_WRITE instead, that call and all after it fail as on
// a full disk; with FAIL_ONCE set too, that call alone. With NO_LOCKS the file system knows none.

#include <dlfcn.h>
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace {

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool is_last_call() {
  static const char* const at = std::getenv("KILL_AT_WRITE");
  static long left = at != nullptr ? std::atol(at) : 0;
  return at != nullptr && left-- == 0;
}

/// Whether this call finds the disk full.
bool is_refused() {
  static const char* const at = std::getenv("FAIL_AT_WRITE");
  static long left = at != nullptr ? std::atol(at) : 0;
  if (at == nullptr || left-- > 0 || (left < -1 && std::getenv("FAIL_ONCE") != nullptr)) {
    return false;
  }
  errno = ENOSPC;
  return true;
}

void die() { kill(getpid(), SIGKILL); }

template <class Write>
void die_if_last(const Write& write, size_t size) {
  if (is_last_call()) {
    if (std::getenv("KILL_HALF_WAY") != nullptr && size > 1) {
      write(size / 2);
    }
    die();
  }
}

}  // namespace

extern "C" {

#define EXPORTED __attribute__((visibility("default")))

EXPORTED ssize_t write(int file, const void* bytes, size_t size) {
  const auto real = next<ssize_t (*)(int, const void*, size_t)>("write");
  if (file > 2) {
    die_if_last([&](size_t part) { real(file, bytes, part); }, size);
    if (is_refused()) {
      return -1;
    }
  }
  return real(file, bytes, size);
}

EXPORTED ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) {
  const auto real = next<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite");
  die_if_last([&](size_t part) { real(file, bytes, part, at); }, size);
  return is_refused() ? -1 : real(file, bytes, size, at);
}

EXPORTED ssize_t pwrite64(int file, const void* bytes, size_t size, off64_t at) {
  const auto real = next<ssize_t (*)(int, const void*, size_t, off64_t)>("pwrite64");
  die_if_last([&](size_t part) { real(file, bytes, part, at); }, size);
  return is_refused() ? -1 : real(file, bytes, size, at);
}

EXPORTED int ftruncate(int file, off_t size) {
  die_if_last([](size_t) {}, 0);
  return is_refused() ? -1 : next<int (*)(int, off_t)>("ftruncate")(file, size);
}

EXPORTED int ftruncate64(int file, off64_t size) {
  die_if_last([](size_t) {}, 0);
  return is_refused() ? -1 : next<int (*)(int, off64_t)>("ftruncate64")(file, size);
}

EXPORTED int fdatasync(int file) {
  die_if_last([](size_t) {}, 0);
  return is_refused() ? -1 : next<int (*)(int)>("fdatasync")(file);
}

EXPORTED int rename(const char* from, const char* to) noexcept {
  die_if_last([](size_t) {}, 0);
  return is_refused() ? -1 : next<int (*)(const char*, const char*)>("rename")(from, to);
}

EXPORTED int flock(int file, int operation) noexcept {
  if (std::getenv("NO_LOCKS") != nullptr) {
    errno = ENOSYS;
    return -1;
  }
  return next<int (*)(int, int)>("flock")(file, operation);
}

}  // extern "C"
