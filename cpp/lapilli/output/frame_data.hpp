#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lapilli/output/file.hpp"
#include "lapilli/output/frame_column.hpp"
#include "lapilli/output/frame_journal.hpp"

namespace lapilli {

/// Where a data file keeps what: the byte at which each column begins, then that of the journal.
using Addresses = std::vector<Index>;

/// A file with room for a number of frames, all of it laid out when the file is made: its HDF5
/// structure never changes afterwards, and a frame is one plain write a column and one into the
/// journal. Room not yet used is a hole in the file and takes no disk space.
class FrameData {
 public:
  /// Make the file, replacing a former one all at once. The first of a series also holds the
  /// topology: every point is a vertex.
  static FrameData create(const std::filesystem::path& path, const std::vector<Column>& columns,
                          Index points, Index capacity, bool with_topology);
  /// Open a file made by `create`, without HDF5. Throws OutputError when it is missing or shorter
  /// than it was.
  static FrameData open(const std::filesystem::path& path, const std::vector<Column>& columns,
                        Index points, Index capacity, Addresses addresses, File::Mode mode);

  /// Write or read the rows of one column in one slot (0 .. capacity-1).
  void write(std::size_t column, Index slot, const Words& words);
  Words read(std::size_t column, Index slot) const;
  /// Write or read what the journal says of a frame; read: nothing where no whole entry is.
  void write_entry(Index row, const FrameEntry& entry);
  std::optional<FrameEntry> read_entry(Index row) const;
  /// Take an entry away again.
  void clear_entry(Index row);
  void sync() { file_.sync(); }

  const Addresses& addresses() const { return addresses_; }
  const std::filesystem::path& path() const { return file_.path(); }

 private:
  FrameData(File file, Addresses addresses, const std::vector<Column>& columns, Index points);
  std::int64_t byte_of(std::size_t column, Index slot) const {
    return addresses_[column] + slot * words_[column] * 8;
  }

  File file_;
  Addresses addresses_;
  std::vector<Index> words_;  // numbers a frame of each column, then of the journal
};

/// Write the cells of `points` points into the HDF5 group Vertices: each is one vertex.
void write_topology(std::int64_t group, Index points);

/// Make room for so many slots of a column, with its unit; returns the byte at which it begins.
Index lay_out_column(std::int64_t group, const Column& column, Index points, Index slots);
/// The same for the journal of so many frames.
Index lay_out_journal(std::int64_t group, std::size_t columns, Index frames);

/// Name, unit and kind of each column as lines of text, and back. `parse_layout` throws
/// std::invalid_argument when the text is damaged.
std::string layout_text(const std::vector<Column>& columns);
std::vector<Column> parse_layout(const std::string& layout);

}  // namespace lapilli
