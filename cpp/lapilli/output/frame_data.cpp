#include "lapilli/output/frame_data.hpp"

#include <numeric>

#include "lapilli/core/require.hpp"
#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {
namespace {

hid_t type_of(const Column& column) {
  return column.is_index ? hdf5_type<Index>() : hdf5_type<double>();
}

}  // namespace

FrameData FrameData::create(const std::filesystem::path& path, const std::vector<Column>& columns,
                            Index points, Index capacity, bool with_topology) {
  hdf5_create_whole(path, [&](hid_t file) {
    if (with_topology) {
      write_topology(hdf5_group(file, "Vertices"), points);
    }
    const Hdf5Id point_data = hdf5_group(file, "PointData");
    for (const Column& column : columns) {
      const Hdf5Id dataset =
          hdf5_dataset(file, column.name, type_of(column), capacity * points, column.components);
      hdf5_attribute(dataset, "unit", column.unit);
    }
  });
  return open(path, columns, points, capacity, File::Mode::update);
}

FrameData FrameData::open(const std::filesystem::path& path, const std::vector<Column>& columns,
                          Index points, Index capacity, File::Mode mode) {
  std::vector<std::int64_t> addresses, words;
  const Hdf5Id file = hdf5_open(path);
  for (const Column& column : columns) {
    const Hdf5Id dataset(H5Dopen2(file, column.name.c_str(), H5P_DEFAULT), H5Dclose,
                         "find " + column.name + " in '" + path.string() + "'");
    const Hdf5Id space(H5Dget_space(dataset), H5Sclose, "read '" + path.string() + "'");
    const haddr_t address = H5Dget_offset(dataset);
    const Index room = H5Sget_simple_extent_npoints(space);
    if (address == HADDR_UNDEF || room != capacity * points * column.components) {
      throw OutputError(message(
          "'", path.string(), "' does not belong to these frames: ", column.name, " has room for ",
          room, " numbers, expected ", capacity * points * column.components));
    }
    addresses.push_back(static_cast<std::int64_t>(address));
    words.push_back(points * column.components);
  }
  return FrameData(File(path, mode), std::move(addresses), std::move(words));
}

void FrameData::write(std::size_t column, Index slot, const Words& words) {
  file_.write_at(addresses_[column] + slot * words_[column] * 8, std::as_bytes(std::span(words)));
}

Words FrameData::read(std::size_t column, Index slot) const {
  Words words(static_cast<std::size_t>(words_[column]));
  file_.read_at(addresses_[column] + slot * words_[column] * 8,
                std::as_writable_bytes(std::span(words)));
  return words;
}

void write_topology(std::int64_t group, Index points) {
  std::vector<Index> count(static_cast<std::size_t>(points) + 1);
  std::iota(count.begin(), count.end(), Index{0});
  hdf5_write<Index>(group, "Offsets", count);
  hdf5_write<Index>(group, "Connectivity", std::span(count).first(count.size() - 1));
}

}  // namespace lapilli
