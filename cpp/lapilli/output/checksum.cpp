#include "lapilli/output/checksum.hpp"

#include <algorithm>
#include <cstring>

namespace lapilli {

void Checksum::add(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::size_t size = std::min(bytes.size(), sizeof word);
    std::memcpy(&word, bytes.data(), size);
    add(word);
    bytes = bytes.subspan(size);
  }
}

std::string fingerprint(std::string_view text) {
  Checksum sum;
  sum.add(text.size());
  sum.add(std::as_bytes(std::span(text)));
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) {
    digits += "0123456789abcdef"[(sum.value() >> shift) & 15];
  }
  return digits;
}

}  // namespace lapilli
