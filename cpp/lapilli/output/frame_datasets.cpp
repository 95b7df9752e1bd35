#include "lapilli/output/frame_datasets.hpp"

#include <array>

#include "lapilli/core/require.hpp"
#include "lapilli/output/hdf5_file.hpp"

namespace lapilli {

std::int64_t type_of(const Column& column) {
  return column.is_index    ? hdf5_type<Index>()
         : column.is_single ? H5T_NATIVE_FLOAT
                            : hdf5_type<double>();
}

namespace {

void read_pieces(hid_t group, FrameLayout& layout) {
  const std::vector<Index> numbers = hdf5_read_attribute<Index>(group, "pieces");
  require(numbers.size() == layout.columns.size() + 2 && numbers[0] >= 1 && numbers[0] <= 9 &&
              numbers[1] >= 1,
          "its list of pieces is damaged");
  layout.compression = static_cast<int>(numbers[0]);
  layout.piece_rows = numbers[1];
  layout.piece_room.assign(numbers.begin() + 2, numbers.end());
}

}  // namespace

void write_form(std::int64_t group, const FrameLayout& layout) {
  if (layout.points_leave) {
    hdf5_attribute<Index>(group, "points_at_start", std::array{layout.points});
  }
  if (layout.is_compressed()) {
    std::vector<Index> numbers = {layout.compression, layout.piece_rows};
    numbers.insert(numbers.end(), layout.piece_room.begin(), layout.piece_room.end());
    hdf5_attribute<Index>(group, "pieces", numbers);
  }
}

void read_form(std::int64_t group, FrameLayout& layout) {
  if (H5Aexists(group, "pieces") > 0) {
    read_pieces(group, layout);
  }
  if (H5Aexists(group, "points_at_start") > 0) {
    const std::vector<Index> points = hdf5_read_attribute<Index>(group, "points_at_start");
    require(points.size() == 1 && points[0] > 0, "its number of points is damaged");
    layout.points_leave = true;
    layout.points = points[0];
  }
}

}  // namespace lapilli
