#pragma once

#include <functional>
#include <string>
#include <vector>

namespace lapilli {

/// The names above the columns of a text file, units in brackets with them ("x [m]").
struct ColumnNames {
  std::vector<std::string> of;
  int line = 0;
  bool is_comment = false;  // the last comment before the numbers: perhaps no names at all
};

using RowVisitor = std::function<void(const std::vector<double>&, int line)>;
using NamesVisitor = std::function<void(const ColumnNames&)>;

/// Calls visit(numbers, line) for every row of numbers in a text file: columns parted by commas,
/// semicolons, tabs or spaces, perhaps in quotes; comments from #; a byte-order mark is skipped.
/// The first row may hold names, if no word of it looks like a number; `named` is called with them,
/// or with the words of the last comment above the first row. Throws std::invalid_argument naming
/// file, line and column for a word that is no number or too large for one, and for an empty cell
/// between commas or semicolons.
void each_number_row(const std::string& path, const RowVisitor& visit,
                     const NamesVisitor& named = {});

/// The unit of a column's name: "mm" of "x [mm]" and "x (mm)", empty where there is none.
std::string unit_in(const std::string& name);

/// Two columns of a text file: times (s) that increase, and values.
struct TwoColumns {
  std::vector<double> first, second;
};

/// A text file of two columns. Throws as `each_number_row`, where a row has not two numbers, and
/// where names put the time second or give it in another unit than s.
TwoColumns read_two_columns(const std::string& path);

}  // namespace lapilli
