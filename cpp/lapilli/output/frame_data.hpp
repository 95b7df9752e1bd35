#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lapilli/output/file.hpp"
#include "lapilli/output/frame_journal.hpp"
#include "lapilli/output/frame_layout.hpp"

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
  static FrameData create(const std::filesystem::path& path, const FrameLayout& layout,
                          Index capacity, bool with_topology);
  /// Open a file made by `create`, without HDF5. Throws OutputError when it is missing or shorter
  /// than it was.
  static FrameData open(const std::filesystem::path& path, const FrameLayout& layout,
                        Index capacity, Addresses addresses, File::Mode mode);

  /// Write or read the rows of one column in one slot (0 .. capacity-1). What of a compressed slot
  /// is damaged comes as zeros.
  void write(std::size_t column, Index slot, const Words& words);
  Words read(std::size_t column, Index slot) const;
  /// Make a compressed slot as it was before anything was written into it.
  void clear(std::size_t column, Index slot);
  /// Bytes that the longest piece of a compressed slot takes.
  Index longest_piece(std::size_t column, Index slot) const;
  /// The bytes of a slot as they lie in the file, of every piece the first `room`.
  std::vector<std::byte> bytes_of_slot(std::size_t column, Index slot, Index room) const;
  /// Write or read what the journal says of a frame; read: nothing where no whole entry is.
  void write_entry(Index row, const FrameEntry& entry);
  std::optional<FrameEntry> read_entry(Index row) const;
  /// Take an entry away again.
  void clear_entry(Index row);
  void sync() { file_.sync(); }

  const Addresses& addresses() const { return addresses_; }
  const std::filesystem::path& path() const { return file_.path(); }

 private:
  FrameData(File file, Addresses addresses, const FrameLayout& layout);
  std::int64_t byte_of(std::size_t column, Index slot) const {
    return addresses_[column] + slot * layout_.slot_bytes(column);
  }
  std::int64_t byte_of_entry(Index row) const { return addresses_.back() + row * entry_words_ * 8; }
  void write_packed(std::size_t column, Index slot, const Words& words);
  Words read_packed(std::size_t column, Index slot) const;
  Index unpack_piece(std::size_t column, Index slot, Index piece,
                     std::span<std::byte> numbers) const;

  File file_;
  Addresses addresses_;
  FrameLayout layout_;
  Index entry_words_;
};

/// Write the cells of `points` points into the HDF5 group Vertices: each is one vertex.
void write_topology(std::int64_t group, Index points);

/// Make room for so many slots of a column, with its unit; returns the byte at which it begins.
Index lay_out_column(std::int64_t group, const FrameLayout& layout, std::size_t column,
                     Index slots);
/// The same for the journal of so many frames.
Index lay_out_journal(std::int64_t group, const FrameLayout& layout, Index frames);

}  // namespace lapilli
