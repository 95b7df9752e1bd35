#include "lapilli/output/history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/require.hpp"
#include "lapilli/output/json.hpp"

namespace lapilli {
namespace {

std::string in_csv(double number) { return std::isnan(number) ? "" : shortest(number); }

// A wall may be called "left, lower".
std::string in_csv(const std::string& name) {
  if (name.find_first_of(",\"\n") == std::string::npos) {
    return name;
  }
  std::string quoted = "\"";
  quoted += name;
  quoted += '"';
  return quoted;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

}  // namespace

void History::add(double time, std::vector<Scalar> scalars, bool keep) {
  if (!numbers_.empty()) {
    scalars = aligned(std::move(scalars));
  }
  numbers_.push_back(time);
  for (const Scalar& scalar : scalars) {
    numbers_.push_back(scalar.value);
  }
  columns_ = std::move(scalars);
  if (keep) {
    kept_ = rows();
  }
}

/// The scalars as values of all columns, in their order; new ones become the last columns.
std::vector<Scalar> History::aligned(std::vector<Scalar> scalars) {
  if (std::ranges::equal(scalars, columns_, {}, &Scalar::name, &Scalar::name)) {
    return scalars;
  }
  std::vector<Scalar> all = columns_;
  for (Scalar& column : all) {
    column.value = std::numeric_limits<double>::quiet_NaN();
  }
  for (Scalar& scalar : scalars) {
    const auto known = std::ranges::find(all, scalar.name, &Scalar::name);
    if (known == all.end()) {
      all.push_back(std::move(scalar));
    } else {
      known->value = scalar.value;
    }
  }
  widen(all.size());
  return all;
}

void History::widen(std::size_t columns) {
  std::vector<double> wide;
  for (Index row = 0; row < rows(); ++row) {
    for (std::size_t column = 0; column <= columns; ++column) {
      wide.push_back(column <= columns_.size() ? at(row, column)
                                               : std::numeric_limits<double>::quiet_NaN());
    }
  }
  numbers_ = std::move(wide);
}

std::string History::to_csv() const {
  std::string text = "time";
  for (const Scalar& column : columns_) {
    text += ',';
    text += in_csv(column.name);
  }
  for (Index row = 0; row < rows(); ++row) {
    for (std::size_t column = 0; column <= columns_.size(); ++column) {
      text += column == 0 ? '\n' : ',';
      text += in_csv(at(row, column));
    }
  }
  return text + "\n";
}

void History::save(Archive& archive, bool with_units) const {
  const std::size_t kept = static_cast<std::size_t>(kept_) * (columns_.size() + 1);
  archive.write("run/history", std::span(numbers_).first(kept));
  std::string names, units, meanings;
  for (const Scalar& column : columns_) {
    names += column.name + "\n";
    units += column.unit + "\n";
    meanings += column.meaning + "\n";
  }
  archive.write("run/history_names", names);
  if (with_units) {
    archive.write("run/history_units", units);
    archive.write("run/history_meanings", meanings);
  }
}

void History::load(const Archive& archive, std::vector<Scalar> columns) {
  const std::vector<std::string> names = lines_of(archive.read_text("run/history_names"));
  const std::vector<double> before = archive.read_numbers("run/history");
  columns_ = std::move(columns);
  if (archive.contains("run/history_units")) {
    const std::vector<std::string> units = lines_of(archive.read_text("run/history_units"));
    const std::vector<std::string> meanings = lines_of(archive.read_text("run/history_meanings"));
    columns_.clear();
    for (std::size_t k = 0; k < names.size(); ++k) {
      columns_.push_back({names[k], 0.0, units[k], meanings[k]});
    }
  }
  std::vector<std::size_t> places;
  for (const Scalar& column : columns_) {
    places.push_back(static_cast<std::size_t>(std::find(names.begin(), names.end(), column.name) -
                                              names.begin()));
  }
  numbers_.clear();
  const std::size_t width = names.size() + 1;
  for (std::size_t row = 0; row + width <= before.size(); row += width) {
    numbers_.push_back(before[row]);
    for (const std::size_t place : places) {
      numbers_.push_back(place < names.size() ? before[row + 1 + place]
                                              : std::numeric_limits<double>::quiet_NaN());
    }
  }
  kept_ = rows();
}

HistoryRecorder::HistoryRecorder(Simulation& simulation, const RunOptions& options)
    : simulation_(simulation),
      bodies_(options.bodies),
      probes_(simulation, options.probes, options.bodies),
      last_time_(simulation.time()) {
  for (const auto& [interval, steps] : options.history) {
    schedules_.push_back({interval, steps});
  }
}

std::vector<Scalar> HistoryRecorder::observe() const {
  std::vector<Scalar> all = scalars_of(simulation_, bodies_);
  const std::vector<Scalar> probed = probes_.read(simulation_);
  all.insert(all.end(), probed.begin(), probed.end());
  return all;
}

void HistoryRecorder::add(bool keep) {
  if (!history_.has_row_at(simulation_.time())) {
    history_.add(simulation_.time(), observe(), keep);
  } else if (keep) {
    history_.keep_last();
  }
}

void HistoryRecorder::after_step() {
  if (is_due()) {
    add(true);
  }
  last_time_ = simulation_.time();
}

bool HistoryRecorder::is_due() const {
  return std::any_of(schedules_.begin(), schedules_.end(), [&](const Schedule& schedule) {
    if (schedule.steps > 0) {
      return simulation_.step_index() % schedule.steps == 0;
    }
    const auto intervals = [&](double time) { return std::floor(time / schedule.interval + 1e-9); };
    return intervals(simulation_.time()) > intervals(last_time_);
  });
}

void HistoryRecorder::load(const Archive& archive) {
  history_.load(archive, observe());
  last_time_ = simulation_.time();
}

}  // namespace lapilli
