#include "lapilli/output/run_record.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "lapilli/core/build_info.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/core/says_model.hpp"
#include "lapilli/core/snake_case.hpp"
#include "lapilli/core/warnings.hpp"
#include "lapilli/output/file.hpp"
#include "lapilli/output/json.hpp"

namespace lapilli {
namespace {

#if defined(__clang__)
constexpr const char* compiler = "clang " __VERSION__;
#else
constexpr const char* compiler = "g++ " __VERSION__;
#endif

rusage usage() {
  rusage used = {};
  getrusage(RUSAGE_SELF, &used);
  return used;
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void write_steps(JsonWriter& json, const RunStatistics& statistics, const Simulation& simulation) {
  const double rate = static_cast<double>(statistics.steps * simulation.points().size());
  const bool stepped = simulation.step_index() > 0;
  json.member("points", simulation.points().size());
  json.member("dimension", simulation.points().dimension());
  json.member("time", simulation.time());
  json.member("end", simulation.end());
  json.member("steps", simulation.step_index());
  if (!simulation.later_stages().empty()) {
    json.member("stage", simulation.stage_name());
  }
  json.member("steps_since_resume", statistics.steps);
  json.member("smallest_step", stepped ? statistics.smallest_step : 0.0);
  json.member("largest_step", statistics.largest_step);
  json.member("iterations", statistics.iterations);
  json.member("largest_residual", statistics.largest_residual);
  json.member("wall_seconds", statistics.wall_seconds);
  json.member("cpu_seconds", statistics.cpu_seconds);
  json.member("point_steps_per_second",
              statistics.wall_seconds > 0.0 ? rate / statistics.wall_seconds : 0.0);
  json.member("peak_memory_bytes", peak_memory());
}

void write_notes(JsonWriter& json, const char* texts, const char* codes,
                 const std::vector<Note>& notes) {
  json.key(texts).begin_array();
  for (const Note& one : notes) {
    json.value(one.text);
  }
  json.end_array();
  json.key(codes).begin_array();
  for (const Note& one : notes) {
    json.value(std::string(one.code.text()));
  }
  json.end_array();
}

void write_texts(JsonWriter& json, const char* name, const std::vector<std::string>& texts) {
  json.key(name).begin_array();
  for (const std::string& text : texts) {
    json.value(text);
  }
  json.end_array();
}

void write_balance(JsonWriter& json, const Balance& balance) {
  json.begin_object();
  json.member("quantity", balance.quantity);
  json.member("unit", balance.unit);
  json.member("initial", balance.initial);
  json.member("stored", balance.stored);
  json.key("entries").begin_array();
  for (const Balance::Entry& entry : balance.entries) {
    json.begin_object();
    json.member("name", entry.name);
    json.member("in", entry.in);
    json.end_object();
  }
  json.end_array();
  json.member("supplied", balance.supplied());
  json.member("residual", balance.residual());
  json.end_object();
}

void write_body(JsonWriter& json, const BodyVolume& body) {
  json.begin_object();
  json.member("name", body.name);
  json.member("points", body.points);
  json.member("volume", body.volume);
  if (body.of_shape) {
    json.member("volume_of_shape", *body.of_shape);
  }
  json.end_object();
}

void write_physics(JsonWriter& json, const Physics& physics, const StageAccount& earlier) {
  json.begin_object();
  json.member("name", physics.name());
  json.key("balances").begin_array();
  for (Balance& balance : physics.balances()) {
    earlier.add_to(balance);
    write_balance(json, balance);
  }
  json.end_array();
  json.key("diagnostics").begin_object();
  for (const auto& [name, value] : physics.diagnostics()) {
    json.member(snake_case(name), value + earlier.sum(physics.name() + "/" + name));
  }
  json.end_object();
  write_notes(json, "warnings", "warning_codes", warnings_of(physics));
  json.key("modelled").begin_array();
  if (const auto* chooser = dynamic_cast<const SaysModel*>(&physics)) {
    for (const std::string& choice : chooser->modelled()) {
      json.value(choice);
    }
  }
  json.end_array();
  json.end_object();
}

void write_history(JsonWriter& json, const History& history) {
  json.key("history").begin_object();
  for (std::size_t column = 0; column <= history.columns().size(); ++column) {
    json.key(column == 0 ? "time" : history.columns()[column - 1].name).begin_array();
    for (Index row = 0; row < history.rows(); ++row) {
      json.value(history.at(row, column));
    }
    json.end_array();
  }
  json.end_object();
  json.key("history_columns").begin_array();
  for (const Scalar& column : history.columns()) {
    json.begin_object();
    json.member("name", column.name);
    json.member("unit", column.unit);
    json.member("meaning", column.meaning);
    json.end_object();
  }
  json.end_array();
}

}  // namespace

void RunStatistics::count(const StepReport& report) {
  ++steps;
  smallest_step = std::min(smallest_step, report.accepted);
  largest_step = std::max(largest_step, report.accepted);
  iterations += report.iterations;
  largest_residual = std::max(largest_residual, report.residual);
}

void RunStatistics::save(Archive& archive) const {
  archive.write("run/smallest_step", smallest_step);
  archive.write("run/largest_step", largest_step);
  archive.write("run/iterations", iterations);
  archive.write("run/largest_residual", largest_residual);
}

void RunStatistics::load(const Archive& archive) {
  smallest_step = archive.read_number("run/smallest_step");
  largest_step = archive.read_number("run/largest_step");
  iterations = archive.read_index("run/iterations");
  largest_residual = archive.read_number("run/largest_residual");
}

void write_run_record(const std::filesystem::path& path, const RunRecord& record,
                      const History& history, const Simulation& simulation) {
  JsonWriter json;
  json.begin_object();
  json.member("lapilli", LAPILLI_VERSION);
  json.member("status", record.status);
  json.member("message", record.message);
  write_notes(json, "notes", "note_codes", record.notes);
  write_texts(json, "not_compared", record.not_compared);
  json.member("started", record.started);
  json.member("written", utc_now());
  json.member("compiler", compiler);
  json.member("kernel_set", build_info().kernel_set);
  json.member("threads", thread_count());
  json.member("frames_file", record.frames_file);
  json.member("frames", record.frames);
  write_steps(json, record.statistics, simulation);
  json.key("physics").begin_array();
  for (const auto& physics : simulation.physics()) {
    write_physics(json, *physics, simulation.account());
  }
  json.end_array();
  json.key("bodies").begin_array();
  for (const BodyVolume& body : record.volumes) {
    write_body(json, body);
  }
  json.end_array();
  write_history(json, history);
  json.member("fingerprint", record.fingerprint);
  json.key("settings").json(record.settings.empty() ? "null" : record.settings);
  json.member("scene", record.scene_text);
  json.end_object();
  write_text(path, json.text() + "\n");
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts = {};
  gmtime_r(&now, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

double cpu_seconds() {
  const rusage used = usage();
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

Index peak_memory() { return Index{1024} * usage().ru_maxrss; }

}  // namespace lapilli
