#include "lapilli/output/merge.hpp"

#include "lapilli/core/require.hpp"
#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/vtkhdf_writer.hpp"

namespace lapilli {
namespace {

/// Copy the used slots of one column, one after the other.
void copy_column(hid_t group, const FrameIndex& index, std::size_t column,
                 const std::vector<FrameData>& data) {
  const Column& layout = index.columns[column];
  const hid_t type = layout.is_index ? hdf5_type<Index>() : hdf5_type<double>();
  const Index slots = index.next_slot(column);
  const Hdf5Id dataset =
      hdf5_dataset(group, layout.name, type, slots * index.points, layout.components);
  hdf5_attribute(dataset, "unit", layout.unit);
  for (Index slot = 0; slot < slots; ++slot) {
    const auto [file, place] = index.place(slot);
    const Words words = data[file].read(column, place);
    hdf5_write_rows(dataset, type, slot * index.points, index.points, layout.components,
                    words.data());
  }
}

void write_merged(hid_t file, const FrameIndex& index, const std::vector<FrameData>& data) {
  FrameIndex own = index;
  own.capacities = {0};
  write_index_group(file, own);
  const Hdf5Id group(H5Gopen2(file, "VTKHDF", H5P_DEFAULT), H5Gclose, "write the index");
  const Hdf5Id vertices(H5Gopen2(group, "Vertices", H5P_DEFAULT), H5Gclose, "write the index");
  write_topology(vertices, index.points);
  for (std::size_t column = 0; column < index.columns.size(); ++column) {
    copy_column(group, index, column, data);
  }
}

}  // namespace

void merge(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code ignored;
  require(std::filesystem::exists(from, ignored), "there is no file '", from.string(), "'");
  require(!std::filesystem::equivalent(from, to, ignored), "merge '", from.string(),
          "' into another file, not into itself");
  const FrameIndex index = read_index(from);
  const Hdf5Quiet quiet;
  const std::vector<FrameData> data = open_data(from, index, File::Mode::read);
  hdf5_create_whole(to, [&](hid_t file) { write_merged(file, index, data); });
}

}  // namespace lapilli
