#pragma once

#include <filesystem>
#include <vector>

#include "lapilli/output/file.hpp"
#include "lapilli/output/frame_column.hpp"

namespace lapilli {

/// A file with room for a number of frames, all of it laid out when the file is made: its HDF5
/// structure never changes afterwards, and a frame is one plain write a column. Room not yet used
/// is a hole in the file and takes no disk space.
class FrameData {
 public:
  /// Make the file, replacing a former one all at once. The first of a series also holds the
  /// topology: every point is a vertex.
  static FrameData create(const std::filesystem::path& path, const std::vector<Column>& columns,
                          Index points, Index capacity, bool with_topology);
  /// Open a file made by `create`. Throws OutputError when it does not fit.
  static FrameData open(const std::filesystem::path& path, const std::vector<Column>& columns,
                        Index points, Index capacity, File::Mode mode);

  /// Write or read the rows of one column in one slot (0 .. capacity-1).
  void write(std::size_t column, Index slot, const Words& words);
  Words read(std::size_t column, Index slot) const;
  void sync() { file_.sync(); }

 private:
  FrameData(File file, std::vector<std::int64_t> addresses, std::vector<std::int64_t> row_words)
      : file_(std::move(file)), addresses_(std::move(addresses)), words_(std::move(row_words)) {}

  File file_;
  std::vector<std::int64_t> addresses_;  // byte where each column begins
  std::vector<std::int64_t> words_;      // numbers a frame of each column
};

/// Write the cells of `points` points into the HDF5 group Vertices: each is one vertex.
void write_topology(std::int64_t group, Index points);

}  // namespace lapilli
