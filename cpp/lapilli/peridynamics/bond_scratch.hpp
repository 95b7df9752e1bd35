#pragma once

#include <vector>

#include "lapilli/core/large_array.hpp"
#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Numbers of the bonds of a piece of points that two phases of one step share. A thread takes for
/// the next piece what it gave back last, so that they are written where the cache still holds them
/// and never travel to memory.
class BondScratch {
 public:
  /// For `pieces` pieces, worked on by at most `threads` threads.
  void prepare(Index pieces, int threads);
  /// Memory for `size` numbers of `piece`, until it is given back.
  void take(Index piece, Index size);
  void give_back(Index piece);
  double* of(Index piece) { return taken_[static_cast<std::size_t>(piece)].data(); }

 private:
  std::vector<LargeArray<double>> taken_;               // by piece
  std::vector<std::vector<LargeArray<double>>> spare_;  // by thread
};

}  // namespace lapilli
