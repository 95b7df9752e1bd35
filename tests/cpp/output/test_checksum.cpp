#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "lapilli/output/checksum.hpp"

using namespace lapilli;

TEST_CASE("A long sum does not depend on the pieces that words come in") {
  std::mt19937_64 draw(7);
  for (const std::size_t count : {0u, 1u, 3u, 4u, 5u, 17u, 1000u}) {
    std::vector<std::uint64_t> words(count);
    std::generate(words.begin(), words.end(), draw);
    const std::uint64_t whole = checksum_of(words);
    for (int trial = 0; trial < 20; ++trial) {
      LongChecksum sum;
      for (std::size_t begin = 0; begin < count;) {
        const std::size_t size = std::min<std::size_t>(count - begin, draw() % 9);
        sum.add(std::span(words).subspan(begin, size));
        begin += size;
      }
      CHECK(sum.value() == whole);
      CHECK(sum.words() == count);
    }
    if (count > 0) {
      words[draw() % count] ^= 1;
      CHECK(checksum_of(words) != whole);
    }
  }
}
