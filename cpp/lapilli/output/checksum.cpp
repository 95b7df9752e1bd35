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

// The words may be numbers of another kind: read as bytes.
void LongChecksum::add(std::span<const std::uint64_t> words) {
  std::size_t k = 0;
  const auto next = [&] {
    std::uint64_t word = 0;
    std::memcpy(&word, words.data() + k++, sizeof word);
    return word;
  };
  const auto wait = [&] {
    while (k < words.size() && (count_ % lanes != 0 || words.size() - k < lanes)) {
      pending_[count_++ % lanes] = next();
      if (count_ % lanes == 0) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          sums_[lane].add(pending_[lane]);
        }
      }
    }
  };
  wait();
  for (; k + lanes <= words.size(); count_ += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      sums_[lane].add(next());
    }
  }
  wait();
}

std::uint64_t LongChecksum::value() const {
  Checksum all;
  all.add(count_);
  for (const Checksum& sum : sums_) {
    all.add(sum.value());
  }
  for (std::size_t lane = 0; lane < count_ % lanes; ++lane) {
    all.add(pending_[lane]);
  }
  return all.value();
}

std::uint64_t checksum_of(std::span<const std::uint64_t> words) {
  LongChecksum sum;
  sum.add(words);
  return sum.value();
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
