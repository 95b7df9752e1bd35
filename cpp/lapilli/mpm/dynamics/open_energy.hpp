#pragma once

#include <string>
#include <vector>

#include "lapilli/core/balance.hpp"
#include "lapilli/core/note.hpp"
#include "lapilli/core/vector.hpp"

namespace lapilli {

/// What the account of energy leaves open, looked at now and then: a run that loses or makes energy
/// without a name says so, one whose motion gains what nobody put in, and one whose solids strain
/// so far that what they store is no more the energy of their law.
class OpenEnergy {
 public:
  /// Whether to look in this step: in the 16th, then in one of 64 (in each of 16 it took 2 %).
  bool is_due() { return ++steps_ == 16 || steps_ % 64 == 0; }
  /// `largest`: J, the largest energy so far. `strain`: elastic, where the energy is. `gained`: J,
  /// that nobody put in.
  void look(const Balance& energy, double largest, double strain, double gained);
  /// Whether a run has been looked at while there was energy.
  bool has_looked() const { return reference_ > 0.0; }
  std::vector<Note> warnings() const;

  std::vector<double> numbers() const {
    return {gap_, reference_, strain_, static_cast<double>(steps_), gained_, largest_};
  }
  void restore(const std::vector<double>& numbers);

 private:
  double gap_ = 0.0, reference_ = 0.0;   // J, largest so far
  double strain_ = 0.0;                  // largest so far
  double gained_ = 0.0, largest_ = 0.0;  // J, the same
  Index steps_ = 0;                      // that asked
};

}  // namespace lapilli
