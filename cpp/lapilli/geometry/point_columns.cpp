#include "lapilli/geometry/point_columns.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr const char* axes[] = {"x", "y", "z"};

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char letter) {
    return static_cast<char>(std::tolower(letter));
  });
  return text;
}

// A name taken apart: "x [mm]", "x(mm)" and "x_mm" are x in mm.
struct Name {
  std::string word, unit;
};

Name name_of(const std::string& text) {
  std::string word = lower_case(text);
  std::string unit = unit_in(text);
  word = word.substr(0, word.find_first_of("[("));
  word.erase(word.find_last_not_of(' ') + 1);
  if (const std::size_t at = word.rfind('_'); at != word.npos && unit.empty()) {
    const std::string end = word.substr(at + 1);
    const std::string length = end.substr(0, end.find_first_of("^23"));
    if (const auto lengths = {"m", "mm", "cm", "dm", "um", "km", "in", "ft"};
        std::ranges::find(lengths, length) != lengths.end()) {
      unit = end;
      word.erase(at);
    }
  }
  return {word, unit};
}

// Where a known name belongs in the usual order: its axis, then the volume.
std::optional<std::size_t> place_of(const std::string& word) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (word == axes[axis] || word == message("x", axis + 1)) {
      return axis;
    }
  }
  return word == "volume" ? std::optional<std::size_t>(3) : std::nullopt;
}

std::string allowed_names(int dimension) {
  std::string text;
  for (int axis = 0; axis < dimension; ++axis) {
    text += message(axes[axis], ", ");
  }
  return text + "volume";
}

bool is_power_of_metre(const std::string& unit, int power) {
  const std::string superscript = power == 2 ? "\u00b2" : "\u00b3";
  return unit == message("m", power) || unit == message("m^", power) || unit == "m" + superscript;
}

bool is_unit(const std::string& unit, bool of_volume, int dimension) {
  if (unit.empty() || !of_volume || dimension == 1) {
    return unit.empty() || unit == "m";
  }
  // Of a plane body also the volume of a slice one metre thick.
  return is_power_of_metre(unit, 3) || (dimension == 2 && is_power_of_metre(unit, 2));
}

}  // namespace

PointColumns::PointColumns(const std::string& path, int dimension, const ColumnNames& names) {
  const auto axes_there = static_cast<std::size_t>(dimension);
  std::vector<std::optional<std::size_t>> known;
  for (const std::string& text : names.of) {
    known.push_back(place_of(name_of(text).word));
  }
  const auto count = std::ranges::count_if(known, [](const auto& place) { return !!place; });
  const bool all_known = count == std::ssize(known);
  if (names.is_comment && !(all_known && known.size() >= axes_there)) {
    return;  // a remark
  }
  count_ = names.of.size();
  if (count == 0) {
    return;
  }
  std::vector<bool> met(4, false);
  for (std::size_t column = 0; column < known.size(); ++column) {
    const std::string where = message(path, ", line ", names.line, ", column ", column + 1, ": ");
    const bool fits = known[column] && (*known[column] < axes_there || *known[column] == 3);
    require(fits, where, "'", names.of[column], "' is no column of points in ", dimension,
            dimension == 1 ? " dimension" : " dimensions", "; allowed are ",
            allowed_names(dimension));
    const std::size_t place = *known[column];
    require(!met[place], where, "'", names.of[column], "' comes twice");
    met[place] = true;
    const std::string unit = name_of(names.of[column]).unit;
    require(is_unit(unit, place == 3, dimension), where, "'", names.of[column], "' is in ", unit,
            "; points are given in m");
    place_.push_back(std::min(place, axes_there));
  }
  for (std::size_t axis = 0; axis < axes_there; ++axis) {
    require(met[axis], path, ", line ", names.line, ": no column is named ", axes[axis],
            "; allowed are ", allowed_names(dimension));
  }
}

std::vector<double> PointColumns::in_order(const std::vector<double>& row) const {
  if (place_.empty() || row.size() != place_.size()) {
    return row;
  }
  std::vector<double> ordered(row.size());
  for (std::size_t column = 0; column < row.size(); ++column) {
    ordered[place_[column]] = row[column];
  }
  return ordered;
}

}  // namespace lapilli
