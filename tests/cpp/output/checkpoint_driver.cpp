// Reads a checkpoint and prints how many frames it counts, or why it cannot be read.

#include <cstdio>
#include <exception>

#include "lapilli/output/checkpoint.hpp"

int main(int count, char** words) {
  try {
    const auto checkpoint = lapilli::load_checkpoint(count > 1 ? words[1] : "");
    std::printf("%lld\n", static_cast<long long>(checkpoint.state.read_index("frames")));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
