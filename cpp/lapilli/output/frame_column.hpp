#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "lapilli/core/field.hpp"
#include "lapilli/core/points.hpp"

namespace lapilli {

/// One dataset of a frame, as it is stored: one row per point, eight bytes a number.
struct Column {
  std::string name;       // "Points", "PointData/temperature"
  std::string unit;       // "m"
  int components = 1;     // stored numbers a row: 1, 3 (vectors) or 9 (tensors, row-major)
  bool is_index = false;  // int64 instead of float64
  bool may_rest = false;  // often the same in many frames; stored again only when it changed

  bool operator==(const Column&) const = default;
};

/// Stored rows of one column of one frame, each number as its eight bytes.
using Words = std::vector<std::uint64_t>;

/// One column and where its values are.
struct FrameColumn {
  Column column;
  std::variant<std::span<const double>, std::span<const Index>> values;
  std::vector<int> source;  // which given number each stored one is; -1: zero
};

/// What a frame stores: positions, id, body and volume of the points, then every field. Vectors of
/// two-dimensional scenes get a zero third component, tensors of 4 or 6 numbers (6: xx, yy, zz, xy,
/// yz, xz) become 9. Throws std::invalid_argument for a field of the wrong size or a name taken.
std::vector<FrameColumn> frame_columns(const Points& points, std::span<const Field> fields);

/// Rows in order of id, so that a row is the same point in every frame.
Words pack(const FrameColumn& column, std::span<const Index> id);

}  // namespace lapilli
