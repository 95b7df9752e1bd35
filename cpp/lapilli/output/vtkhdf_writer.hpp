#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "lapilli/output/frame_data.hpp"
#include "lapilli/output/frame_index.hpp"

namespace lapilli {

/// Frames for ParaView: a temporal VTKHDF PolyData in two files that belong together, a small index
/// `run.vtkhdf` and the numbers `run.vtkhdf.data` (links between them are relative). A frame is
/// acknowledged when write() returns: it is on the disk, and neither a killed process nor a failing
/// later write takes it away. Rows are points in order of id; where points may leave, a frame has
/// as many rows as points are left. Positions, ids, bodies and volumes are stored again only when
/// they changed. `merge` makes one self-contained file. Not handled: a number of points that grows
/// beyond the one announced, or a list of fields that changes between frames.
class VtkhdfWriter {
 public:
  /// Start a new series, removing a former one of that name. `planned_frames` is a hint for the
  /// size of the first data file (0: not known); more frames go on in further data files.
  explicit VtkhdfWriter(std::filesystem::path path, Index planned_frames = 0,
                        FrameOptions options = {});
  /// Go on with a series after its first `frames` frames; later ones are cut off. Throws
  /// std::invalid_argument when it holds fewer.
  static VtkhdfWriter resume(const std::filesystem::path& path, Index frames,
                             Index planned_frames = 0, FrameOptions options = {});

  /// Add one frame. Throws std::invalid_argument when a field does not fit the points or the former
  /// frames, OutputError when the disk fails; the frames before stay readable.
  void write(double time, const Points& points, std::span<const Field> fields,
             std::span<const Index> body_numbers = {});

  const std::filesystem::path& path() const { return path_; }
  Index frames() const { return index_.frames(); }
  std::span<const double> times() const { return index_.times; }
  /// The checksum of the numbers of a frame.
  std::uint64_t sum_of(Index frame) const { return index_.sums[static_cast<std::size_t>(frame)]; }

 private:
  VtkhdfWriter() = default;
  void begin(const std::vector<FrameColumn>& frame, Index points);
  void check_same(const std::vector<FrameColumn>& frame, Index points) const;
  void make_room(Index slot);
  Index store(std::size_t column, const Words& words, std::uint64_t checksum);
  FrameEntry store_columns(Index number, double time, const Points& points,
                           const std::vector<FrameColumn>& frame, std::vector<Words>& resting);
  void forget_later_entries();
  void clear_later_slots(const FrameIndex& before);

  std::filesystem::path path_;
  Index planned_frames_ = 0;
  FrameOptions options_;
  FrameIndex index_;
  std::vector<FrameData> data_;
  std::vector<Words> last_;  // of columns that may rest
  FrameEntry last_entry_;
};

/// Throw std::invalid_argument unless the name ends in .vtkhdf.
void check_frames_path(const std::filesystem::path& path);

/// Throw std::invalid_argument unless frames can be added under this name: a merged or renamed file
/// does not name data files beside it.
void require_own_name(const std::filesystem::path& path, const FrameIndex& index);

/// Throw std::invalid_argument when a file of others is where a series of this name would be.
void require_replaceable_frames(const std::filesystem::path& path);

/// Throw std::invalid_argument, saying what differs, when a series of frames cannot go on with
/// these options: what a frame holds and how is the same from its first to its last.
void require_same_form(const std::filesystem::path& path, const Points& points,
                       std::span<const Field> fields, const FrameOptions& options);

/// Open the data files of an index.
std::vector<FrameData> open_data(const std::filesystem::path& path, const FrameIndex& index,
                                 File::Mode mode);

/// Remove a series of frames, index first; nothing happens where there is none. Throws
/// std::invalid_argument, before anything is removed, when one of the files is not of lapilli.
void remove_frames(const std::filesystem::path& path);

}  // namespace lapilli
