#include "lapilli/output/vtkhdf_writer.hpp"

#include <algorithm>
#include <utility>

#include "lapilli/core/require.hpp"
#include "lapilli/output/hdf5_file.hpp"

namespace lapilli {
namespace {

constexpr Index first_room = 64;  // frames, when their number is not known

}  // namespace

VtkhdfWriter::VtkhdfWriter(std::filesystem::path path, Index planned_frames)
    : path_(std::move(path)), planned_frames_(planned_frames) {
  check_frames_path(path_);
  std::error_code ignored;  // creating the first file says why a folder cannot be used
  std::filesystem::create_directories(path_.parent_path(), ignored);
  remove_frames(path_);
}

VtkhdfWriter VtkhdfWriter::resume(const std::filesystem::path& path, Index frames,
                                  Index planned_frames) {
  check_frames_path(path);
  VtkhdfWriter writer;
  writer.path_ = path;
  writer.planned_frames_ = planned_frames;
  if (frames == 0) {
    remove_frames(path);
    return writer;
  }
  FrameIndex& index = writer.index_;
  index = read_index(path);
  require(frames <= index.frames(), "cannot go on after frame ", frames, " of '", path.string(),
          "': it holds ", index.frames());
  const Hdf5Quiet quiet;
  writer.data_ = open_data(path, index, File::Mode::update);
  index.cut(frames);
  for (std::size_t column = 0; column < index.columns.size(); ++column) {
    const auto [file, slot] = index.place(index.slots[column].back());
    writer.last_.push_back(index.columns[column].may_rest ? writer.data_[file].read(column, slot)
                                                          : Words());
  }
  write_index(path, index);
  return writer;
}

void VtkhdfWriter::write(double time, const Points& points, std::span<const Field> fields) {
  const Hdf5Quiet quiet;
  const std::vector<FrameColumn> frame = frame_columns(points, fields);
  if (index_.columns.empty()) {
    begin(frame, points.size());
  }
  check_same(frame, points.size());
  FrameIndex next = index_;
  std::vector<Words> next_last(frame.size());
  next.times.push_back(time);
  for (std::size_t column = 0; column < frame.size(); ++column) {
    Words words = pack(frame[column], points.id());
    next.slots[column].push_back(store(column, words));
    if (index_.columns[column].may_rest) {
      next_last[column] = std::move(words);
    }
  }
  for (FrameData& data : data_) {
    data.sync();
  }
  next.capacities = index_.capacities;
  write_index(path_, next);
  index_ = std::move(next);
  last_ = std::move(next_last);
}

void VtkhdfWriter::begin(const std::vector<FrameColumn>& frame, Index points) {
  require(points > 0, "a simulation without points has no frames");
  index_.points = points;
  for (const FrameColumn& entry : frame) {
    index_.columns.push_back(entry.column);
  }
  index_.slots.resize(frame.size());
  last_.resize(frame.size());
}

void VtkhdfWriter::check_same(const std::vector<FrameColumn>& frame, Index points) const {
  require(points == index_.points, "the frames in '", path_.string(), "' have ", index_.points,
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
    const Index room = !first                ? index_.capacity()
                       : planned_frames_ > 0 ? planned_frames_
                                             : first_room;
    data_.push_back(FrameData::create(data_path(path_, data_.size()), index_.columns, index_.points,
                                      room, first));
    index_.capacities.push_back(room);
  }
}

/// The slot that holds `words`: a new one, or the last one when nothing changed.
Index VtkhdfWriter::store(std::size_t column, const Words& words) {
  const Index slot = index_.next_slot(column);
  if (slot > 0 && index_.columns[column].may_rest && words == last_[column]) {
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

std::vector<FrameData> open_data(const std::filesystem::path& path, const FrameIndex& index,
                                 File::Mode mode) {
  std::vector<FrameData> data;
  for (std::size_t file = 0; file < index.capacities.size(); ++file) {
    data.push_back(FrameData::open(data_path(path, file), index.columns, index.points,
                                   index.capacities[file], mode));
  }
  return data;
}

void remove_frames(const std::filesystem::path& path) {
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  for (std::size_t file = 0; std::filesystem::remove(data_path(path, file), ignored); ++file) {
  }
}

}  // namespace lapilli
