#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "lapilli/scene/scene_file.hpp"
#include "output/scratch_folder.hpp"
#include "scene/example_scenes.hpp"

using namespace lapilli;
using namespace lapilli::testing;
using Catch::Matchers::Contains;

namespace {

struct Outcome {
  int code = 0;
  std::string text;  // both streams
};

Outcome run_command(const std::string& arguments) {
  const std::string command = std::string(LAPILLI_RUN) + " " + arguments + " 2>&1";
  Outcome outcome;
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe);
  std::array<char, 4096> buffer;
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe)) {
    outcome.text += buffer.data();
  }
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

// Cells of twice the size where a whole number of them fits.
std::string coarser_cell(const Scene& scene) {
  for (std::size_t axis = 0; axis < scene.grid.lower.size(); ++axis) {
    const double length = scene.grid.upper[axis] - scene.grid.lower[axis];
    const double count = length / (2.0 * scene.grid.cell);
    if (std::abs(count - std::round(count)) > 1e-6) {
      return {};
    }
  }
  return message(" --set grid.cell=", 2.0 * scene.grid.cell);
}

}  // namespace

TEST_CASE("a scene is run to frames, checkpoint and record") {
  const ScratchFolder folder;
  const std::string scene = folder / "ring.toml", output = folder / "ring.vtkhdf";
  put_bytes(scene, ring_scene);
  const Outcome outcome = run_command(scene + " --output " + output + " --every 0.25 --threads 1");
  CAPTURE(outcome.text);
  CHECK(outcome.code == 0);
  CHECK_THAT(outcome.text, Contains("100 %"));
  CHECK_THAT(outcome.text, Contains("5 frames"));
  for (const char* ending : {"ring.vtkhdf", "ring.vtkhdf.data", "ring.checkpoint", "ring.json"}) {
    CHECK(std::filesystem::exists(folder / ending));
  }
  CHECK_THAT(run_command(scene + " --quiet --output " + output).text, Catch::Equals(""));
}

TEST_CASE("mistakes end with a message and code 2, nothing written") {
  const ScratchFolder folder;
  const std::string scene = folder / "ring.toml";
  put_bytes(scene, ring_scene);
  struct Mistake {
    const char *arguments, *message;
  };
  const auto mistake =
      GENERATE(Mistake{"--set grid.cel=0.1", "did you mean 'cell'?"},
               Mistake{"--set time.step=9", "is above the limit"},
               Mistake{"--set bodies.0.shape.outer=9", "reaches out of the grid"},
               Mistake{"--resume", "nothing to resume"}, Mistake{"--threads 0", "--threads"},
               Mistake{"--every -1", "--every"}, Mistake{"--wrong", "--wrong"});
  const std::string output = folder / "bad.vtkhdf";
  const Outcome outcome = run_command(scene + " --output " + output + " " + mistake.arguments);
  CHECK(outcome.code == 2);
  CHECK_THAT(outcome.text, Contains(mistake.message));
  CHECK_FALSE(std::filesystem::exists(output));
}

TEST_CASE("a disk that cannot be written ends with a message and code 3") {
  const ScratchFolder folder;
  const std::string scene = folder / "ring.toml";
  put_bytes(scene, ring_scene);
  const Outcome outcome = run_command(scene + " --output /proc/ring.vtkhdf");
  CAPTURE(outcome.text);
  CHECK(outcome.code == 3);
  CHECK_THAT(outcome.text, Contains("/proc/ring.vtkhdf"));
}

TEST_CASE("what needs no run is printed") {
  const std::string version = run_command("--version").text;
  for (const char* told : {"lapilli 0.", "compiler: ", "kernel set: ", "threads: "}) {
    CHECK_THAT(version, Contains(told));
  }
  CHECK_THAT(run_command("--keys").text, Contains("# Keys of a scene file"));
  CHECK(run_command("").code == 2);
  CHECK(run_command("/nowhere/ring.toml").code == 2);
  const ScratchFolder folder;
  put_bytes(folder / "ring.toml", ring_scene);
  const Outcome checked = run_command(std::string(folder / "ring.toml") + " --check");
  CHECK(checked.code == 0);
  CHECK_THAT(checked.text, Contains("models        heat conduction, convection"));
}

TEST_CASE("an interrupt finishes the step; a resumed run ends with the same bytes") {
  const ScratchFolder folder;
  const std::string scene = folder / "ring.toml", whole = folder / "whole.vtkhdf",
                    cut = folder / "cut.vtkhdf";
  put_bytes(scene, replaced(ring_scene, "end = 1", "end = 1\nstep = 1e-4"));
  REQUIRE(run_command(scene + " --quiet --every 0.25 --output " + whole).code == 0);
  const pid_t child = fork();
  if (child == 0) {
    execl(LAPILLI_RUN, LAPILLI_RUN, scene.c_str(), "--quiet", "--every", "0.25", "--output",
          cut.c_str(), nullptr);
    _exit(127);
  }
  while (!std::filesystem::exists(folder / "cut.checkpoint")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  // A fast machine may have finished before the signal; then there is nothing left to resume from.
  CHECK((WEXITSTATUS(status) == 130 || WEXITSTATUS(status) == 0));
  CHECK_THAT(bytes_of(folder / "cut.json"),
             Contains(WEXITSTATUS(status) == 130 ? "stopped" : "finished"));
  const Outcome resumed = run_command(scene + " --quiet --resume --every 0.25 --output " + cut);
  CAPTURE(resumed.text);
  CHECK(resumed.code == 0);
  CHECK(bytes_of(folder / "whole.vtkhdf.data") == bytes_of(folder / "cut.vtkhdf.data"));
}

TEST_CASE("every example runs when its grid is coarse") {
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(LAPILLI_EXAMPLES)) {
    if (entry.path().extension() != ".toml") {
      continue;
    }
    ++count;
    const ScratchFolder folder;
    const std::string output = folder / "coarse.vtkhdf", scene = entry.path();
    const Scene loaded = load_scene(scene);
    const Outcome outcome =
        run_command(scene + " --quiet --output " + output + " --set time.end=" +
                    (loaded.peridynamics ? "1e-3" : "0.1") + coarser_cell(loaded));
    CAPTURE(entry.path(), outcome.text);
    CHECK(outcome.code == 0);
    CHECK(std::filesystem::exists(output));
  }
  CHECK(count >= 8);
}
