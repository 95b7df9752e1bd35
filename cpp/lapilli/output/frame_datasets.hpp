#pragma once

#include <cstdint>

#include "lapilli/output/frame_layout.hpp"

namespace lapilli {

/// The type of the numbers of a column, as HDF5 calls it.
std::int64_t type_of(const Column& column);

/// Write how slots are cut into pieces as an attribute of a group of HDF5, and read it; nothing is
/// written where nothing is compressed. `read_pieces` throws std::invalid_argument when it is
/// damaged.
void write_pieces(std::int64_t group, const FrameLayout& layout);
void read_pieces(std::int64_t group, FrameLayout& layout);

}  // namespace lapilli
