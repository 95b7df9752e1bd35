#include "lapilli/core/allowed.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lapilli/core/renamed.hpp"

namespace lapilli {
namespace {

/// Fewest insertions, removals, replacements and swaps of neighbours between two words.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

}  // namespace

std::string allowed_range(const Key& key) {
  std::string words;
  if (std::isfinite(key.least) && std::isfinite(key.most)) {
    words = key.open ? message("above ", key.least, " and at most ", key.most)
                     : message("from ", key.least, " to ", key.most);
  } else if (std::isfinite(key.least)) {
    words = key.open ? message("above ", key.least) : message("at least ", key.least);
  } else if (std::isfinite(key.most)) {
    words = message("at most ", key.most);
  }
  if (!words.empty() && *key.of_unit != '\0') {
    words += message(" (", key.of_unit, ")");
  }
  return words;
}

std::string range_mistake(const Key& key, double value) {
  const bool usable = std::isfinite(value) || (key.infinity_allowed && std::isinf(value));
  if (usable && (key.open ? value > key.least : value >= key.least) && value <= key.most) {
    return "";
  }
  const std::string range = allowed_range(key);
  return message("must be ", range.empty() ? "a finite number" : range, ", got ", value);
}

void check_range(const Key& key, double value, std::string_view where) {
  const std::string mistake = range_mistake(key, value);
  require(mistake.empty(), where, where.empty() ? "" : ": ", key.name, " ", mistake);
}

std::string allowed_length(const Key& key) {
  std::string words = message(key.shortest);
  if (key.longest == std::numeric_limits<int>::max()) {
    words = message("at least ", key.shortest);
  } else if (key.longest != key.shortest) {
    words = message(key.shortest, " to ", key.longest);
  }
  const bool one = words == "1" || words == "at least 1";
  return words + (one ? " entry" : " entries");
}

void check_length(const Key& key, Index count, std::string_view where) {
  require(count >= key.shortest && count <= key.longest, where, where.empty() ? "" : ": ", key.name,
          " must hold ", allowed_length(key), ", got ", count);
}

std::string nearest_name(std::string_view given, const std::vector<std::string>& candidates) {
  if (const std::string now = new_name(given, candidates); !now.empty()) {
    return now;
  }
  std::string nearest;
  std::size_t least = std::max<std::size_t>(2, given.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(given, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string unknown_name(std::string_view what, std::string_view given,
                         const std::vector<std::string>& candidates) {
  if (const std::string now = new_name(given, candidates); !now.empty()) {
    return message("unknown ", what, " '", given, "'; it is called '", now, "' now");
  }
  const std::string nearest = nearest_name(given, candidates);
  if (!nearest.empty()) {
    return message("unknown ", what, " '", given, "'; did you mean '", nearest, "'?");
  }
  std::string all;
  for (const std::string& candidate : candidates) {
    all += (all.empty() ? "" : ", ") + candidate;
  }
  return message("unknown ", what, " '", given, "'; there is: ", all);
}

}  // namespace lapilli
