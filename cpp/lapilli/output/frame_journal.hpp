#pragma once

#include <optional>
#include <vector>

#include "lapilli/output/frame_column.hpp"

namespace lapilli {

/// What the journal of a data file says of one frame: enough to check its numbers, and to find them
/// when the index is lost.
struct FrameEntry {
  Index frame = 0;
  double time = 0.0;                     // s
  std::vector<Index> slots;              // of each column
  std::vector<std::uint64_t> checksums;  // of the numbers in each
  std::optional<Index> points = {};      // where they may leave

  /// Words of the entry of a frame with so many columns, and whether points may leave.
  static Index words_of(std::size_t columns, bool points_leave) {
    return 3 + 2 * static_cast<Index>(columns) + (points_leave ? 1 : 0);
  }
  Words to_words() const;
  /// The checksum of all that the entry says, and so of every number of the frame.
  std::uint64_t sum() const { return to_words().back(); }
  /// Nothing when the words are no entry, or a damaged one.
  static std::optional<FrameEntry> from_words(const Words& words);
};

}  // namespace lapilli
