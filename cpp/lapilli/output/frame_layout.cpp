#include "lapilli/output/frame_layout.hpp"

#include <sstream>

#include "lapilli/core/require.hpp"
#include "lapilli/output/packed_piece.hpp"

namespace lapilli {
namespace {

constexpr Index rows_of_a_piece = 32768;  // at most: pieces are packed side by side
constexpr Index page = 4096;              // bytes of a block of the disk

Index bytes_of_rows(const Column& column, Index rows) {
  return rows * column.components * column.bytes();
}

}  // namespace

Index FrameLayout::piece_bytes(std::size_t column) const {
  return bytes_of_rows(columns[column], is_compressed() ? piece_rows : points);
}

Index FrameLayout::slot_bytes(std::size_t column) const {
  return is_compressed() ? pieces() * piece_room[column] : bytes_of_rows(columns[column], points);
}

Index FrameLayout::slot_words(std::size_t column) const {
  return (bytes_of_rows(columns[column], points) + 7) / 8;
}

void FrameLayout::compress(int level) {
  compression = level;
  if (level == 0) {
    return;
  }
  const Index count = (points + rows_of_a_piece - 1) / rows_of_a_piece;
  piece_rows = (points + count - 1) / count;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const Index most = largest_packed_size(piece_bytes(column));
    // Only whole blocks of the disk can be holes; small pieces would lose more than they gain.
    piece_room.push_back(most < 16 * page ? most : (most + page - 1) / page * page);
  }
}

std::string layout_text(const std::vector<Column>& columns) {
  std::ostringstream text;
  for (const Column& column : columns) {
    text << column.name << '\t' << column.unit << '\t' << column.components << '\t'
         << column.is_index << '\t' << column.may_rest;
    text << (column.is_single ? "\t1\n" : "\n");
  }
  return text.str();
}

std::vector<Column> parse_layout(const std::string& layout) {
  std::vector<Column> columns;
  std::istringstream lines(layout);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream parts(line);
    Column column;
    std::getline(parts, column.name, '\t');
    std::getline(parts, column.unit, '\t');
    parts >> column.components >> column.is_index >> column.may_rest;
    require(!parts.fail() && (column.name == "Points" || column.name.starts_with("PointData/")),
            "its list of columns is damaged");
    parts >> column.is_single;  // only where it is
    columns.push_back(column);
  }
  return columns;
}

std::string described(const FrameLayout& layout) {
  std::string fields;
  bool single = false;
  for (std::size_t k = columns_of_every_frame; k < layout.columns.size(); ++k) {
    fields += (fields.empty() ? "" : ", ") + field_name(layout.columns[k]);
    single = single || layout.columns[k].is_single;
  }
  return message("fields ", fields.empty() ? "none" : fields, "; precision ",
                 single ? "single" : "double", "; compression ", layout.compression);
}

}  // namespace lapilli
