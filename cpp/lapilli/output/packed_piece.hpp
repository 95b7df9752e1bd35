#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// The most bytes that so many bytes can take when packed.
Index largest_packed_size(Index bytes);

/// Numbers of `width` bytes as the filters "shuffle" and "deflate" of HDF5 leave them: all first
/// bytes, all second bytes, and so on, then compressed at `level` (1 .. 9).
std::vector<std::byte> packed(std::span<const std::byte> numbers, Index width, int level);

/// Undo it: fill `numbers` from a stream of which `read(offset, bytes)` delivers any part up to
/// `room` bytes. Returns the length of the stream, or 0 when it is damaged or there is none; then
/// what could not be read is left as it was.
using ReadPart = std::function<void(Index offset, std::span<std::byte> bytes)>;
Index unpack(const ReadPart& read, Index room, Index width, std::span<std::byte> numbers);

}  // namespace lapilli
