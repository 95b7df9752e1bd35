#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/balance.hpp"

namespace lapilli {

/// What the stages of a run before the present one add to its balances and sums, so that these
/// count from the start of the run although every stage makes its physics anew.
class StageAccount {
 public:
  /// What one stage change did to one balance.
  struct Change {
    double removed = 0.0;  // stored by points that are gone
    double added = 0.0;    // stored by points that are new
    double left = 0.0;     // all else: other properties, other gravity, motion taken away
  };

  /// Close the balance of a stage: `before` as its physics had it.
  void close(const Balance& before, const std::string& next_stage, const Change& change);
  /// Keep the last value of a number that counts what happened.
  void close(const std::string& sum, double value) { sums_[sum] += value; }

  /// Make a balance of the present stage one of the run.
  void add_to(Balance& balance) const;
  /// What earlier stages add to a number that counts what happened; 0 where there were none.
  double sum(const std::string& name) const;

  void save(Archive& archive) const;
  void load(const Archive& archive);

 private:
  struct Earlier {
    double initial = 0.0;
    std::vector<Balance::Entry> entries;
  };
  std::map<std::string, Earlier> balances_;  // by quantity
  std::map<std::string, double> sums_;
};

}  // namespace lapilli
