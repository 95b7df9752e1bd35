#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace lapilli {

/// An open file (POSIX). Every failure throws OutputError with file and reason.
class File {
 public:
  enum class Mode { create, update, read };  // create: there must be none of that name

  File(std::filesystem::path path, Mode mode);
  ~File();
  File(File&& other) noexcept;
  File& operator=(File&&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::int64_t size() const;
  void write_at(std::int64_t offset, std::span<const std::byte> bytes);
  /// Fill all of `bytes`; a file that ends earlier is an error.
  void read_at(std::int64_t offset, std::span<std::byte> bytes) const;
  /// Make the file so long; what is new of it reads as zeros and takes no room on the disk.
  void resize(std::int64_t bytes);
  /// Return after what was written is on the disk.
  void sync();

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// A file that appears under its name all at once: written under a name of its own in the same
/// folder, brought to disk, renamed. Until commit() a former file of that name stays as it was;
/// without commit() nothing remains.
class AtomicFile {
 public:
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void append(std::span<const std::byte> bytes);
  File& file() { return file_; }
  void commit();

 private:
  std::filesystem::path path_;
  File file_;
  std::int64_t size_ = 0;
  bool committed_ = false;
};

/// Remove what processes that died while they wrote left of `path`; nobody else may be writing it.
void remove_unfinished(const std::filesystem::path& path);

/// Give a finished file its final name, replacing a former one, and bring the folder to disk.
void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to);

/// Write `text` as a whole file, all at once.
void write_text(const std::filesystem::path& path, std::string_view text);

/// The same where a user says: a link keeps its name and its target is written, a device or a pipe
/// takes the bytes.
void write_whole(const std::filesystem::path& path, std::string_view text);

/// `path` with `ending` put after its whole name: run.vtkhdf -> run.vtkhdf.data.
std::filesystem::path with_ending(const std::filesystem::path& path, std::string_view ending);

}  // namespace lapilli
