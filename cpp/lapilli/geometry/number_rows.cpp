#include "lapilli/geometry/number_rows.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/file_bytes.hpp"

namespace lapilli {
namespace {

std::string_view without_quotes(std::string_view word) {
  const bool quoted = word.size() >= 2 && (word.front() == '"' || word.front() == '\'') &&
                      word.back() == word.front();
  return quoted ? word.substr(1, word.size() - 2) : word;
}

std::vector<std::string> words_of(std::string line) {
  line = line.substr(0, line.find('#'));
  for (char& letter : line) {
    if (letter == ',' || letter == ';') {
      letter = ' ';
    }
  }
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.emplace_back(without_quotes(word));
  }
  return words;
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

}  // namespace

void each_number_row(const std::string& path,
                     const std::function<void(const std::vector<double>&, int line)>& visit) {
  std::string bytes = read_bytes(path);
  if (bytes.compare(0, 3, "\xEF\xBB\xBF") == 0) {
    bytes.erase(0, 3);
  }
  std::istringstream lines(std::move(bytes));
  std::vector<double> numbers;
  std::string text;
  bool names_allowed = true;
  for (int number = 1; std::getline(lines, text); ++number) {
    const std::vector<std::string> words = words_of(text);
    if (words.empty()) {
      continue;
    }
    const bool is_names = names_allowed &&
                          std::none_of(words.begin(), words.end(), looks_like_number) &&
                          std::none_of(words.begin(), words.end(), [](const std::string& word) {
                            return word == "nan" || word == "NaN" || word == "inf" || word == "Inf";
                          });
    names_allowed = false;
    if (is_names) {
      continue;
    }
    const Line line(path, number);
    numbers.clear();
    for (std::size_t column = 0; column < words.size(); ++column) {
      numbers.push_back(line.number_in(words[column], column));
    }
    visit(numbers, number);
  }
}

TwoColumns read_two_columns(const std::string& path) {
  TwoColumns columns;
  each_number_row(path, [&](const std::vector<double>& numbers, int line) {
    require(numbers.size() == 2, path, ", line ", line, ": two columns are needed, got ",
            numbers.size(), numbers.size() == 1 ? " number" : " numbers");
    require(std::isfinite(numbers[0]) && std::isfinite(numbers[1]), path, ", line ", line,
            ": numbers must be finite, got ", numbers[0], " and ", numbers[1]);
    columns.first.push_back(numbers[0]);
    columns.second.push_back(numbers[1]);
  });
  require(!columns.first.empty(), path, ": the file holds no row of numbers");
  return columns;
}

}  // namespace lapilli
