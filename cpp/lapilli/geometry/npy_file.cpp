#include "lapilli/geometry/npy_file.hpp"

#include <cstdint>
#include <cstring>
#include <regex>

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

  std::smatch type, shape;
  const bool has_type = std::regex_search(text, type, std::regex("'descr': *'([^']*)'"));
  const bool has_shape = std::regex_search(
      text, shape, std::regex("'shape': *\\( *([0-9]{1,15}) *, *([0-9]{1,15}) *\\)"));
  require(has_type && (type[1] == "<f8" || type[1] == "<f4"), path,
          ": numbers must be float64 or float32 in little-endian order, got '",
          has_type ? type[1].str() : "", "'");
  require(has_shape && text.find("'fortran_order': False") != std::string::npos, path,
          ": the array must have two dimensions in C order, got ", text);
  NumberTable table;
  table.rows = std::stoull(shape[1]);
  table.columns = std::stoull(shape[2]);
  const std::size_t size = type[1] == "<f8" ? 8 : 4, held = (bytes.size() - data) / size;
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
