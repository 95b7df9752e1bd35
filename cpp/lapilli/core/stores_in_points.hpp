#pragma once

#include <span>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// A physics that knows what single points add to the stores of its balances.
class StoresInPoints {
 public:
  virtual ~StoresInPoints() = default;

  /// Of each balance, in their order, what the points in these rows store.
  virtual std::vector<double> stored_in(std::span<const Index> rows) const = 0;
};

}  // namespace lapilli
