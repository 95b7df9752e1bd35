#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "lapilli/output/frame_index.hpp"

namespace lapilli {

/// Reads the frames of a run or of a merged file, and gives no number that does not fit its
/// checksum. HDF5 is asked for the index alone. One thread at a time.
class FrameReader {
 public:
  /// Throws OutputError when the index cannot be read or is damaged, std::invalid_argument when
  /// lapilli did not write it.
  explicit FrameReader(const std::filesystem::path& path);

  const FrameIndex& index() const { return index_; }
  /// Numbers of one column in one frame, rows in order of id. Throws OutputError that names file,
  /// frame and column when they are damaged or missing; other frames can still be read.
  Words read(std::size_t column, Index frame);
  /// What the journal says of a frame. Throws OutputError when that is damaged.
  FrameEntry entry(Index frame);
  /// Where a slot of a column lies: its data file, and the slot in that file.
  std::pair<const FrameData&, Index> place(Index slot);
  /// Column of a name: "position" or a field. Throws std::invalid_argument that lists them.
  std::size_t column_of(const std::string& name) const;

 private:
  FrameData& data(std::size_t file);

  std::filesystem::path path_;
  FrameIndex index_;
  std::vector<std::optional<FrameData>> data_;  // opened when needed
};

}  // namespace lapilli
