#include "lapilli/output/frame_journal.hpp"

#include <bit>

#include "lapilli/output/checksum.hpp"

namespace lapilli {

Words FrameEntry::to_words() const {
  Words words = {static_cast<std::uint64_t>(frame), std::bit_cast<std::uint64_t>(time)};
  for (const Index slot : slots) {
    words.push_back(static_cast<std::uint64_t>(slot));
  }
  words.insert(words.end(), checksums.begin(), checksums.end());
  if (points) {
    words.push_back(static_cast<std::uint64_t>(*points));
  }
  words.push_back(checksum_of(words));
  return words;
}

std::optional<FrameEntry> FrameEntry::from_words(const Words& words) {
  const std::size_t columns = (words.size() - 3) / 2;
  if (words.back() != checksum_of(std::span(words).first(words.size() - 1))) {
    return std::nullopt;
  }
  FrameEntry entry{static_cast<Index>(words[0]), std::bit_cast<double>(words[1]), {}, {}};
  for (std::size_t column = 0; column < columns; ++column) {
    entry.slots.push_back(static_cast<Index>(words[2 + column]));
    entry.checksums.push_back(words[2 + columns + column]);
  }
  if (words.size() % 2 == 0) {
    entry.points = static_cast<Index>(words[2 + 2 * columns]);
  }
  return entry;
}

}  // namespace lapilli
