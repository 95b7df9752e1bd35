#include <catch2/catch.hpp>
#include <cmath>

#include "lapilli/output/checkpoint.hpp"
#include "lapilli/output/file.hpp"
#include "lapilli/output/frame_index.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/output/run_files.hpp"
#include "lapilli/output/runner.hpp"
#include "output/decay.hpp"
#include "output/scratch_folder.hpp"

using namespace lapilli;
using namespace lapilli::testing;

namespace {

constexpr double end = 1.05;  // not a multiple of the interval below

RunOptions options_for(const std::filesystem::path& output) {
  RunOptions options;
  options.output = output;
  options.frame_interval = 0.1;
  options.scene_text = "[time]\nend = 1.05\n";
  return options;
}

std::function<bool()> after_steps(int steps) {
  return [steps]() mutable { return --steps == 0; };
}

/// Everything on disk that a resumed run must write alike; the record tells wall time, the slots
/// and bytes of all frames do not.
std::vector<std::string> files_of(const std::filesystem::path& output) {
  return {bytes_of(output), bytes_of(with_ending(output, ".data")),
          bytes_of(checkpoint_path(output))};
}

}  // namespace

TEST_CASE("frames come at the start, at every multiple exactly, and at the end") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  Simulation simulation = made_simulation(end);
  const RunSummary summary = run(simulation, options_for(output));
  REQUIRE(summary.status == RunStatus::finished);
  REQUIRE(simulation.time() == end);
  std::vector<double> expected;
  for (int k = 0; k <= 10; ++k) {
    expected.push_back(k * 0.1);
  }
  expected.push_back(end);
  REQUIRE(read_index(output).times == expected);
  REQUIRE(summary.frames == 12);
  REQUIRE(summary.statistics.steps == simulation.step_index());
}

TEST_CASE("an end that is a multiple but for rounding gets one frame") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  Simulation simulation = made_simulation(0.3);  // 3 * 0.1 is 0.30000000000000004
  run(simulation, options_for(output));
  REQUIRE(read_index(output).times == std::vector<double>{0.0, 0.1, 0.2, 0.3});
}

TEST_CASE("frames may come after every so many steps, or at both ends only") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  Simulation simulation = made_simulation(0.5);
  RunOptions options = options_for(output);
  options.frame_interval = 0.0;
  SECTION("steps") {
    options.frame_steps = 4;
    run(simulation, options);
    const Index steps = simulation.step_index();
    REQUIRE(read_index(output).frames() == 1 + steps / 4 + (steps % 4 != 0));
  }
  SECTION("ends") {
    run(simulation, options);
    REQUIRE(read_index(output).times == std::vector<double>{0.0, 0.5});
  }
}

TEST_CASE("a run stopped anywhere and resumed writes the same bytes as one never stopped") {
  const ScratchFolder folder;
  const auto whole = folder / "whole" / "run.vtkhdf", output = folder / "stopped" / "run.vtkhdf";
  const bool by_steps = GENERATE(false, true);
  const auto options_of = [&](const std::filesystem::path& path) {
    RunOptions options = options_for(path);
    if (by_steps) {
      options.frame_interval = 0.0;
      options.frame_steps = 3;
    }
    return options;
  };
  Simulation undisturbed = made_simulation(end);
  run(undisturbed, options_of(whole));
  const int total = static_cast<int>(undisturbed.step_index());
  REQUIRE(total > 15);
  for (int first = 1; first < total; ++first) {
    RunOptions options = options_of(output);
    options.interrupted = after_steps(first);
    Simulation begun = made_simulation(end);
    REQUIRE(run(begun, options).status == RunStatus::interrupted);
    REQUIRE(read_index(output).times.back() == begun.time());
    REQUIRE_THAT(bytes_of(record_path(output)), Catch::Contains("\"stopped\""));
    options.resume = true;
    options.interrupted = after_steps(5);  // and once more, when it is not done by then
    Simulation resumed = made_simulation(end);
    if (run(resumed, options).status == RunStatus::interrupted) {
      options.interrupted = {};
      Simulation finished = made_simulation(end);
      REQUIRE(run(finished, options).status == RunStatus::finished);
    }
    REQUIRE(files_of(output) == files_of(whole));
  }
}

TEST_CASE("a checkpoint between frames does not change the frames") {
  const ScratchFolder folder;
  const auto whole = folder / "whole" / "run.vtkhdf", output = folder / "stopped" / "run.vtkhdf";
  Simulation undisturbed = made_simulation(end);
  run(undisturbed, options_for(whole));
  RunOptions options = options_for(output);
  options.checkpoint_interval_seconds = 1e-9;  // after every step
  Simulation killed = made_simulation(end);
  int steps = 0;
  // A kill after the checkpoint of step 8, as an exception nobody expects.
  options.interrupted = [&]() -> bool {
    if (++steps == 8) {
      throw std::logic_error("killed");
    }
    return false;
  };
  REQUIRE_THROWS_AS(run(killed, options), std::logic_error);
  REQUIRE(load_checkpoint(checkpoint_path(output)).state.read_index("clock/index") == 8);
  options.interrupted = {};
  options.resume = true;
  Simulation resumed = made_simulation(end);
  run(resumed, options);
  REQUIRE(files_of(output) == files_of(whole));
}

TEST_CASE("a finished run goes on to a later end, with other frames, without its odd last frame") {
  const ScratchFolder folder;
  RunOptions options = options_for(folder / "run.vtkhdf");
  Simulation first = made_simulation(0.25);
  run(first, options);
  REQUIRE(read_index(options.output).times.back() == 0.25);
  options.resume = true;
  options.frame_interval = 0.2;
  Simulation second = made_simulation(0.7);
  run(second, options);
  REQUIRE(read_index(options.output).times ==
          std::vector<double>{0.0, 0.1, 2 * 0.1, 2 * 0.2, 3 * 0.2, 0.7});
  Simulation shorter = made_simulation(0.5);
  REQUIRE_THROWS_WITH(run(shorter, options), Catch::Contains("after the end"));
  REQUIRE(read_index(options.output).frames() == 6);
}

TEST_CASE("a failing step leaves the last good frame and checkpoint, and a record of why") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  Simulation simulation = made_simulation(end, 9);
  REQUIRE_THROWS_WITH(run(simulation, options_for(output)),
                      Catch::Contains("step 9") && Catch::Contains("point 3") &&
                          Catch::Contains("last good frame is that of time 0.3 s"));
  const FrameIndex index = read_index(output);
  REQUIRE(index.times.back() == Approx(0.3));
  REQUIRE_THAT(bytes_of(record_path(output)), Catch::Contains("\"status\": \"failed\"") &&
                                                  Catch::Contains("temperature is not finite"));
  RunOptions options = options_for(output);
  options.resume = true;
  Simulation mended = made_simulation(end);
  run(mended, options);
  Simulation undisturbed = made_simulation(end);
  run(undisturbed, options_for(folder / "whole.vtkhdf"));
  REQUIRE(read_index(output).times == read_index(folder / "whole.vtkhdf").times);
  REQUIRE(bytes_of(with_ending(output, ".data")) == bytes_of(folder / "whole.vtkhdf.data"));
}

TEST_CASE("without an output nothing is written") {
  const ScratchFolder folder;
  const auto former = std::filesystem::current_path();
  std::filesystem::current_path(folder / "");
  Simulation simulation = made_simulation(end);
  const RunSummary summary = run(simulation, {});
  const bool empty = std::filesystem::is_empty(folder / "");
  std::filesystem::current_path(former);
  REQUIRE(empty);
  REQUIRE(summary.frames == 0);
  REQUIRE(simulation.time() == end);
}

TEST_CASE("a new run removes what a former one left, its checkpoint too") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  Simulation former = made_simulation(end);
  run(former, options_for(output));
  RunOptions options = options_for(output);
  options.checkpoint = false;
  options.frame_interval = 1.0;
  Simulation simulation = made_simulation(end);
  run(simulation, options);
  REQUIRE(read_index(output).frames() == 3);
  REQUIRE_FALSE(std::filesystem::exists(checkpoint_path(output)));
}

TEST_CASE("what cannot be resumed says why") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  RunOptions options = options_for(output);
  options.resume = true;
  Simulation simulation = made_simulation(end);
  SECTION("no checkpoint") {
    REQUIRE_THROWS_WITH(run(simulation, options), Catch::Contains("run.checkpoint"));
  }
  SECTION("no output") {
    options.output.clear();
    REQUIRE_THROWS_WITH(run(simulation, options), Catch::Contains("output"));
  }
  SECTION("another scene") {
    Simulation other = made_simulation(end);
    run(other, options_for(output));
    options.scene_text = "[time]\nend = 2\n";
    REQUIRE_THROWS_WITH(run(simulation, options), Catch::Contains("another scene"));
  }
  SECTION("the frames are gone") {
    Simulation other = made_simulation(end);
    run(other, options_for(output));
    remove_frames(output);
    REQUIRE_THROWS_AS(run(simulation, options), OutputError);
  }
}

TEST_CASE("options that cannot work are refused before anything is removed") {
  const ScratchFolder folder;
  RunOptions options = options_for(folder / "run.vtk");
  put_bytes(folder / "run.checkpoint", "of somebody else");
  Simulation simulation = made_simulation(end);
  REQUIRE_THROWS_WITH(run(simulation, options), Catch::Contains(".vtkhdf"));
  REQUIRE(bytes_of(folder / "run.checkpoint") == "of somebody else");
  options.frame_interval = -0.1;
  REQUIRE_THROWS_WITH(run(simulation, options), Catch::Contains("-0.1"));
  options.frame_interval = 1e-12;
  REQUIRE_THROWS_WITH(run(simulation, options), Catch::Contains("1e8"));
  options.frame_interval = 0.1;
  options.frame_steps = 2;
  REQUIRE_THROWS_WITH(run(simulation, options), Catch::Contains("one of them"));
}

TEST_CASE("progress rises from 0 to 1 and is not told after every step") {
  std::vector<Progress> told;
  RunOptions options;
  options.progress = [&](const Progress& progress) { told.push_back(progress); };
  Simulation simulation = made_simulation(500.0);
  const RunSummary summary = run(simulation, options);
  REQUIRE(told.front().fraction == 0.0);
  REQUIRE(std::isnan(told.front().seconds_left));
  REQUIRE(told.back().fraction == 1.0);
  REQUIRE(told.back().seconds_left == 0.0);
  REQUIRE(told.back().step == summary.statistics.steps);
  REQUIRE(told.back().points == 5);
  REQUIRE(static_cast<double>(told.size()) <= 2.0 + 10.0 * summary.statistics.wall_seconds);
  REQUIRE(summary.statistics.steps > 10'000);
}
