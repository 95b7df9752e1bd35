#include "lapilli/geometry/file_bytes.hpp"

#include <filesystem>
#include <fstream>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{4} << 30;  // bytes

}  // namespace

std::string read_bytes(const std::string& path) {
  std::error_code error;
  require(std::filesystem::exists(path, error), path, ": there is no such file");
  require(std::filesystem::is_regular_file(path, error), path,
          ": is a folder or a device, not a file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  require(!error && size <= largest_file, path, ": has ", size,
          " bytes, more than the 4 GiB that are read");
  std::ifstream file(path, std::ios::binary);
  require(file.good(), path, ": the file cannot be opened");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(size));
  require(!file.bad(), path, ": the file cannot be read");
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

}  // namespace lapilli
