#include "lapilli/geometry/file_bytes.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "lapilli/core/require.hpp"

namespace lapilli {

std::string read_bytes(const std::string& path) {
  require(std::filesystem::is_regular_file(path), path, ": there is no such file");
  std::ifstream file(path, std::ios::binary);
  require(file.good(), path, ": the file cannot be opened");
  std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  require(!file.bad(), path, ": the file cannot be read");
  return bytes;
}

}  // namespace lapilli
