#pragma once

#include <string>

#include "lapilli/core/simulation.hpp"
#include "lapilli/output/runner.hpp"

namespace lapilli {

// What a run says, the same from the executable and from Python.

/// "3.2 s", "14 min", "2 h 5 min"; "?" for what is not known.
std::string readable_time(double seconds);

/// "927", "12.3 thousand", "3.84 million".
std::string readable_count(double number);

/// "t = 0.5 s, step 12, 3.84 million point-steps/s, 14 min left".
std::string progress_text(const Progress& progress);

/// How a run ended, its balances and what its user should know, a line each. `output` is the path
/// of the frames, empty when there are none.
std::string summary_text(const Simulation& simulation, const RunSummary& summary,
                         const std::string& output);

}  // namespace lapilli
