#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "lapilli/output/frame_data.hpp"

namespace lapilli {

/// Which frames exist and where their numbers are: all that a reader of the frames goes by.
/// Numbers live in data files beside the index; slots count on through the data files.
struct FrameIndex : FrameLayout {
  std::vector<double> times;              // s, one a frame
  std::vector<Index> counts;              // points of each frame, where they may leave
  std::vector<std::vector<Index>> slots;  // of each column, one a frame
  std::vector<std::uint64_t> sums;        // of each frame's entry in the journal; none in old files
  std::vector<Index> capacities;          // slots of each data file
  std::vector<Addresses> addresses;       // in each data file
  std::string name;                       // the data files are called name.data, name.data1, ...
  bool merged = false;                    // index and numbers in one file; nothing can be added

  Index frames() const { return static_cast<Index>(times.size()); }
  Index points_of(Index frame) const {
    return points_leave ? counts[static_cast<std::size_t>(frame)] : points;
  }
  /// Whether an entry of the journal is that of the frame which the index knows.
  bool knows(const FrameEntry& entry) const {
    return sums.empty() || sums[static_cast<std::size_t>(entry.frame)] == entry.sum();
  }
  Index capacity() const;
  /// Forget the frames after the first `frames`.
  void cut(Index frames);
  /// First slot of a column that no frame uses.
  Index next_slot(std::size_t column) const;
  /// Which data file holds a slot, and as its how-manieth.
  std::pair<std::size_t, Index> place(Index slot) const;
};

/// The data files of an index: run.vtkhdf.data, then run.vtkhdf.data1, ...
std::filesystem::path data_path(const std::filesystem::path& index_path, std::size_t file);

/// Write the index as VTKHDF (temporal PolyData, version 2.0), all at once: a former index stays
/// valid until the new one is on the disk. One data file is linked to; several are joined by
/// virtual datasets, whose missing parts read as NaN.
void write_index(const std::filesystem::path& path, const FrameIndex& index);

/// Read what `write_index` or `merge` wrote. Throws OutputError when it cannot be read or is
/// damaged, and std::invalid_argument when lapilli did not write it.
FrameIndex read_index(const std::filesystem::path& path);

/// Write the groups VTKHDF and lapilli except for the numbers of the points (shared with `merge`),
/// and, once these have their place, where it is.
void write_index_group(std::int64_t file, const FrameIndex& index);
void write_addresses(std::int64_t file, const FrameIndex& index);

}  // namespace lapilli
