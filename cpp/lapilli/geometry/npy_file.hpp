#pragma once

#include <string>
#include <vector>

namespace lapilli {

/// Numbers in rows of one length.
struct NumberTable {
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;  // rows x columns
};

/// A NumPy array of two dimensions, float64 or float32, C order (format versions 1 to 3). Throws
/// std::invalid_argument naming the file for anything else.
NumberTable read_npy_table(const std::string& path);

}  // namespace lapilli
