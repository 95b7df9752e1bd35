#pragma once

#include "lapilli/core/simulation.hpp"
#include "lapilli/scene/check.hpp"

namespace lapilli {

/// Say what the later stages of a scene change and cost; a stage that cannot be made from the state
/// at the start, in which `simulation` is, is a note.
void describe_stages(const Scene& scene, Simulation& simulation, CheckReport& report);

/// Lines about the stages of a report.
std::string stages_text(const CheckReport& report);

}  // namespace lapilli
