#include "lapilli/geometry/npy_file.hpp"

#include <cstdint>
#include <cstring>
#include <sstream>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/file_bytes.hpp"

namespace lapilli {
namespace {

template <class T>
void append(const std::string& bytes, std::size_t from, std::size_t count,
            std::vector<double>& values) {
  for (std::size_t k = 0; k < count; ++k) {
    T value;
    std::memcpy(&value, bytes.data() + from + k * sizeof(T), sizeof(T));
    values.push_back(static_cast<double>(value));
  }
}

// What stands in the header between `from`, after the key, and `to`; empty if there is none.
std::string entry(const std::string& header, const std::string& key, char from, char to) {
  const std::size_t at = header.find("'" + key + "':");
  const std::size_t first = at == std::string::npos ? at : header.find(from, at + key.size() + 3);
  const std::size_t last = first == std::string::npos ? first : header.find(to, first + 1);
  return last == std::string::npos ? "" : header.substr(first + 1, last - first - 1);
}

}  // namespace

NumberTable read_npy_table(const std::string& path) {
  const std::string bytes = read_bytes(path);
  require(bytes.size() > 12 && bytes.compare(0, 6, "\x93NUMPY") == 0, path,
          ": not a NumPy array file");
  const bool short_length = bytes[6] == 1;
  std::uint32_t header = 0;
  std::memcpy(&header, bytes.data() + 8, short_length ? 2 : 4);
  const std::size_t from = short_length ? 10 : 12, data = from + header;
  require(data <= bytes.size(), path, ": cut short within its header");
  const std::string text = bytes.substr(from, header);

  const std::string type = entry(text, "descr", '\'', '\'');
  require(type == "<f8" || type == "<f4", path,
          ": numbers must be float64 or float32 in little-endian order, got '", type, "'");
  std::istringstream shape(entry(text, "shape", '(', ')'));
  NumberTable table;
  char comma = ' ';
  shape >> table.rows >> comma >> table.columns;
  require(!shape.fail() && comma == ',' && shape.peek() == std::char_traits<char>::eof() &&
              text.find("'fortran_order': False") != std::string::npos,
          path, ": the array must have two dimensions in C order, got ", text);
  const std::size_t size = type == "<f8" ? 8 : 4, held = (bytes.size() - data) / size;
  require(table.columns > 0 && table.rows <= held / table.columns, path,
          ": cut short: ", table.rows, " x ", table.columns, " numbers are promised, ", held,
          " are held");
  const std::size_t count = table.rows * table.columns;
  if (size == 8) {
    append<double>(bytes, data, count, table.values);
  } else {
    append<float>(bytes, data, count, table.values);
  }
  return table;
}

}  // namespace lapilli
