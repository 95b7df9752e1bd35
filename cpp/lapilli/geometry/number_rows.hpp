#pragma once

#include <functional>
#include <string>
#include <vector>

namespace lapilli {

/// Calls visit(numbers, line) for every row of numbers in a text file: columns parted by commas,
/// semicolons, tabs or spaces, perhaps in quotes; comments from #; a byte-order mark is skipped.
/// The first row may hold names, if no word of it looks like a number. Throws std::invalid_argument
/// naming file, line and column for a word that is no number or too large for one.
void each_number_row(const std::string& path,
                     const std::function<void(const std::vector<double>&, int line)>& visit);

/// Two columns of a text file: times (s) that increase, and values.
struct TwoColumns {
  std::vector<double> first, second;
};

/// A text file of two columns. Throws as `each_number_row`, and where a row has not two numbers.
TwoColumns read_two_columns(const std::string& path);

}  // namespace lapilli
