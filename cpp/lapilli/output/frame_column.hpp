#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "lapilli/core/field.hpp"
#include "lapilli/core/points.hpp"

namespace lapilli {

/// One dataset of a frame, as it is stored: one row per point.
struct Column {
  std::string name;        // "Points", "PointData/temperature"
  std::string unit;        // "m"
  int components = 1;      // stored numbers a row: 1, 3 (vectors) or 9 (tensors, row-major)
  bool is_index = false;   // int64 instead of float64
  bool may_rest = false;   // often the same in many frames; stored again only when it changed
  bool is_single = false;  // float32 instead of float64

  Index bytes() const { return is_single ? 4 : 8; }  // of a number
  bool operator==(const Column&) const = default;
};

/// Stored rows of one column of one frame: each number as its eight bytes, or two in one word where
/// they have four, the last word filled up with zeros.
using Words = std::vector<std::uint64_t>;

/// One column and where its values are.
struct FrameColumn {
  Column column;
  std::variant<std::span<const double>, std::span<const Index>, std::vector<Index>> values;
  std::vector<int> source;  // which given number each stored one is; -1: zero
};

/// What of a simulation goes into its frames, and how.
struct FrameOptions {
  std::optional<std::vector<std::string>> fields;  // names; not set: every field
  bool single = false;                             // fields as numbers of four bytes
  int compression = 0;                             // 0: none, 1: fast .. 9: small
  bool points_leave = false;                       // frames may differ in their number of points
  Index most_points = 0;                           // in any frame; 0: as many as in the first
};

/// Position, id, body and volume: the columns that come first in every frame, always in full
/// precision.
inline constexpr std::size_t columns_of_every_frame = 4;

/// What a frame stores: positions, id, body and volume of the points, then the fields asked for, in
/// the order of `fields`. Vectors of two-dimensional scenes get a zero third component, tensors of
/// 4 or 6 numbers (6: xx, yy, zz, xy, yz, xz) become 9. `body_numbers`: what users see of each
/// body; empty: its number. Throws std::invalid_argument for a field of the wrong size, a name
/// taken, or one asked for that is not among `fields`.
std::vector<FrameColumn> frame_columns(const Points& points, std::span<const Field> fields,
                                       const FrameOptions& options = {},
                                       std::span<const Index> body_numbers = {});

/// Whether frames hold this field.
bool is_asked_for(const Field& field, const FrameOptions& options);

/// Throw std::invalid_argument when the options ask for a field that there is not, with what there
/// is.
void require_fields(std::span<const Field> fields, const FrameOptions& options);

/// Name of a column for users: "Points" is the position.
std::string field_name(const Column& column);

/// Numbers in the rows that they go to: those of `Points::places_by_id`, so that a row is the same
/// point in every frame as long as none has left. Throws std::invalid_argument for a value that
/// four bytes cannot hold.
Words pack(const FrameColumn& column, std::span<const Index> rows);

}  // namespace lapilli
