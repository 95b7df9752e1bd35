#pragma once

#include <string>
#include <vector>

#include "lapilli/output/frame_column.hpp"

namespace lapilli {

/// How frames lie in their data files. A slot is the room of one column in one frame. Without
/// compression it holds `points` rows as they are. With it, slots are cut into pieces of
/// `piece_rows` rows (the chunks of HDF5), each of which is shuffled and deflated for itself and
/// written at the beginning of a room of its own; what is not filled of a room stays a hole.
struct FrameLayout {
  Index points = 0;  // of the first frame
  std::vector<Column> columns;
  bool points_leave = false;      // later frames may have fewer
  int compression = 0;            // 0, or the level of deflate
  Index piece_rows = 0;           // of every slot; 0 without compression
  std::vector<Index> piece_room;  // bytes, of each column; empty without compression

  bool is_compressed() const { return compression > 0; }
  Index pieces() const { return is_compressed() ? (points + piece_rows - 1) / piece_rows : 1; }
  /// Rows from one slot to the next.
  Index slot_rows() const { return is_compressed() ? pieces() * piece_rows : points; }
  /// Bytes of the numbers of a piece, and from one slot to the next.
  Index piece_bytes(std::size_t column) const;
  Index slot_bytes(std::size_t column) const;
  /// Words that hold the numbers of one slot.
  Index slot_words(std::size_t column) const;

  /// Cut slots into pieces, of which every one has room for whatever it holds.
  void compress(int level);
};

/// Name, unit and kind of each column as lines of text, and back. `parse_layout` throws
/// std::invalid_argument when the text is damaged.
std::string layout_text(const std::vector<Column>& columns);
std::vector<Column> parse_layout(const std::string& layout);

/// Fields and form of frames in words: "fields temperature, velocity; precision double;
/// compression 0".
std::string described(const FrameLayout& layout);

}  // namespace lapilli
