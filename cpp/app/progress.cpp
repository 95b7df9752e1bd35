#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "lapilli/scene/run_text.hpp"

namespace lapilli {
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
                 progress_text(progress).c_str());
    std::fflush(stderr);
    drawn_ = true;
  } else if (percent / 10 > tenths_shown_) {
    tenths_shown_ = percent / 10;
    std::fprintf(stderr, "%3d %%  %s\n", percent, progress_text(progress).c_str());
  }
}

void ProgressLine::finish() {
  if (drawn_) {
    std::fputc('\n', stderr);
    drawn_ = false;
  }
}

}  // namespace lapilli
