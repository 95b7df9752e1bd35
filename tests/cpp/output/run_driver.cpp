// Runs, resumes or merges a small deterministic run for tests in Python:
// run_driver run OUTPUT | resume OUTPUT | merge FROM TO. Prints how it ended, or fails with the
// reason.

#include <cstdio>
#include <exception>
#include <string>

#include "lapilli/output/merge.hpp"
#include "lapilli/output/runner.hpp"
#include "output/decay.hpp"

int main(int count, char** words) {
  using namespace lapilli;
  try {
    const std::string action = count > 2 ? words[1] : "";
    if (action == "merge" && count == 4) {
      merge(words[2], words[3]);
      return 0;
    }
    require(action == "run" || action == "resume", "unknown action '", action, "'");
    RunOptions options;
    options.output = words[2];
    options.frame_interval = 0.1;
    options.resume = action == "resume";
    options.scene_text = "[time]\nend = 0.45  # \"quoted\"\n";
    options.settings = "{\"time\": {\"end\": 0.45}}";
    Simulation simulation = testing::made_simulation(0.45);
    const RunSummary summary = run(simulation, options);
    std::puts(summary.status == RunStatus::finished ? "finished" : "stopped");
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
