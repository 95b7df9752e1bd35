#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace lapilli {

/// The account of one conserved quantity: what was there, what was supplied, what is there now.
struct Balance {
  struct Entry {
    std::string name;  // "convection 1", "source"
    double in = 0.0;   // came in since the start; negative: went out
  };

  std::string quantity;        // "heat"
  std::string unit;            // "J"
  double initial = 0.0;        // stored at the start
  double stored = 0.0;         // stored now
  std::vector<Entry> entries;  // every way in or out
  double scale = 0.0;          // what the store spans now: capacity x range, kinetic energy
  double bar = std::numeric_limits<double>::infinity();  // a run whose residual is larger failed
  double largest = 0.0;  // the largest turnover or scale so far, kept by the simulation

  double supplied() const;
  double turnover() const;
  /// stored - initial - supplied.
  double gap() const { return stored - initial - supplied(); }
  /// The gap over the largest turnover or scale so far; a billionth of the store where hardly
  /// anything happened, whose sums are rounded.
  double residual() const;
};

/// What is wrong with the balances whose residual passes their bar, one line each; empty when all
/// close.
std::string open_balances(std::span<const Balance> balances);

}  // namespace lapilli
