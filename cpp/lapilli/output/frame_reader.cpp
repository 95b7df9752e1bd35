#include "lapilli/output/frame_reader.hpp"

#include "lapilli/core/require.hpp"
#include "lapilli/output/checksum.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {

FrameReader::FrameReader(const std::filesystem::path& path)
    : path_(path), index_(read_index(path)), data_(index_.capacities.size()) {}

FrameData& FrameReader::data(std::size_t file) {
  if (!data_[file]) {
    const std::filesystem::path path =
        index_.merged ? path_ : data_path(path_.parent_path() / index_.name, file);
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
      throw OutputError(message("'", path.string(), "' is missing: the numbers of '",
                                path_.string(),
                                "' lie in it. The files of a run stay together under the names "
                                "they were written with; lapilli merge makes one file of them"));
    }
    data_[file].emplace(FrameData::open(path, index_, index_.merged ? 0 : index_.capacities[file],
                                        index_.addresses[file], File::Mode::read));
  }
  return *data_[file];
}

std::pair<const FrameData&, Index> FrameReader::place(Index slot) {
  const auto [file, slot_of_file] = index_.place(slot);
  return {data(file), slot_of_file};
}

FrameEntry FrameReader::entry(Index frame) {
  const auto [file, row] = index_.place(frame);
  const std::optional<FrameEntry> entry = data(file).read_entry(row);
  const auto number = static_cast<std::size_t>(frame);
  bool fits = entry && entry->frame == frame && entry->time == index_.times[number] &&
              entry->points.value_or(index_.points) == index_.points_of(frame);
  for (std::size_t column = 0; fits && column < index_.columns.size(); ++column) {
    fits = entry->slots[column] == index_.slots[column][number];
  }
  if (!fits) {
    throw OutputError(message("'", data(file).path().string(), "' is damaged: frame ", frame,
                              " (time ", index_.times[number],
                              " s) cannot be checked, its entry in the journal is not whole"));
  }
  if (!index_.knows(*entry)) {
    throw OutputError(message("'", data(file).path().string(), "' does not belong to '",
                              path_.string(), "': frame ", frame, " (time ", index_.times[number],
                              " s) is not the one that the index names"));
  }
  return *entry;
}

Words FrameReader::read(std::size_t column, Index frame) {
  const FrameEntry expected = entry(frame);
  const auto [file, slot] = index_.place(expected.slots[column]);
  Words words = data(file).read(column, slot);
  if (checksum_of(words) != expected.checksums[column]) {
    throw OutputError(message("'", data(file).path().string(),
                              "' is damaged: ", field_name(index_.columns[column]), " of frame ",
                              frame, " (time ", expected.time, " s) does not fit its checksum"));
  }
  return words;
}

std::size_t FrameReader::column_of(const std::string& name) const {
  std::string names;
  for (std::size_t column = 0; column < index_.columns.size(); ++column) {
    if (field_name(index_.columns[column]) == name) {
      return column;
    }
    names += (names.empty() ? "" : ", ") + field_name(index_.columns[column]);
  }
  throw std::invalid_argument(
      message("no field '", name, "' in ", path_.string(), "; there is: ", names));
}

}  // namespace lapilli
