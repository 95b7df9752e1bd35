#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace lapilli {

/// The account of one conserved quantity: what was there, what came in, what is there now.
struct Ledger {
  struct Entry {
    std::string name;  // "convection 1", "source"
    double in = 0.0;   // came in since the start; negative: went out
  };

  std::string quantity;        // "heat"
  std::string unit;            // "J"
  double initial = 0.0;        // stored at the start
  double stored = 0.0;         // stored now
  std::vector<Entry> entries;  // every way in or out
  double scale = 0.0;          // least size the residual is compared with

  double taken_in() const {
    double sum = 0.0;
    for (const Entry& entry : entries) {
      sum += entry.in;
    }
    return sum;
  }
  double turnover() const {
    double sum = 0.0;
    for (const Entry& entry : entries) {
      sum += std::abs(entry.in);
    }
    return sum;
  }
  /// (stored - initial - taken in) over the larger of turnover and scale; 0 when nothing happened.
  double residual() const {
    const double reference = std::max(turnover(), scale);
    return reference > 0.0 ? (stored - initial - taken_in()) / reference : 0.0;
  }
};

}  // namespace lapilli
