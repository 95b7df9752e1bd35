#pragma once

#include <span>
#include <string>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/balance.hpp"
#include "lapilli/mpm/heat/heat_settings.hpp"

namespace lapilli {

/// Heat that each boundary condition has brought in since the start, J, with what rounding drops
/// (Neumaier 1974).
class ConditionAccount {
 public:
  explicit ConditionAccount(std::size_t conditions) : sums_(conditions) {}

  void book(std::size_t condition, double heat);
  /// Book `heat` by condition, and what it leaves of the `total` with the largest: what rounding
  /// and solvers leave.
  void book(std::span<const double> heat, double total);

  /// Go on as far again beyond `coarse`, both from one start: Richardson's extrapolation.
  void extrapolate(const ConditionAccount& coarse);

  std::vector<Balance::Entry> entries(std::span<const HeatBoundary> conditions) const;
  void save(Archive& archive, const std::string& name) const;
  void load(const Archive& archive, const std::string& name);

 private:
  struct Sum {
    double sum = 0.0, dropped = 0.0;
  };

  std::vector<Sum> sums_;
};

}  // namespace lapilli
