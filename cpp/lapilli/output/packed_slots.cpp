#include <algorithm>
#include <vector>

#include "lapilli/core/parallel.hpp"
#include "lapilli/output/frame_data.hpp"
#include "lapilli/output/packed_piece.hpp"

// What of a data file its compressed slots need. Pieces are packed and unpacked side by side.

namespace lapilli {

void FrameData::write_packed(std::size_t column, Index slot, const Words& words) {
  const Index pieces = layout_.pieces(), width = layout_.columns[column].bytes();
  const auto size = static_cast<std::size_t>(layout_.piece_bytes(column));
  Words filled = words;  // rows beyond the last point are zero
  filled.resize((size * static_cast<std::size_t>(pieces) + 7) / 8, 0);
  const auto numbers = std::as_bytes(std::span(filled));
  std::vector<std::vector<std::byte>> streams(static_cast<std::size_t>(pieces));
  parallel_tasks(pieces, [&](Index piece) {
    const auto part = numbers.subspan(static_cast<std::size_t>(piece) * size, size);
    streams[static_cast<std::size_t>(piece)] = packed(part, width, layout_.compression);
  });
  for (Index piece = 0; piece < pieces; ++piece) {
    file_.write_at(byte_of(column, slot) + piece * layout_.piece_room[column],
                   streams[static_cast<std::size_t>(piece)]);
  }
}

/// Length of the stream, 0 when there is no whole one; `numbers` are filled only by a whole one.
Index FrameData::unpack_piece(std::size_t column, Index slot, Index piece,
                              std::span<std::byte> numbers) const {
  const Index room = layout_.piece_room[column];
  const std::int64_t begin = byte_of(column, slot) + piece * room;
  const auto read = [&](Index offset, std::span<std::byte> bytes) {
    file_.read_at(begin + offset, bytes);
  };
  return unpack(read, room, layout_.columns[column].bytes(), numbers);
}

Words FrameData::read_packed(std::size_t column, Index slot) const {
  const Index pieces = layout_.pieces();
  const auto size = static_cast<std::size_t>(layout_.piece_bytes(column));
  Words words((size * static_cast<std::size_t>(pieces) + 7) / 8, 0);
  const auto numbers = std::as_writable_bytes(std::span(words));
  parallel_tasks(pieces, [&](Index piece) {
    unpack_piece(column, slot, piece,
                 numbers.subspan(static_cast<std::size_t>(piece) * size, size));
  });
  words.resize(static_cast<std::size_t>(layout_.slot_words(column)));
  return words;
}

void FrameData::clear(std::size_t column, Index slot) {
  std::vector<std::byte> numbers(static_cast<std::size_t>(layout_.piece_bytes(column)));
  const Index room = layout_.piece_room[column];
  for (Index piece = 0; piece < layout_.pieces(); ++piece) {
    const std::int64_t begin = byte_of(column, slot) + piece * room;
    std::byte first[2];
    file_.read_at(begin, first);
    if (first[0] == std::byte{0} && first[1] == std::byte{0}) {
      continue;  // no stream begins so: nothing was written
    }
    const Index length = unpack_piece(column, slot, piece, numbers);
    const std::vector<std::byte> zeros(static_cast<std::size_t>(length > 0 ? length : room));
    file_.write_at(begin, zeros);
  }
}

Index FrameData::longest_piece(std::size_t column, Index slot) const {
  std::vector<std::byte> numbers(static_cast<std::size_t>(layout_.piece_bytes(column)));
  Index longest = 0;
  for (Index piece = 0; piece < layout_.pieces(); ++piece) {
    longest = std::max(longest, unpack_piece(column, slot, piece, numbers));
  }
  return longest;
}

std::vector<std::byte> FrameData::bytes_of_slot(std::size_t column, Index slot, Index room) const {
  const Index pieces = layout_.pieces();
  std::vector<std::byte> bytes(static_cast<std::size_t>(pieces * room));
  for (Index piece = 0; piece < pieces; ++piece) {
    file_.read_at(byte_of(column, slot) + piece * layout_.piece_room[column],
                  std::span(bytes).subspan(static_cast<std::size_t>(piece * room),
                                           static_cast<std::size_t>(room)));
  }
  return bytes;
}

}  // namespace lapilli
