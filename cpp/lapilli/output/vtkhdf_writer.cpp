#include "lapilli/output/vtkhdf_writer.hpp"

#include <algorithm>
#include <utility>

#include "lapilli/core/require.hpp"
#include "lapilli/output/checksum.hpp"
#include "lapilli/output/frame_reader.hpp"
#include "lapilli/output/owned_files.hpp"

namespace lapilli {
namespace {

constexpr Index first_room = 64;         // frames, when their number is not known
constexpr Index most_compressed = 4096;  // frames: the table of pieces is written at once

/// Stages of a run may list the same fields in another order.
void put_in_order(std::vector<FrameColumn>& frame, const std::vector<Column>& columns) {
  for (std::size_t k = 0; k < std::min(frame.size(), columns.size()); ++k) {
    const auto here = frame.begin() + static_cast<std::ptrdiff_t>(k);
    const auto found = std::ranges::find(here, frame.end(), columns[k], &FrameColumn::column);
    if (found != frame.end()) {
      std::iter_swap(here, found);
    }
  }
}

}  // namespace

VtkhdfWriter::VtkhdfWriter(std::filesystem::path path, Index planned_frames, FrameOptions options)
    : path_(std::move(path)), planned_frames_(planned_frames), options_(std::move(options)) {
  check_frames_path(path_);
  std::error_code ignored;  // creating the first file says why a folder cannot be used
  std::filesystem::create_directories(path_.parent_path(), ignored);
  remove_frames(path_);
}

VtkhdfWriter VtkhdfWriter::resume(const std::filesystem::path& path, Index frames,
                                  Index planned_frames, FrameOptions options) {
  check_frames_path(path);
  VtkhdfWriter writer;
  writer.path_ = path;
  writer.planned_frames_ = planned_frames;
  writer.options_ = std::move(options);
  if (frames == 0) {
    remove_frames(path);
    return writer;
  }
  FrameIndex& index = writer.index_;
  index = read_index(path);
  require_own_name(path, index);
  require(frames <= index.frames(), "cannot go on after frame ", frames, " of '", path.string(),
          "': it holds ", index.frames());
  FrameReader reader(path);
  for (std::size_t column = 0; column < index.columns.size(); ++column) {
    writer.last_.push_back(index.columns[column].may_rest ? reader.read(column, frames - 1)
                                                          : Words());
  }
  writer.last_entry_ = reader.entry(frames - 1);
  for (Index frame = index.sums.empty() ? 0 : frames; frame < frames; ++frame) {
    index.sums.push_back(reader.entry(frame).sum());  // an index without them
  }
  writer.data_ = open_data(path, index, File::Mode::update);
  const FrameIndex before = index;
  index.cut(frames);
  write_index(path, index);
  writer.forget_later_entries();
  writer.clear_later_slots(before);
  return writer;
}

/// What is left of frames after the last one must not come back when the index is made anew.
void VtkhdfWriter::forget_later_entries() {
  for (Index frame = index_.frames(); frame < index_.capacity(); ++frame) {
    const auto [file, row] = index_.place(frame);
    const std::optional<FrameEntry> entry = data_[file].read_entry(row);
    if (!entry) {
      break;
    }
    data_[file].clear_entry(row);
  }
}

/// A shorter stream would leave the end of a longer one: what is resumed has the bytes of what
/// never stopped. One slot more than the index knew may have been written.
void VtkhdfWriter::clear_later_slots(const FrameIndex& before) {
  if (!index_.is_compressed()) {
    return;
  }
  for (std::size_t column = 0; column < index_.columns.size(); ++column) {
    const Index end = std::min(index_.capacity(), before.next_slot(column) + 1);
    for (Index slot = index_.next_slot(column); slot < end; ++slot) {
      const auto [file, place_in_file] = index_.place(slot);
      data_[file].clear(column, place_in_file);
    }
  }
}

void VtkhdfWriter::write(double time, const Points& points, std::span<const Field> fields,
                         std::span<const Index> body_numbers) {
  std::vector<FrameColumn> frame = frame_columns(points, fields, options_, body_numbers);
  put_in_order(frame, index_.columns);
  if (index_.columns.empty()) {
    begin(frame, points.size());
  }
  check_same(frame, points.size());
  std::vector<Words> resting(frame.size());
  FrameIndex next = index_;
  FrameEntry entry = store_columns(next.frames(), time, points, frame, resting);
  next.times.push_back(time);
  next.sums.push_back(entry.sum());
  if (next.points_leave) {
    next.counts.push_back(points.size());
  }
  for (std::size_t column = 0; column < frame.size(); ++column) {
    next.slots[column].push_back(entry.slots[column]);
  }
  for (FrameData& data : data_) {
    data.sync();
  }
  next.capacities = index_.capacities;
  next.addresses = index_.addresses;
  write_index(path_, next);
  index_ = std::move(next);
  last_ = std::move(resting);
  last_entry_ = std::move(entry);
}

/// Write the numbers of a frame, then its entry in the journal.
FrameEntry VtkhdfWriter::store_columns(Index number, double time, const Points& points,
                                       const std::vector<FrameColumn>& frame,
                                       std::vector<Words>& resting) {
  FrameEntry entry{number, time, {}, {}};
  if (index_.points_leave) {
    entry.points = points.size();
  }
  const std::vector<Index> rows = points.places_by_id();
  for (std::size_t column = 0; column < frame.size(); ++column) {
    Words words = pack(frame[column], rows);
    words.resize(static_cast<std::size_t>(index_.slot_words(column)), 0);
    entry.checksums.push_back(checksum_of(words));
    entry.slots.push_back(store(column, words, entry.checksums.back()));
    if (index_.columns[column].may_rest) {
      resting[column] = std::move(words);
    }
  }
  make_room(number);
  const auto [file, row] = index_.place(number);
  data_[file].write_entry(row, entry);
  return entry;
}

void VtkhdfWriter::begin(const std::vector<FrameColumn>& frame, Index points) {
  require(points > 0, "a simulation without points has no frames");
  index_.points_leave = options_.points_leave;
  index_.points = std::max(points, options_.most_points);
  index_.name = path_.filename().string();
  for (const FrameColumn& entry : frame) {
    index_.columns.push_back(entry.column);
  }
  index_.compress(options_.compression);
  index_.slots.resize(frame.size());
  last_.resize(frame.size());
}

void VtkhdfWriter::check_same(const std::vector<FrameColumn>& frame, Index points) const {
  require(points == index_.points || (index_.points_leave && points < index_.points),
          "the frames in '", path_.string(), "' have room for ", index_.points,
          " points, this one has ", points);
  require(frame.size() == index_.columns.size(), "the frames in '", path_.string(), "' have ",
          index_.columns.size(), " arrays, this one has ", frame.size());
  for (std::size_t k = 0; k < frame.size(); ++k) {
    require(frame[k].column == index_.columns[k], "the frames in '", path_.string(), "' have ",
            index_.columns[k].name, " where this one has ", frame[k].column.name,
            " (or their units or components differ)");
  }
}

/// Every further data file has as much room as all before it.
void VtkhdfWriter::make_room(Index slot) {
  while (slot >= index_.capacity()) {
    const bool first = data_.empty();
    Index room = !first ? index_.capacity() : planned_frames_ > 0 ? planned_frames_ : first_room;
    if (index_.is_compressed()) {
      room = std::min(room, most_compressed);
    }
    data_.push_back(FrameData::create(data_path(path_, data_.size()), index_, room, first));
    index_.capacities.push_back(room);
    index_.addresses.push_back(data_.back().addresses());
  }
}

/// The slot that holds `words`: a new one, or the last one when nothing changed.
Index VtkhdfWriter::store(std::size_t column, const Words& words, std::uint64_t checksum) {
  const Index slot = index_.next_slot(column);
  if (slot > 0 && index_.columns[column].may_rest && checksum == last_entry_.checksums[column] &&
      words == last_[column]) {
    return index_.slots[column].back();
  }
  make_room(slot);
  const auto [file, place_in_file] = index_.place(slot);
  data_[file].write(column, place_in_file, words);
  return slot;
}

void check_frames_path(const std::filesystem::path& path) {
  require(path.extension() == ".vtkhdf", "the output of frames must end in .vtkhdf, got '",
          path.string(), "'");
}

void require_own_name(const std::filesystem::path& path, const FrameIndex& index) {
  require(!index.merged, "'", path.string(),
          "' was merged into one file: it can be looked at, not gone on with");
  require(path.filename() == index.name, "'", path.string(), "' was written as '", index.name,
          "' and renamed: give it its name back to go on with it");
}

void require_same_form(const std::filesystem::path& path, const Points& points,
                       std::span<const Field> fields, const FrameOptions& options) {
  const FrameIndex index = read_index(path);
  FrameLayout wanted;
  wanted.compression = options.compression;
  std::vector<FrameColumn> frame = frame_columns(points, fields, options);
  put_in_order(frame, index.columns);
  for (const FrameColumn& entry : frame) {
    wanted.columns.push_back(entry.column);
  }
  require(wanted.columns == index.columns && wanted.compression == index.compression,
          "the frames of '", path.string(), "' are written with ", described(index),
          "; this run asks for ", described(wanted),
          ": give output.fields, output.precision and output.compression as they were, or another "
          "output");
}

std::vector<FrameData> open_data(const std::filesystem::path& path, const FrameIndex& index,
                                 File::Mode mode) {
  std::vector<FrameData> data;
  for (std::size_t file = 0; file < index.capacities.size(); ++file) {
    data.push_back(FrameData::open(data_path(path, file), index, index.capacities[file],
                                   index.addresses[file], mode));
  }
  return data;
}

void require_replaceable_frames(const std::filesystem::path& path) {
  require_replaceable(path, OwnedFile::frames);
  std::error_code ignored;
  for (std::size_t file = 0;
       std::filesystem::exists(std::filesystem::symlink_status(data_path(path, file), ignored));
       ++file) {
    require_replaceable(data_path(path, file), OwnedFile::data);
  }
}

void remove_frames(const std::filesystem::path& path) {
  require_replaceable_frames(path);
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  for (std::size_t file = 0; std::filesystem::remove(data_path(path, file), ignored); ++file) {
  }
}

}  // namespace lapilli
