#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lapilli {

/// A running 64-bit FNV-1a sum over whole words. Every step is a bijection of the sum, so that one
/// changed word is always noticed. Guards against damage, not against intent.
class Checksum {
 public:
  void add(std::uint64_t word) { sum_ = (sum_ ^ word) * 0x100000001b3u; }
  /// Bytes, the last word filled up with zeros.
  void add(std::span<const std::byte> bytes);
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325u;
};

/// The sum of many words, however they come: four running sums side by side, as fast as memory
/// delivers.
class LongChecksum {
 public:
  void add(std::span<const std::uint64_t> words);
  std::uint64_t value() const;
  std::uint64_t words() const { return count_; }

 private:
  static constexpr std::size_t lanes = 4;

  Checksum sums_[lanes];
  std::uint64_t pending_[lanes] = {};  // the first words of a round that is not whole
  std::uint64_t count_ = 0;
};

/// That of words which are all there.
std::uint64_t checksum_of(std::span<const std::uint64_t> words);

/// 16 hexadecimal digits that stand for a text: scenes of the same text have the same fingerprint.
std::string fingerprint(std::string_view text);

}  // namespace lapilli
