// A libFuzzer target for one reader, compiled once for each: FUZZ_READER names it.

#include <unistd.h>

#include <cstdint>

#include "feed_reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const std::filesystem::path folder = [] {
    const auto path =
        std::filesystem::temp_directory_path() / ("lapilli-fuzz-" + std::to_string(::getpid()));
    std::filesystem::create_directories(path);
    return path;
  }();
  lapilli::testing::feed(FUZZ_READER, std::string(reinterpret_cast<const char*>(bytes), size),
                         folder);
  return 0;
}
