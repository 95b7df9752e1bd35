#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

std::string in_words(const Progress& progress) {
  std::string text = message("time ", progress.time, " s, step ", progress.step);
  if (progress.step > 0) {
    text += message(", size ", progress.step_size, " s");
  }
  if (std::isfinite(progress.seconds_left) && progress.fraction < 1.0) {
    text += ", " + readable_time(progress.seconds_left) + " left";
  }
  return text;
}

}  // namespace

std::string readable_time(double seconds) {
  if (seconds < 100.0) {
    return message(std::round(seconds * 10.0) / 10.0, " s");
  }
  const auto minutes = static_cast<long>(std::round(seconds / 60.0));
  return minutes < 100 ? message(minutes, " min")
                       : message(minutes / 60, " h ", minutes % 60, " min");
}

ProgressLine::ProgressLine(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(const Progress& progress) {
  if (quiet_) {
    return;
  }
  const int percent = static_cast<int>(100.0 * progress.fraction);
  if (terminal_) {
    constexpr int width = 30;
    const int filled = std::clamp(static_cast<int>(width * progress.fraction), 0, width);
    const std::string bar = std::string(static_cast<std::size_t>(filled), '=') +
                            std::string(static_cast<std::size_t>(width - filled), ' ');
    std::fprintf(stderr, "\r[%s] %3d %%  %s\033[K", bar.c_str(), percent,
                 in_words(progress).c_str());
    std::fflush(stderr);
    drawn_ = true;
  } else if (percent / 10 > tenths_shown_) {
    tenths_shown_ = percent / 10;
    std::fprintf(stderr, "%3d %%  %s\n", percent, in_words(progress).c_str());
  }
}

void ProgressLine::finish() {
  if (drawn_) {
    std::fputc('\n', stderr);
    drawn_ = false;
  }
}

}  // namespace lapilli
