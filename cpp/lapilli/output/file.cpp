#include "lapilli/output/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
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

int flags_of(File::Mode mode) {
  switch (mode) {
    case File::Mode::create:
      return O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC;
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

void File::sync() {
  if (::fdatasync(descriptor_) != 0) {
    fail("write", path_);
  }
}

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)), file_(with_ending(path_, ".tmp"), File::Mode::create) {}

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

void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) {
    fail("write", to);
  }
  // Some file systems cannot sync a folder; the rename itself has happened.
  const std::filesystem::path folder = to.has_parent_path() ? to.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
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

std::filesystem::path with_ending(const std::filesystem::path& path, std::string_view ending) {
  std::filesystem::path longer = path;
  longer += ending;
  return longer;
}

}  // namespace lapilli
