#include "lapilli/geometry/number_rows.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/file_bytes.hpp"

namespace lapilli {
namespace {

std::string_view without_quotes(std::string_view word) {
  const bool quoted = word.size() >= 2 && (word.front() == '"' || word.front() == '\'') &&
                      word.back() == word.front();
  return quoted ? word.substr(1, word.size() - 2) : word;
}

bool is_separator(char letter) { return letter == ',' || letter == ';'; }

// The cells of a line, parted by commas or semicolons; one where there are none.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (const char letter : line) {
    if (is_separator(letter)) {
      cells.emplace_back();
    } else {
      cells.back() += letter;
    }
  }
  return cells;
}

std::vector<std::string> words_of(const std::string& cell) {
  std::istringstream stream(cell);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.emplace_back(without_quotes(word));
  }
  return words;
}

std::vector<std::string> all_words_of(const std::vector<std::string>& cells) {
  std::vector<std::string> words;
  for (const std::string& cell : cells) {
    std::ranges::move(words_of(cell), std::back_inserter(words));
  }
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

// "x [m], y [m]" and "x [m] y [m]": a unit in brackets belongs to the name before it.
std::vector<std::string> names_in(const std::string& line) {
  const std::vector<std::string> cells = cells_of(line);
  std::vector<std::string> names;
  if (cells.size() > 1) {
    for (const std::string& cell : cells) {
      std::string name = joined(words_of(cell));
      names.emplace_back(without_quotes(name));
    }
    return names;
  }
  for (const std::string& word : words_of(line)) {
    const bool is_unit = !names.empty() && (word.front() == '[' || word.front() == '(');
    if (is_unit) {
      names.back() += ' ' + word;
    } else {
      names.push_back(word);
    }
  }
  return names;
}

// Also words that are numbers but for a slip: O.5, 1.0D-2, l0.
bool looks_like_number(const std::string& word) {
  const auto is_digit = [](char letter) {
    return std::isdigit(static_cast<unsigned char>(letter));
  };
  if (std::none_of(word.begin(), word.end(), is_digit)) {
    return false;
  }
  const bool starts_so = is_digit(word[0]) || std::string_view("+-.").find(word[0]) != word.npos;
  return starts_so || std::all_of(word.begin(), word.end(), [&](char letter) {
           return is_digit(letter) || std::string_view("+-.eEdDoOlI").find(letter) != word.npos;
         });
}

bool has_fortran_exponent(const std::string& word) {
  const std::size_t at = word.find_first_of("dD");
  return at != word.npos && at > 0 && std::isdigit(static_cast<unsigned char>(word[at - 1]));
}

class Line {
 public:
  Line(const std::string& path, int number) : path_(path), number_(number) {}

  double number_in(const std::string& word, std::size_t column) const {
    const char* first = word.data() + (word.front() == '+' ? 1 : 0);
    const char* last = word.data() + word.size();
    double number = 0.0;
    const auto [end, error] = std::from_chars(first, last, number);
    if (error == std::errc::result_out_of_range && end == last) {
      require(false, path_, ", line ", number_, ", column ", column + 1, ": '", word,
              "' is too large or too small for a number");
    }
    if (error != std::errc() || end != last) {
      require(false, path_, ", line ", number_, ", column ", column + 1, ": '", word,
              "' is no number", has_fortran_exponent(word) ? "; write the exponent with e" : "");
    }
    return number;
  }

 private:
  const std::string& path_;
  int number_;
};

// What a line says, and what its comment does.
std::pair<std::string, std::string> parted_at_comment(const std::string& line) {
  const std::size_t at = line.find('#');
  const std::size_t begin = at == line.npos ? at : line.find_first_not_of('#', at);
  return {line.substr(0, at), begin == line.npos ? "" : line.substr(begin)};
}

bool is_row_of_names(const std::vector<std::string>& words) {
  return std::ranges::none_of(words, looks_like_number) &&
         std::ranges::none_of(words, [](const std::string& word) {
           return word == "nan" || word == "NaN" || word == "inf" || word == "Inf";
         });
}

void require_no_gap(const std::string& path, int line, const std::vector<std::string>& cells) {
  for (std::size_t column = 0; column < cells.size(); ++column) {
    require(!words_of(cells[column]).empty(), path, ", line ", line, ", column ", column + 1,
            ": the cell is empty");
  }
}

}  // namespace

void each_number_row(const std::string& path, const RowVisitor& visit, const NamesVisitor& named) {
  std::string bytes = read_bytes(path);
  if (bytes.compare(0, 3, "\xEF\xBB\xBF") == 0) {
    bytes.erase(0, 3);
  }
  std::istringstream lines(std::move(bytes));
  std::vector<double> numbers;
  ColumnNames names;
  bool is_first = true;
  std::string text;
  for (int number = 1; std::getline(lines, text); ++number) {
    const auto [content, remark] = parted_at_comment(text);
    const std::vector<std::string> cells = cells_of(content);
    const std::vector<std::string> words = all_words_of(cells);
    if (words.empty()) {
      if (is_first && !remark.empty()) {
        names = {names_in(remark), number, true};
      }
      continue;
    }
    if (is_first && is_row_of_names(words)) {
      names = {names_in(content), number, false};
    }
    if (is_first && named && names.line > 0) {
      named(names);
    }
    if (std::exchange(is_first, false) && names.line == number) {
      continue;
    }
    require_no_gap(path, number, cells);
    const Line line(path, number);
    numbers.clear();
    for (std::size_t column = 0; column < words.size(); ++column) {
      numbers.push_back(line.number_in(words[column], column));
    }
    visit(numbers, number);
  }
}

namespace {

void require_time_first(const std::string& path, const ColumnNames& names) {
  const auto is_time = [](const std::string& name) {
    return name == "t" || name == "time" || name == "Time" || name.starts_with("time [") ||
           name.starts_with("Time [") || name.starts_with("time (") || name.starts_with("Time (");
  };
  if (names.of.size() != 2) {
    return;
  }
  require(!is_time(names.of[1]), path, ", line ", names.line,
          ", column 2: times belong into the first column, it is named '", names.of[0], "'");
  const std::string unit = unit_in(names.of[0]);
  require(!is_time(names.of[0]) || unit.empty() || unit == "s", path, ", line ", names.line,
          ", column 1: times are in s, not in ", unit);
}

}  // namespace

std::string unit_in(const std::string& name) {
  const std::size_t begin = name.find_first_of("[("), end = name.find_last_of("])");
  return begin == name.npos || end == name.npos || end < begin
             ? ""
             : name.substr(begin + 1, end - begin - 1);
}

TwoColumns read_two_columns(const std::string& path) {
  TwoColumns columns;
  const auto add = [&](const std::vector<double>& numbers, int line) {
    require(numbers.size() == 2, path, ", line ", line, ": two columns are needed, got ",
            numbers.size(), numbers.size() == 1 ? " number" : " numbers");
    require(std::isfinite(numbers[0]) && std::isfinite(numbers[1]), path, ", line ", line,
            ": numbers must be finite, got ", numbers[0], " and ", numbers[1]);
    columns.first.push_back(numbers[0]);
    columns.second.push_back(numbers[1]);
  };
  each_number_row(path, add, [&](const ColumnNames& names) { require_time_first(path, names); });
  require(!columns.first.empty(), path, ": the file holds no row of numbers");
  return columns;
}

}  // namespace lapilli
