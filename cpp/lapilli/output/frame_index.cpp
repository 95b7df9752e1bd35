#include "lapilli/output/frame_index.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "lapilli/core/require.hpp"
#include "lapilli/output/file_seal.hpp"
#include "lapilli/output/frame_data.hpp"
#include "lapilli/output/frame_datasets.hpp"
#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {
namespace {

constexpr const char* cell_kinds[] = {"Vertices", "Lines", "Polygons", "Strips"};
constexpr const char* point_data = "PointData/";

/// "PointData/temperature" -> "Steps/PointDataOffsets/temperature", "Points" ->
/// "Steps/PointOffsets"
std::string offsets_name(const Column& column) {
  return column.name == "Points"
             ? "Steps/PointOffsets"
             : "Steps/PointDataOffsets/" + column.name.substr(std::string(point_data).size());
}

void write_cells(hid_t group, std::span<const Index> points) {
  for (const std::string name : cell_kinds) {
    const Hdf5Id cells = hdf5_group(group, name);
    const bool vertices = name == "Vertices";
    const std::vector<Index> none(points.size(), 0);
    const std::span<const Index> count = vertices ? points : none;
    hdf5_write<Index>(cells, "NumberOfCells", count);
    hdf5_write<Index>(cells, "NumberOfConnectivityIds", count);
    if (!vertices) {
      const std::array<Index, 1> zero = {0};
      hdf5_write<Index>(cells, "Connectivity", {});
      hdf5_write<Index>(cells, "Offsets", zero);
    }
  }
}

/// The points of each part: one part for all frames, or one for each where points may leave.
std::vector<Index> points_of_parts(const FrameIndex& index) {
  return index.points_leave ? index.counts : std::vector<Index>{index.points};
}

/// Topology never changes, or loses its end, so that all cells begin at offset zero.
void write_steps(hid_t group, const FrameIndex& index) {
  const Hdf5Id steps = hdf5_group(group, "Steps");
  const std::array<Index, 1> count = {index.frames()};
  const std::size_t frames = index.times.size();
  const std::vector<Index> zeros(4 * frames, 0), ones(frames, 1);
  hdf5_attribute<Index>(steps, "NSteps", count, true);
  hdf5_write<double>(steps, "Values", index.times);
  std::vector<Index> parts(frames, 0);
  if (index.points_leave) {
    std::iota(parts.begin(), parts.end(), Index{0});
  }
  hdf5_write<Index>(steps, "PartOffsets", parts);
  hdf5_write<Index>(steps, "NumberOfParts", ones);
  hdf5_write<Index>(steps, "CellOffsets", zeros, 4);
  hdf5_write<Index>(steps, "ConnectivityIdOffsets", zeros, 4);
  const Hdf5Id point_data_offsets = hdf5_group(steps, "PointDataOffsets");
  for (std::size_t k = 0; k < index.columns.size(); ++k) {
    std::vector<Index> offsets = index.slots[k];
    for (Index& offset : offsets) {
      offset *= index.slot_rows();
    }
    hdf5_write<Index>(group, offsets_name(index.columns[k]), offsets);
  }
}

void link(hid_t group, const std::string& name, const std::string& file) {
  hdf5_check(H5Lcreate_external(file.c_str(), ("/" + name).c_str(), group, name.c_str(),
                                H5P_DEFAULT, H5P_DEFAULT),
             "link " + name);
}

Hdf5Id rows_of(const Column& column, Index rows) {
  const hsize_t sizes[2] = {static_cast<hsize_t>(rows), static_cast<hsize_t>(column.components)};
  return Hdf5Id(H5Screate_simple(column.components == 1 ? 1 : 2, sizes, nullptr), H5Sclose,
                "make an HDF5 dataspace");
}

/// One dataset made of the same dataset in every data file, one after the other.
void join(hid_t group, const Column& column, const std::filesystem::path& path,
          const FrameIndex& index) {
  const std::string action = "join " + column.name;
  const Hdf5Id creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, action);
  const Hdf5Id all = rows_of(column, index.capacity() * index.slot_rows());
  const double missing = std::numeric_limits<double>::quiet_NaN();
  const Index no_index = -1;
  const hid_t type = type_of(column);
  const void* fill = column.is_index ? static_cast<const void*>(&no_index) : &missing;
  hdf5_check(H5Pset_fill_value(creation, column.is_index ? type : hdf5_type<double>(), fill),
             action);
  hdf5_check(H5Pset_obj_track_times(creation, false), action);
  Index begin = 0;
  for (std::size_t file = 0; file < index.capacities.size(); ++file) {
    const Index rows = index.capacities[file] * index.slot_rows();
    const hsize_t start[2] = {static_cast<hsize_t>(begin), 0};
    const hsize_t size[2] = {static_cast<hsize_t>(rows), static_cast<hsize_t>(column.components)};
    const Hdf5Id part = rows_of(column, rows);
    hdf5_check(H5Sselect_hyperslab(all, H5S_SELECT_SET, start, nullptr, size, nullptr), action);
    const std::string name = data_path(path, file).filename().string();
    hdf5_check(H5Pset_virtual(creation, all, name.c_str(), ("/" + column.name).c_str(), part),
               action);
    begin += rows;
  }
  hdf5_check(H5Sselect_all(all), action);
  const Hdf5Id dataset(
      H5Dcreate2(group, column.name.c_str(), type, all, H5P_DEFAULT, creation, H5P_DEFAULT),
      H5Dclose, action);
  hdf5_attribute(dataset, "unit", column.unit);
}

}  // namespace

Index FrameIndex::capacity() const {
  return std::accumulate(capacities.begin(), capacities.end(), Index{0});
}

void FrameIndex::cut(Index frames) {
  times.resize(static_cast<std::size_t>(frames));
  if (!sums.empty()) {
    sums.resize(static_cast<std::size_t>(frames));
  }
  if (points_leave) {
    counts.resize(static_cast<std::size_t>(frames));
  }
  for (std::vector<Index>& of_column : slots) {
    of_column.resize(static_cast<std::size_t>(frames));
  }
}

Index FrameIndex::next_slot(std::size_t column) const {
  const std::vector<Index>& used = slots[column];
  return used.empty() ? 0 : *std::max_element(used.begin(), used.end()) + 1;
}

std::pair<std::size_t, Index> FrameIndex::place(Index slot) const {
  std::size_t file = 0;
  while (slot >= capacities[file]) {
    slot -= capacities[file++];
  }
  return {file, slot};
}

std::filesystem::path data_path(const std::filesystem::path& index_path, std::size_t file) {
  return with_ending(index_path, ".data" + (file == 0 ? std::string() : std::to_string(file)));
}

void write_index_group(std::int64_t file, const FrameIndex& index) {
  const Hdf5Id group = hdf5_group(file, "VTKHDF");
  const std::array<Index, 2> version = {2, 0};
  const std::vector<Index> points = points_of_parts(index);
  hdf5_attribute<Index>(group, "Version", version);
  hdf5_attribute(group, "Type", "PolyData");
  hdf5_write<Index>(group, "NumberOfPoints", points);
  write_cells(group, points);
  write_steps(group, index);
  const Hdf5Id of_points = hdf5_group(group, "PointData");
  const Hdf5Id own = hdf5_group(file, "lapilli");
  const std::array<Index, 1> merged = {index.merged ? 1 : 0};
  hdf5_attribute(own, "columns", layout_text(index.columns));
  hdf5_attribute(own, "name", index.name);
  hdf5_attribute<Index>(own, "capacities", index.capacities);
  hdf5_attribute<Index>(own, "merged", merged);
  if (!index.sums.empty()) {
    const std::vector<Index> sums(index.sums.begin(), index.sums.end());
    hdf5_write<Index>(own, "sums", sums);
  }
  write_form(own, index);
}

void write_addresses(std::int64_t file, const FrameIndex& index) {
  const Hdf5Id own(H5Gopen2(file, "lapilli", H5P_DEFAULT), H5Gclose, "write the index");
  std::vector<Index> all;
  for (const Addresses& of_file : index.addresses) {
    all.insert(all.end(), of_file.begin(), of_file.end());
  }
  hdf5_write<Index>(own, "addresses", all);
}

void write_index(const std::filesystem::path& path, const FrameIndex& index) {
  const Hdf5Image image = hdf5_lay_out([&](hid_t file) {
    write_index_group(file, index);
    write_addresses(file, index);
    const Hdf5Id group(H5Gopen2(file, "VTKHDF", H5P_DEFAULT), H5Gclose, "write the index");
    const std::string first = data_path(path, 0).filename().string();
    link(group, "Vertices/Connectivity", first);
    link(group, "Vertices/Offsets", first);
    for (const Column& column : index.columns) {
      if (index.capacities.size() == 1) {
        link(group, column.name, first);
      } else {
        join(group, column, path, index);
      }
    }
  });
  AtomicFile on_disk(path);
  image.write_to(on_disk.file());
  FileSeal::of(image, FileSeal::Extent::whole).write_to(on_disk.file());
  on_disk.commit();
}

namespace {

std::vector<Addresses> read_addresses(hid_t own, const FrameIndex& index) {
  const std::vector<Index> all = hdf5_read<Index>(own, "addresses");
  const std::size_t columns = index.columns.size() + 1;
  require(all.size() == columns * index.capacities.size(), "its list of addresses is damaged");
  std::vector<Addresses> addresses;
  for (auto begin = all.begin(); begin != all.end();
       begin += static_cast<std::ptrdiff_t>(columns)) {
    addresses.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(columns));
  }
  return addresses;
}

/// The slot of every frame, from the first row of every frame.
std::vector<Index> read_slots(hid_t group, const Column& column, const FrameIndex& index) {
  std::vector<Index> slots = hdf5_read<Index>(group, offsets_name(column));
  require(slots.size() == index.times.size(), column.name, " has ", slots.size(), " of ",
          index.times.size(), " frames");
  for (Index& slot : slots) {
    slot /= index.slot_rows();
    require(slot >= 0 && slot < index.capacity(), column.name, " has no slot ", slot);
  }
  return slots;
}

FrameIndex read_group(hid_t file) {
  const Hdf5Id own(H5Gopen2(file, "lapilli", H5P_DEFAULT), H5Gclose, "read the index");
  const Hdf5Id group(H5Gopen2(file, "VTKHDF", H5P_DEFAULT), H5Gclose, "read the index");
  FrameIndex index;
  const std::vector<Index> points = hdf5_read<Index>(group, "NumberOfPoints");
  require(!points.empty() && *std::ranges::min_element(points) > 0, "it has no points");
  index.points = points[0];
  index.columns = parse_layout(hdf5_read_text_attribute(own, "columns"));
  read_form(own, index);
  index.name = hdf5_read_text_attribute(own, "name");
  index.capacities = hdf5_read_attribute<Index>(own, "capacities");
  index.merged = hdf5_read_attribute<Index>(own, "merged") == std::vector<Index>{1};
  index.times = hdf5_read<double>(group, "Steps/Values");
  if (index.points_leave) {
    index.counts = points;
    require(
        points.size() == index.times.size() && *std::ranges::max_element(points) <= index.points,
        "its numbers of points are damaged");
  }
  if (hdf5_exists(own, "sums")) {
    const std::vector<Index> sums = hdf5_read<Index>(own, "sums");
    require(sums.size() == index.times.size(), "its checksums of frames are damaged");
    index.sums.assign(sums.begin(), sums.end());
  }
  index.addresses = read_addresses(own, index);
  for (const Column& column : index.columns) {
    index.slots.push_back(read_slots(group, column, index));
  }
  return index;
}

}  // namespace

FrameIndex read_index(const std::filesystem::path& path) {
  require_whole(File(path, File::Mode::read));
  const Hdf5Session session;
  const Hdf5Id file = hdf5_open(path);
  require(hdf5_exists(file, "lapilli") && hdf5_exists(file, "VTKHDF"), "'", path.string(),
          "' holds no frames of lapilli");
  try {
    return read_group(file);
  } catch (const std::invalid_argument& error) {
    throw OutputError(message("'", path.string(), "' is damaged: ", error.what()));
  }
}

}  // namespace lapilli
