#include <pybind11/stl.h>

#include "bindings.hpp"
#include "convert_scene.hpp"
#include "lapilli/core/interruption.hpp"
#include "lapilli/output/output_error.hpp"
#include "lapilli/scene/audit.hpp"
#include "lapilli/scene/check.hpp"
#include "lapilli/scene/identity.hpp"
#include "lapilli/scene/keys.hpp"
#include "lapilli/scene/run_scene.hpp"
#include "lapilli/scene/run_text.hpp"
#include "lapilli/scene/schema.hpp"
#include "simulation.hpp"

namespace lapilli::python {
namespace {

/// The end of a run that Python asks for: a signal, a callback that answers False or raises, a
/// progress that raises.
class StopFromPython {
 public:
  StopFromPython(py::object simulation, py::object callback, py::object signals)
      : simulation_(std::move(simulation)),
        callback_(std::move(callback)),
        check_signals_(std::move(signals)) {}

  void tell(const py::object& progress, const Progress& now) {
    if (error_) {
      return;
    }
    try {
      const py::gil_scoped_acquire gil;
      progress(now);
    } catch (...) {
      error_ = std::current_exception();
    }
  }

  /// The same before the step has ended.
  bool by_signal() {
    try {
      if (!error_) {
        check_signals_();
      }
    } catch (...) {
      error_ = std::current_exception();
    }
    return static_cast<bool>(error_);
  }

  /// Whether to stop; errors wait for rethrow(), so that the last frame is written first.
  bool operator()() {
    if (by_signal()) {
      return true;
    }
    try {
      if (callback_.is_none()) {
        return false;
      }
      const py::gil_scoped_acquire gil;
      return callback_(simulation_).is(py::bool_(false));
    } catch (...) {
      error_ = std::current_exception();
      return true;
    }
  }
  void rethrow() const {
    if (error_) {
      std::rethrow_exception(error_);
    }
  }

 private:
  py::object simulation_, callback_;
  SignalCheck check_signals_;
  std::exception_ptr error_;
};

RunSummary run_scene(const py::object& simulation, const py::object& scene, bool resume,
                     const py::object& progress, const py::object& callback,
                     const py::object& signals) {
  auto& held = simulation.cast<PythonSimulation&>();
  RunOptions options = run_options(scene_of(scene), held.get().points());
  options.resume = resume;
  StopFromPython stop(simulation, callback, signals);
  options.interrupted = [&] { return stop(); };
  options.interrupted_in_step = [&] { return stop.by_signal(); };
  if (!progress.is_none()) {
    options.progress = [&](const Progress& now) { stop.tell(progress, now); };
  }
  Simulation& running = held.get();
  const PythonSimulation::Stepping stepping(held);
  RunSummary summary;
  {
    const py::gil_scoped_release release;
    summary = run(running, options);
  }
  stop.rethrow();
  return summary;
}

CheckReport checked_scene(const py::object& given) {
  const Scene scene = scene_of(given);
  const py::gil_scoped_release release;
  const Interruption interruption(raise_signals);
  return check(scene);
}

template <class Class, class Get>
void property(py::class_<Class>& bound, const char* owner, const char* name, const char* type,
              const char* text, Get get) {
  bound.def_property_readonly(
      name,
      py::cpp_function(get, message(name, "(self: lapilli._core.", owner, ") -> ", type).c_str()),
      text);
}

void bind_progress(py::module_& module) {
  const char* owner = "Progress";
  py::class_<Progress> bound(module, owner, "How far a run has come.");
  forbid_new(bound);
  using P = const Progress&;
  property(bound, owner, "fraction", "float", "of the time to simulate, 0 to 1",
           [](P p) { return p.fraction; });
  property(bound, owner, "time", "float", "simulated, s", [](P p) { return p.time; });
  property(bound, owner, "step_size", "float", "of the last step, s",
           [](P p) { return p.step_size; });
  property(bound, owner, "step", "int", "steps since the start", [](P p) { return p.step; });
  property(bound, owner, "points", "int", "number of points", [](P p) { return p.points; });
  property(bound, owner, "seconds_elapsed", "float", "of wall time",
           [](P p) { return p.seconds_elapsed; });
  property(bound, owner, "steps_taken", "int", "since the start or the resume",
           [](P p) { return p.steps_taken; });
  property(bound, owner, "seconds_left", "float", "of wall time, estimated; NaN while unknown",
           [](P p) { return p.seconds_left; });
}

py::dict history_of(const RunSummary& summary) {
  const History& history = summary.history;
  py::dict all;
  for (std::size_t column = 0; column <= history.columns().size(); ++column) {
    py::array_t<double> numbers(static_cast<py::ssize_t>(history.rows()));
    for (Index row = 0; row < history.rows(); ++row) {
      numbers.mutable_at(row) = history.at(row, column);
    }
    all[py::str(column == 0 ? "time" : history.columns()[column - 1].name)] = numbers;
  }
  return all;
}

py::dict columns_of(const RunSummary& summary) {
  py::dict all;
  all["time"] = py::make_tuple("s", "simulated time");
  for (const Scalar& column : summary.history.columns()) {
    all[py::str(column.name)] = py::make_tuple(column.unit, column.meaning);
  }
  return all;
}

void bind_summary(py::module_& module) {
  const char* owner = "RunSummary";
  py::class_<RunSummary> bound(module, owner, "What a run did.");
  forbid_new(bound);
  using S = const RunSummary&;
  property(bound, owner, "finished", "bool", "whether it came to its end",
           [](S s) { return s.status == RunStatus::finished; });
  property(bound, owner, "time", "float", "simulated, s", [](S s) { return s.time; });
  property(bound, owner, "frames", "int", "frames on disk", [](S s) { return s.frames; });
  property(bound, owner, "steps", "int", "steps taken since the start or the resume",
           [](S s) { return s.statistics.steps; });
  property(bound, owner, "smallest_step", "float", "s",
           [](S s) { return s.statistics.smallest_step; });
  property(bound, owner, "largest_step", "float", "s",
           [](S s) { return s.statistics.largest_step; });
  property(bound, owner, "iterations", "int", "of implicit solves",
           [](S s) { return s.statistics.iterations; });
  property(bound, owner, "wall_seconds", "float", "of wall time",
           [](S s) { return s.statistics.wall_seconds; });
  property(bound, owner, "cpu_seconds", "float", "of processor time, all threads together",
           [](S s) { return s.statistics.cpu_seconds; });
  property(bound, owner, "notes", "list[lapilli.note.Note]", "what the user should know",
           [](S s) { return notes_in_python(s.notes); });
  property(bound, owner, "history", "dict[str, numpy.typing.NDArray[numpy.float64]]",
           "what was recorded in time: the times, s, and every scalar by its name", &history_of);
  property(bound, owner, "history_columns", "dict[str, tuple[str, str]]",
           "unit and meaning of every scalar of the history", &columns_of);
  bound.def(
      "__repr__",
      [](S s) {
        return message("<", s.status == RunStatus::finished ? "finished" : "stopped", " at ",
                       s.time, " s after ", s.statistics.steps, " steps, ", s.frames, " frames>");
      },
      "__repr__(self: lapilli._core.RunSummary) -> str");
}

void bind_texts(py::module_& module) {
  module.def("readable_time", &readable_time, py::arg("seconds"),
             "readable_time(seconds: float) -> str\n\n3.2 s, 14 min, 2 h 5 min.");
  module.def("progress_text", &progress_text, py::arg("progress"),
             "progress_text(progress: Progress) -> str\n\nTime, step, speed and time left.");
  module.def(
      "summary_text",
      [](const py::object& simulation, const RunSummary& summary, const std::string& output) {
        return summary_text(simulation.cast<PythonSimulation&>().get(), summary, output);
      },
      py::arg("simulation"), py::arg("summary"), py::arg("output"),
      "summary_text(simulation: Simulation, summary: RunSummary, output: str) -> str\n\nHow a run "
      "ended, its balances and what its user should know.");
}

void bind_scene_reports(py::module_& module) {
  module.def(
      "check_text", [](const py::object& scene) { return text_of(checked_scene(scene)); },
      py::arg("scene"),
      "check_text(scene: Scene) -> str\n\nWhat a scene models and costs, as lines of text.");
  module.def(
      "check_json", [](const py::object& scene) { return json_of(checked_scene(scene)); },
      py::arg("scene"),
      "check_json(scene: Scene) -> str\n\nWhat a scene models and costs, as JSON.");
  module.def("keys_as_markdown", &keys_as_markdown, py::arg("section") = "",
             "keys_as_markdown(section: str = '') -> str\n\nThe keys of a scene file, or of one "
             "section, as Markdown tables.");
  module.def("scene_schema", &scene_schema,
             "scene_schema() -> str\n\nThe JSON Schema of scene files.");
  module.def(
      "unused_settings",
      [](const py::object& scene) { return notes_in_python(unused_settings(scene_of(scene))); },
      py::arg("scene"),
      "unused_settings(scene: Scene) -> list[lapilli.note.Note]\n\nSettings that nothing reads in "
      "this scene, with the reason.");
  module.def(
      "scene_identity",
      [](const py::object& given) {
        const Scene scene = scene_of(given);
        const SceneIdentity identity = [&] {
          const py::gil_scoped_release release;
          return identity_of(scene);
        }();
        return py::make_tuple(identity.lines, identity.not_compared);
      },
      py::arg("scene"),
      "scene_identity(scene: Scene) -> tuple[str, list[str]]\n\nWhat makes a scene the same "
      "problem, arrays and input files by their checksums; and the keys given as functions, which "
      "nothing can compare. End, output and title are left out.");
}

}  // namespace

void bind_run(py::module_& module) {
  py::register_exception<OutputError>(module, "OutputError", PyExc_OSError).doc() =
      "A file could not be written or read; the message names the file and the reason.";
  bind_progress(module);
  bind_summary(module);
  module.def(
      "run_simulation", &run_scene, py::arg("simulation"), py::arg("scene"), py::arg("resume"),
      py::arg("progress"), py::arg("callback"), py::arg("signals") = py::none(),
      "run_simulation(simulation: Simulation, scene: Scene, resume: bool, progress: "
      "collections.abc.Callable[[Progress], None] | None, callback: "
      "collections.abc.Callable[[Simulation], typing.Any] | None, signals: "
      "collections.abc.Callable[[], None] | None = None) -> RunSummary\n\nRun to the end of the "
      "scene and leave what its output section asks for. After Ctrl-C, or an error in the callback "
      "or the progress, the last frame and checkpoint are written before it is raised. `signals` "
      "is asked between steps to raise those that were held back.");
  module.def("cpu_seconds", &cpu_seconds,
             "cpu_seconds() -> float\n\nProcessor time used by this process.");
  module.def("peak_memory", &peak_memory,
             "peak_memory() -> int\n\nThe most memory this process has used, bytes.");
  bind_texts(module);
  bind_scene_reports(module);
}

}  // namespace lapilli::python
