#pragma once

#include <string>
#include <vector>

#include "lapilli/core/simulation.hpp"

namespace lapilli {

/// One number that is recorded in time.
struct Scalar {
  std::string name;     // "dynamics/kinetic_energy": letters, digits, _ and one slash
  double value = 0.0;   //
  std::string unit;     // per metre of depth in two dimensions, per square metre in one
  std::string meaning;  // one sentence
};

/// Whether a diagnostic of a physics is a sum since the start.
bool counts_what_happened(const std::string& words);

/// The diagnostics of every physics, of the state that fields() shows.
std::vector<Scalar> diagnostics_of(Simulation& simulation);

/// All that is recorded in time: diagnostics, energy and mass balances ("heat/supplied_by_inflow"),
/// the smallest and largest value of every field over the points of the first `bodies` bodies
/// (their size for vectors and tensors), and how far the points reach where they move.
std::vector<Scalar> scalars_of(Simulation& simulation, int bodies);

/// What is recorded, as rows of a Markdown table: name, unit, meaning.
std::string diagnostics_as_markdown();

}  // namespace lapilli
