#pragma once

#include <string>
#include <utility>

namespace lapilli {

/// Keys that have another name now, by their path without indices. Nothing reads them; they are
/// here so that the error about one names its successor.
inline constexpr std::pair<const char*, const char*> renamed_keys[] = {
    {"monitors", "probes"},
};

/// The present name of a key that was renamed; empty for every other path.
inline std::string renamed(const std::string& path) {
  std::string plain;
  bool inside = false;
  for (const char letter : path) {
    inside = letter == '[' || (inside && letter != ']');
    if (!inside && letter != ']') {
      plain += letter;
    }
  }
  for (const auto& [before, now] : renamed_keys) {
    if (plain == before) {
      return now;
    }
  }
  return "";
}

}  // namespace lapilli
