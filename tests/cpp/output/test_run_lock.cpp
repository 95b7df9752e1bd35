#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <memory>

#include "lapilli/output/file.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/output/run_files.hpp"
#include "lapilli/output/run_lock.hpp"
#include "lapilli/output/runner.hpp"
#include "output/decay.hpp"
#include "output/scratch_folder.hpp"

using namespace lapilli;
using namespace lapilli::testing;

namespace {

RunOptions options_for(const std::filesystem::path& output) {
  RunOptions options;
  options.output = output;
  options.frame_interval = 0.1;
  options.scene_text = "[time]\nend = 1\n";
  return options;
}

int exit_code(pid_t child) {
  int status = -1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace

TEST_CASE("a second run of an output is refused, and told whose it is") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  const std::string own = std::to_string(::getpid());
  {
    const RunLock lock(output);
    REQUIRE_THROWS_WITH(RunLock(output), Catch::Contains("process " + own) &&
                                             Catch::Contains("since 20") &&
                                             Catch::Contains("run.vtkhdf.lock"));
    const pid_t child = fork();
    if (child == 0) {
      try {
        const RunLock second(output);
        _exit(1);
      } catch (const OutputError&) {
        _exit(0);
      }
    }
    REQUIRE(exit_code(child) == 0);
    REQUIRE(std::filesystem::exists(folder / "run.vtkhdf.lock"));
  }
  REQUIRE_FALSE(std::filesystem::exists(folder / "run.vtkhdf.lock"));
  REQUIRE_NOTHROW(RunLock(output));
}

TEST_CASE("the lock of a dead process is taken over, even where a child of it lives") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  int told[2], stop[2];
  REQUIRE(pipe(told) == 0);
  REQUIRE(pipe(stop) == 0);
  const pid_t owner = fork();
  if (owner == 0) {
    const RunLock* lock = new RunLock(output);  // never given up
    if (fork() == 0) {
      char byte = 0;
      ::close(stop[1]);
      _exit(static_cast<int>(::read(stop[0], &byte, 1)));  // holds the lock until told
    }
    _exit(::write(told[1], "x", 1) == 1 && lock != nullptr ? 0 : 1);
  }
  REQUIRE(exit_code(owner) == 0);
  REQUIRE(std::filesystem::exists(folder / "run.vtkhdf.lock"));
  { const RunLock taken_over(output); }
  ::close(stop[1]);
}

TEST_CASE("a lock that is held is not taken, though its file still names a dead process") {
  // So it looks while a run that begins where another was killed has yet to write its name.
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf", path = folder / "run.vtkhdf.lock";
  const pid_t dead = fork();
  if (dead == 0) {
    new RunLock(output);
    _exit(0);
  }
  REQUIRE(exit_code(dead) == 0);
  const std::string left = bytes_of(path);
  REQUIRE_THAT(left, Catch::Contains("process " + std::to_string(dead)));
  const int held = ::open(path.c_str(), O_RDWR);
  REQUIRE(::flock(held, LOCK_EX | LOCK_NB) == 0);
  REQUIRE_THROWS_WITH(RunLock(output), Catch::Contains("cannot lock"));
  REQUIRE(bytes_of(path) == left);
  ::close(held);
  REQUIRE_NOTHROW(RunLock(output));
}

TEST_CASE("a forked process that unwinds leaves its parent's lock alone") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  auto lock = std::make_unique<RunLock>(output);
  const pid_t child = fork();
  if (child == 0) {
    lock.reset();
    _exit(0);
  }
  REQUIRE(exit_code(child) == 0);
  REQUIRE(std::filesystem::exists(folder / "run.vtkhdf.lock"));
  REQUIRE_THROWS_WITH(RunLock(output), Catch::Contains("another run"));
}

TEST_CASE("a run holds its lock from its beginning to its end, a resume too") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  RunOptions options = options_for(output);
  int seen = 0;
  options.interrupted = [&] {
    Simulation other = made_simulation(1.0);
    REQUIRE_THROWS_WITH(run(other, options_for(output)), Catch::Contains("another run"));
    return ++seen == 5;
  };
  Simulation first = made_simulation(1.0);
  REQUIRE(run(first, options).status == RunStatus::interrupted);
  options.resume = true;
  Simulation second = made_simulation(1.0);
  REQUIRE(run(second, options).status == RunStatus::finished);
  REQUIRE(seen > 10);
  REQUIRE_FALSE(std::filesystem::exists(folder / "run.vtkhdf.lock"));
}

TEST_CASE("files and links of others are neither overwritten nor removed") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  const std::string name = GENERATE("run.vtkhdf", "run.vtkhdf.data", "run.json", "run.checkpoint",
                                    "run.checkpoint.previous", "run.vtkhdf.lock");
  Simulation simulation = made_simulation(1.0);
  CAPTURE(name);
  SECTION("a file") {
    put_bytes(folder / name.c_str(), "{\"mine\": 1}");
    REQUIRE_THROWS_WITH(run(simulation, options_for(output)), Catch::Contains(name));
    REQUIRE(bytes_of(folder / name.c_str()) == "{\"mine\": 1}");
  }
  SECTION("a link to one") {
    put_bytes(folder / "mine", "precious");
    std::filesystem::create_symlink(folder / "mine", folder / name.c_str());
    REQUIRE_THROWS(run(simulation, options_for(output)));
    REQUIRE(bytes_of(folder / "mine") == "precious");
    REQUIRE(std::filesystem::is_symlink(folder / name.c_str()));
  }
  SECTION("an empty folder") {
    std::filesystem::create_directory(folder / name.c_str());
    REQUIRE_THROWS(run(simulation, options_for(output)));
    REQUIRE(std::filesystem::is_directory(folder / name.c_str()));
  }
  SECTION("an empty file may be replaced") {
    put_bytes(folder / name.c_str(), "");
    REQUIRE_NOTHROW(run(simulation, options_for(output)));
  }
}

TEST_CASE("what a dead writer left unfinished is cleared away, and nothing else") {
  const ScratchFolder folder;
  const std::vector<std::string> left = {"run.vtkhdf.unfinished-12-3.tmp",
                                         "run.vtkhdf.data.unfinished-12-4.tmp",
                                         "run.json.unfinished-7-1.tmp"};
  const std::vector<std::string> mine = {
      "run.vtkhdf.tmp",         "run.vtkhdf.mine.tmp",       "other.vtkhdf.unfinished-12-3.tmp",
      "run.vtkhdf.2026.tmp",    "run.json.2026-11-30.tmp",   "run.csv.12-3.tmp",
      "run.csv.unfinished.tmp", "run.csv.unfinished-12.tmp", "run.csv.unfinished-12-3.tmp.csv"};
  for (const std::string& name : left) {
    put_bytes(folder / name.c_str(), "half");
  }
  for (const std::string& name : mine) {
    put_bytes(folder / name.c_str(), "mine");
  }
  Simulation simulation = made_simulation(1.0);
  run(simulation, options_for(folder / "run.vtkhdf"));
  for (const std::string& name : left) {
    REQUIRE_FALSE(std::filesystem::exists(folder / name.c_str()));
  }
  for (const std::string& name : mine) {
    CAPTURE(name);
    REQUIRE(std::filesystem::exists(folder / name.c_str()));
  }
}

TEST_CASE("a run writes over none of its inputs, by whatever name") {
  const ScratchFolder folder;
  const auto output = folder / "run.vtkhdf";
  Simulation simulation = made_simulation(1.0);
  run(simulation, options_for(output));
  for (const std::filesystem::path& file : files_of_run(output)) {
    CAPTURE(file);
    const std::string before = std::filesystem::exists(file) ? bytes_of(file) : "";
    RunOptions options = options_for(folder / "." / "run.vtkhdf");
    options.inputs = {file};
    options.resume = GENERATE(false, true);
    Simulation again = made_simulation(1.0);
    REQUIRE_THROWS_WITH(run(again, options), Catch::Contains(file.filename().string()));
    REQUIRE((std::filesystem::exists(file) ? bytes_of(file) : "") == before);
  }
}

TEST_CASE("a table beside a record is written over only where it is the record's") {
  const ScratchFolder folder;
  Simulation first = made_simulation(1.0), second = made_simulation(1.0);
  run(first, options_for(folder / "run.vtkhdf"));
  SECTION("its own") { REQUIRE_NOTHROW(run(second, options_for(folder / "run.vtkhdf"))); }
  SECTION("one of measurements") {
    const std::string text =
        GENERATE("x,y\nmy,measurements\n", "time,measured\n0,1\n", "time\tx\n");
    put_bytes(folder / "run.csv", text);
    REQUIRE_THROWS_WITH(run(second, options_for(folder / "run.vtkhdf")),
                        Catch::Contains("run.csv"));
    REQUIRE(bytes_of(folder / "run.csv") == text);
  }
}
