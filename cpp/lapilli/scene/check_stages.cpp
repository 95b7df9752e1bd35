#include "lapilli/scene/check_stages.hpp"

#include <cmath>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/stage_scenes.hpp"
#include "lapilli/scene/tree_reader.hpp"

namespace lapilli {
namespace {

std::shared_ptr<const Archive> state_of(const Simulation& simulation) {
  auto state = std::make_shared<Archive>();
  simulation.save(*state);
  state->write("stage/created", simulation.points().created());
  return state;
}

}  // namespace

void describe_stages(const Scene& scene, Simulation& simulation, CheckReport& report) {
  const std::vector<StageScene> stages = stage_scenes(with_resolved_files(scene));
  std::shared_ptr<const Archive> state = stages.size() > 1 ? state_of(simulation) : nullptr;
  for (std::size_t k = 1; k < stages.size(); ++k) {
    const StageScene& stage = stages[k];
    CheckReport::StageReport one{stage.name, stage.start, stage.scene.time.end, 0,
                                 0.0,        0,           stage.changes};
    const Simulation::Stage& follows = simulation.later_stages()[k - 1];
    try {
      Simulation::Stage::Parts parts = state ? follows.begin(state) : Simulation::Stage::Parts();
      if (parts.points) {
        const Simulation trial(std::move(parts.points), std::move(parts.physics), follows.clock);
        one.points = trial.points().size();
        one.step = trial.next_step_size();
        one.steps = static_cast<Index>(std::ceil((one.end - one.start) / one.step * (1.0 - 1e-9)));
        state = state_of(trial);
      }
    } catch (const std::invalid_argument& error) {
      report.notes.push_back(note("stages.cannot-begin", "stage ", stage.name,
                                  " cannot begin from the start of the run (it may from where "
                                  "the stage before ends): ",
                                  error.what()));
      state.reset();  // nor can what follows it be made
    }
    report.stages.push_back(std::move(one));
  }
}

std::string stages_text(const CheckReport& report) {
  std::string text;
  for (const CheckReport::StageReport& stage : report.stages) {
    text += message("stage         ", stage.name, ": ", stage.start, " to ", stage.end, " s");
    if (stage.steps > 0) {
      text += message(", ", stage.points, " points, about ", stage.steps, " steps of ", stage.step,
                      " s");
    }
    text += (stage.changes.empty() ? "" : "; ") + joined(stage.changes) + "\n";
  }
  return text;
}

}  // namespace lapilli
