#pragma once

#include <cstdint>

#include "lapilli/output/frame_layout.hpp"

namespace lapilli {

/// The type of the numbers of a column, as HDF5 calls it.
std::int64_t type_of(const Column& column);

/// Write what is unusual of a layout as attributes of a group of HDF5, and read it: how slots are
/// cut into pieces where they are compressed, and the number of points where they may leave.
/// `read_form` throws std::invalid_argument when it is damaged.
void write_form(std::int64_t group, const FrameLayout& layout);
void read_form(std::int64_t group, FrameLayout& layout);

}  // namespace lapilli
