#include <catch2/catch.hpp>

#include "../../fuzz/feed_reader.hpp"
#include "output/scratch_folder.hpp"

using namespace lapilli;
using namespace lapilli::testing;

TEST_CASE("every file of the corpus, whole and cut, is read or refused") {
  const ScratchFolder folder;
  int fed = 0;
  for (const std::string reader : readers) {
    for (const auto& file :
         std::filesystem::directory_iterator(std::filesystem::path(LAPILLI_CORPUS) / reader)) {
      const std::string bytes = bytes_of(file.path());
      CAPTURE(file.path().string());
      const std::size_t stride = std::max<std::size_t>(1, bytes.size() / 40);
      for (std::size_t size = 0; size <= bytes.size(); size += stride) {
        REQUIRE_NOTHROW(feed(reader, bytes.substr(0, size), folder / ""));
      }
      REQUIRE_NOTHROW(feed(reader, bytes, folder / ""));
      ++fed;
    }
  }
  REQUIRE(fed >= 14);
}
