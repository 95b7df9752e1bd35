#include "lapilli/scene/run_text.hpp"

#include <cmath>
#include <cstdio>

#include "lapilli/core/require.hpp"
#include "lapilli/core/warnings.hpp"

namespace lapilli {
namespace {

template <class... Numbers>
std::string formatted(const char* format, Numbers... numbers) {
  char text[128];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

}  // namespace

std::string readable_time(double seconds) {
  if (!std::isfinite(seconds)) {
    return "?";
  }
  if (seconds < 99.5) {
    return formatted(seconds < 9.95 ? "%.1f s" : "%.0f s", seconds);
  }
  constexpr double year = 365.25 * 86400.0;
  if (seconds > 100.0 * year) {
    return formatted("%.3g years", seconds / year);
  }
  const auto minutes = static_cast<long>(std::round(seconds / 60.0));
  return minutes < 100 ? message(minutes, " min")
                       : message(minutes / 60, " h ", minutes % 60, " min");
}

std::string readable_count(double number) {
  if (number < 999.5) {
    return formatted("%.0f", number);
  }
  return number < 999.5e3 ? formatted("%.3g thousand", number / 1e3)
                          : formatted("%.3g million", number / 1e6);
}

std::string progress_text(const Progress& progress) {
  std::string text = message(formatted("t = %.4g s", progress.time), ", step ", progress.step);
  if (progress.steps_taken > 0 && progress.seconds_elapsed > 0.0) {
    const auto work = static_cast<double>(progress.points * progress.steps_taken);
    text += message(", ", readable_count(work / progress.seconds_elapsed), " point-steps/s");
  }
  if (progress.fraction < 1.0) {
    text += message(", ", readable_time(progress.seconds_left), " left");
  }
  return text;
}

std::string summary_text(const Simulation& simulation, const RunSummary& summary,
                         const std::string& output) {
  std::string text =
      message(summary.status == RunStatus::finished ? "finished" : "stopped",
              formatted(" at %g s", summary.time), " after ", simulation.step_index(), " steps in ",
              readable_time(summary.statistics.wall_seconds));
  text += output.empty() ? "\n" : message("; ", summary.frames, " frames in ", output, "\n");
  for (const Balance& balance : simulation.balances()) {
    text += message(balance.quantity, ": ", formatted("%.6g ", balance.supplied()), balance.unit,
                    formatted(" supplied, %.6g stored at the end, residual %.1e\n", balance.stored,
                              balance.residual()));
  }
  for (const auto& physics : simulation.physics()) {
    for (const Note& warning : warnings_of(*physics)) {
      text += "warning: " + with_code(warning) + "\n";
    }
  }
  for (const Note& one : summary.notes) {
    text += "note: " + with_code(one) + "\n";
  }
  return text;
}

}  // namespace lapilli
