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

std::uint64_t checksum_of(std::span<const std::uint64_t> words) {
  constexpr std::size_t lanes = 4;
  Checksum sums[lanes];
  std::size_t k = 0;
  for (; k + lanes <= words.size(); k += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      sums[lane].add(words[k + lane]);
    }
  }
  Checksum all;
  all.add(words.size());
  for (const Checksum& sum : sums) {
    all.add(sum.value());
  }
  for (; k < words.size(); ++k) {
    all.add(words[k]);
  }
  return all.value();
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
