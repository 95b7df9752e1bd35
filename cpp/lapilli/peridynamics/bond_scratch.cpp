#include "lapilli/peridynamics/bond_scratch.hpp"

#include <utility>

#include "lapilli/core/parallel.hpp"

namespace lapilli {

void BondScratch::prepare(Index pieces, int threads) {
  taken_.resize(static_cast<std::size_t>(pieces));
  if (spare_.size() < static_cast<std::size_t>(threads)) {
    spare_.resize(static_cast<std::size_t>(threads));
  }
}

void BondScratch::take(Index piece, Index size) {
  auto& spare = spare_[static_cast<std::size_t>(thread_index())];
  auto& memory = taken_[static_cast<std::size_t>(piece)];
  if (!spare.empty()) {
    memory = std::move(spare.back());
    spare.pop_back();
  }
  if (static_cast<Index>(memory.size()) < size) {
    memory.resize(static_cast<std::size_t>(size + size / 8));
  }
}

void BondScratch::give_back(Index piece) {
  spare_[static_cast<std::size_t>(thread_index())].push_back(
      std::move(taken_[static_cast<std::size_t>(piece)]));
  taken_[static_cast<std::size_t>(piece)].clear();
}

}  // namespace lapilli
