#include "lapilli/output/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "lapilli/core/require.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {
namespace {

[[noreturn]] void fail(const char* action, const std::filesystem::path& path) {
  const int reason = errno;
  throw OutputError(message("cannot ", action, " '", path.string(),
                            "': ", std::generic_category().message(reason)));
}

constexpr const char* unfinished = "unfinished-";

/// run.vtkhdf -> run.vtkhdf.unfinished-4711-3.tmp: no other process and no other thread takes the
/// same.
std::filesystem::path temporary_name(const std::filesystem::path& path) {
  static std::atomic<long> number{0};
  std::error_code ignored;
  for (;;) {
    std::filesystem::path name =
        with_ending(path, message('.', unfinished, ::getpid(), '-', ++number, ".tmp"));
    if (!std::filesystem::exists(std::filesystem::symlink_status(name, ignored))) {
      return name;
    }
  }
}

/// run.vtkhdf.unfinished-4711-3.tmp and run.vtkhdf.data1.unfinished-4711-3.tmp, of run.vtkhdf.
bool is_temporary_name(const std::string& name, const std::string& of) {
  const std::size_t mark = name.rfind(std::string(".") + unfinished);
  if (!name.starts_with(of + '.') || mark == std::string::npos || mark < of.size()) {
    return false;
  }
  std::istringstream rest(name.substr(mark + 1 + std::strlen(unfinished)));
  long process = 0, number = 0;
  char dash = 0;
  std::string ending;
  return rest >> process >> dash >> number >> ending && dash == '-' && ending == ".tmp";
}

std::filesystem::path folder_of(const std::filesystem::path& path) {
  return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

int flags_of(File::Mode mode) {
  switch (mode) {
    case File::Mode::create:
      return O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC;
    case File::Mode::update:
      return O_RDWR | O_CLOEXEC;
    case File::Mode::read:
      break;
  }
  return O_RDONLY | O_CLOEXEC;
}

}  // namespace

File::File(std::filesystem::path path, Mode mode) : path_(std::move(path)) {
  descriptor_ = ::open(path_.c_str(), flags_of(mode), 0666);
  if (descriptor_ < 0) {
    fail(mode == Mode::create ? "create" : "open", path_);
  }
}

File::~File() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

File::File(File&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

std::int64_t File::size() const {
  struct stat status = {};
  if (::fstat(descriptor_, &status) != 0) {
    fail("read", path_);
  }
  return status.st_size;
}

void File::write_at(std::int64_t offset, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), offset);
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written <= 0) {
      errno = written == 0 ? ENOSPC : errno;
      fail("write", path_);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += written;
  }
}

void File::read_at(std::int64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), offset);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      fail("read", path_);
    }
    if (got == 0) {
      throw OutputError(message("'", path_.string(), "' is cut short: it ends at byte ", offset));
    }
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    offset += got;
  }
}

void File::resize(std::int64_t bytes) {
  if (::ftruncate(descriptor_, bytes) != 0) {
    fail("write", path_);
  }
}

void File::sync() {
  if (::fdatasync(descriptor_) != 0) {
    fail("write", path_);
  }
}

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)), file_(temporary_name(path_), File::Mode::create) {}

AtomicFile::~AtomicFile() {
  if (!committed_) {
    std::error_code ignored;
    std::filesystem::remove(file_.path(), ignored);
  }
}

void AtomicFile::append(std::span<const std::byte> bytes) {
  file_.write_at(size_, bytes);
  size_ += static_cast<std::int64_t>(bytes.size());
}

void AtomicFile::commit() {
  file_.sync();
  rename_durably(file_.path(), path_);
  committed_ = true;
}

void remove_unfinished(const std::filesystem::path& path) {
  std::error_code ignored;
  std::vector<std::filesystem::path> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder_of(path), ignored)) {
    if (is_temporary_name(entry.path().filename().string(), path.filename().string())) {
      left.push_back(entry.path());
    }
  }
  for (const std::filesystem::path& file : left) {
    std::filesystem::remove(file, ignored);
  }
}

void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) {
    fail("write", to);
  }
  // Some file systems cannot sync a folder; the rename itself has happened.
  const int descriptor = ::open(folder_of(to).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor);
    ::close(descriptor);
  }
}

void write_text(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.append(std::as_bytes(std::span(text)));
  file.commit();
}

void write_whole(const std::filesystem::path& path, std::string_view text) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status) ||
      std::filesystem::is_directory(status)) {
    write_text(target.empty() ? path : target, text);
    return;
  }
  std::ofstream device(path, std::ios::binary | std::ios::app);
  if (!(device << text << std::flush)) {
    throw OutputError(message("cannot write ", path.string()));
  }
}

std::filesystem::path with_ending(const std::filesystem::path& path, std::string_view ending) {
  std::filesystem::path longer = path;
  longer += ending;
  return longer;
}

}  // namespace lapilli
