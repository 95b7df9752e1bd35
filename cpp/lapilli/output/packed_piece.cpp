#include "lapilli/output/packed_piece.hpp"

#include <zlib.h>

#include <algorithm>
#include <new>

namespace lapilli {
namespace {

// HDF5 shuffles whole numbers and leaves what is over at the end as it is; here nothing is.
void shuffle(std::span<const std::byte> from, std::size_t width, std::byte* to) {
  const std::size_t count = from.size() / width;
  for (std::size_t byte = 0; byte < width; ++byte) {
    for (std::size_t k = 0; k < count; ++k) {
      *to++ = from[k * width + byte];
    }
  }
}

void put_back(std::span<const std::byte> from, std::size_t width, std::byte* to) {
  const std::size_t count = from.size() / width;
  for (std::size_t byte = 0; byte < width; ++byte) {
    for (std::size_t k = 0; k < count; ++k) {
      to[k * width + byte] = from[byte * count + k];
    }
  }
}

Bytef* bytes_of(std::byte* bytes) { return reinterpret_cast<Bytef*>(bytes); }

/// A stream being inflated.
class Inflation {
 public:
  explicit Inflation(std::span<std::byte> to) {
    stream_.next_out = bytes_of(to.data());
    stream_.avail_out = static_cast<uInt>(to.size());
    if (inflateInit(&stream_) != Z_OK) {
      throw std::bad_alloc();
    }
  }
  ~Inflation() { inflateEnd(&stream_); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;

  /// Z_OK while it wants more, Z_STREAM_END at its end.
  int take(std::span<std::byte> bytes) {
    stream_.next_in = bytes_of(bytes.data());
    stream_.avail_in = static_cast<uInt>(bytes.size());
    return inflate(&stream_, Z_NO_FLUSH);
  }
  Index taken() const { return static_cast<Index>(stream_.total_in); }
  bool is_full() const { return stream_.avail_out == 0; }

 private:
  z_stream stream_ = {};
};

}  // namespace

Index largest_packed_size(Index bytes) {
  return static_cast<Index>(compressBound(static_cast<uLong>(bytes)));
}

std::vector<std::byte> packed(std::span<const std::byte> numbers, Index width, int level) {
  std::vector<std::byte> shuffled(numbers.size());
  shuffle(numbers, static_cast<std::size_t>(width), shuffled.data());
  std::vector<std::byte> stream(
      static_cast<std::size_t>(largest_packed_size(static_cast<Index>(numbers.size()))));
  uLongf size = stream.size();
  if (compress2(bytes_of(stream.data()), &size, bytes_of(shuffled.data()), shuffled.size(),
                level) != Z_OK) {
    throw std::bad_alloc();  // the only reason left: there is room for the largest stream
  }
  stream.resize(size);
  return stream;
}

Index unpack(const ReadPart& read, Index room, Index width, std::span<std::byte> numbers) {
  constexpr Index at_once = 1 << 16;  // bytes
  std::vector<std::byte> part, shuffled(numbers.size());
  Inflation inflation(shuffled);
  int state = Z_OK;
  for (Index done = 0; state == Z_OK && done < room;) {
    part.resize(static_cast<std::size_t>(std::min(at_once, room - done)));
    read(done, part);
    state = inflation.take(part);
    done += static_cast<Index>(part.size());
  }
  if (state != Z_STREAM_END || !inflation.is_full()) {
    return 0;
  }
  put_back(shuffled, static_cast<std::size_t>(width), numbers.data());
  return inflation.taken();
}

}  // namespace lapilli
