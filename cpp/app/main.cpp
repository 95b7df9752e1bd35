#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "lapilli/core/build_info.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/scene/build.hpp"
#include "lapilli/scene/check.hpp"
#include "lapilli/scene/keys.hpp"
#include "lapilli/scene/run_scene.hpp"
#include "lapilli/scene/run_text.hpp"
#include "lapilli/scene/scene_file.hpp"
#include "lapilli/scene/schema.hpp"
#include "progress.hpp"

namespace {

using namespace lapilli;

enum ExitCode { finished = 0, run_failed = 1, wrong_input = 2, disk_failed = 3, stopped_by = 128 };

struct Arguments {
  std::string scene;
  std::string output;
  std::vector<std::string> overrides;
  double every = 0.0;
  int threads = 0;
  bool resume = false, check = false, quiet = false, keys = false;
  bool json = false, schema = false;
};

volatile std::sig_atomic_t stop_asked = 0;  // by which signal
volatile std::sig_atomic_t is_running = 0;  // before, there is nothing to lose

// The first signal asks the run to stop after its step; a second one ends the process.
void ask_to_stop(int signal) {
  if (is_running == 0) {
    constexpr char words[] = "lapilli-run: stopped before the first step\n";
    static_cast<void>(!::write(STDERR_FILENO, words, sizeof words - 1));
    ::_exit(128 + signal);
  }
  stop_asked = signal;
  std::signal(signal, SIG_DFL);
}

// A file beyond the limit is then an error of the write, which is reported like that of a full
// disk; a reader of what is printed that goes away ends no run.
void heed_signals() {
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (std::signal(signal, ask_to_stop) == SIG_IGN) {
      std::signal(signal, SIG_IGN);  // nohup, or a job in the background
    }
  }
}

// A stream that was closed would be the next file that the run opens, and take in what is said.
void open_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) {
      ::open("/dev/null", O_RDWR);  // takes the lowest number that is free
    }
  }
}

// What could not be printed is an error too: a list of keys that ends half way on a full disk. That
// nobody reads on is none.
void print(const std::string& text) {
  if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
    const int reason = errno;
    if (reason != EPIPE) {
      throw OutputError(message("cannot write to standard output: ", std::strerror(reason)));
    }
  }
}

// Threads that spin while they wait take the cores from whoever shares the machine; threads that
// sleep at once wake too late for steps of a millisecond. So they spin for a quarter of one. The
// OpenMP library reads its settings when it is loaded, so the program starts itself again with them
// set; where that is not possible it goes on as it is.
void spin_shortly(char** arguments) {
  if (std::getenv("OMP_WAIT_POLICY") == nullptr) {
    setenv("OMP_WAIT_POLICY", "passive", 0);
    setenv("GOMP_SPINCOUNT", "5000", 0);
    execv("/proc/self/exe", arguments);
  }
}

void define_arguments(CLI::App& app, Arguments& given) {
  app.add_option("scene", given.scene, "Scene file (TOML)");
  app.add_option("--output", given.output, "File of frames for ParaView (.vtkhdf)");
  app.add_option("--every", given.every, "Time between frames in s")->check(CLI::PositiveNumber);
  app.add_option("--set", given.overrides, "Set one member of the scene: grid.cell=0.05")
      ->allow_extra_args(false);
  app.add_option("--threads", given.threads, "Number of threads; as many as pay, unless given")
      ->check(CLI::Range(1, 4096));
  app.add_flag("--resume", given.resume, "Go on from the checkpoint beside the output");
  app.add_flag("--check", given.check, "Validate the scene and say what it models and costs");
  app.add_flag("--json", given.json, "With --check: as JSON");
  app.add_flag("--quiet,-q", given.quiet, "Show no progress");
  app.add_flag("--keys", given.keys, "Print every key of a scene file as Markdown");
  app.add_flag("--schema", given.schema, "Print the JSON Schema of scene files");
  app.set_version_flag("--version", version_text);
}

Scene scene_of(const Arguments& given) {
  require(!given.scene.empty(), "which scene? lapilli-run scene.toml, or --help");
  Scene scene = load_scene(given.scene);
  for (const std::string& assignment : given.overrides) {
    apply_override(scene, assignment);
  }
  const std::string beside = std::filesystem::path(given.scene).stem().string() + ".vtkhdf";
  const bool named = !given.output.empty() || !scene.output.path.empty();
  return with_output(std::move(scene), named ? given.output : beside, given.every);
}

int run_scene(const Arguments& given) {
  const Scene scene = scene_of(given);
  if (given.check) {
    const CheckReport report = check(scene);
    print(given.json ? json_of(report) : text_of(report));
    return finished;
  }
  const std::unique_ptr<Simulation> simulation = build(scene);
  ProgressLine line(given.quiet);
  RunOptions options = run_options(scene, simulation->points());
  options.resume = given.resume;
  options.progress = [&](const Progress& progress) { line.show(progress); };
  options.interrupted = options.interrupted_in_step = [] { return stop_asked != 0; };
  is_running = 1;
  const RunSummary summary = run(*simulation, options);
  line.finish();
  if (!given.quiet) {
    print(summary_text(*simulation, summary, scene.output.path));
  }
  return summary.status == RunStatus::finished ? finished : stopped_by + stop_asked;
}

int report(const std::exception& error, ExitCode code) {
  std::fprintf(stderr, "lapilli-run: %s\n", error.what());
  return code;
}

}  // namespace

int main(int count, char** words) {
  open_closed_streams();
  spin_shortly(words);
  heed_signals();
  CLI::App app("Runs a scene: heat and large deformation with particles.", "lapilli-run");
  Arguments given;
  define_arguments(app, given);
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? finished : wrong_input;
  }
  try {
    if (given.keys) {
      print(keys_as_markdown());
      return finished;
    }
    if (given.schema) {
      print(scene_schema());
      return finished;
    }
    set_thread_count(given.threads);
    return run_scene(given);
  } catch (const std::invalid_argument& error) {
    return report(error, wrong_input);
  } catch (const OutputError& error) {
    return report(error, disk_failed);
  } catch (const std::exception& error) {
    return report(error, run_failed);
  }
}
