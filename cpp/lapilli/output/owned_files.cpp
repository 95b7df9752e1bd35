#include "lapilli/output/owned_files.hpp"

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>

#include "lapilli/core/require.hpp"
#include "lapilli/output/checkpoint.hpp"
#include "lapilli/output/file.hpp"
#include "lapilli/output/file_seal.hpp"
#include "lapilli/output/hdf5_file.hpp"
#include "lapilli/output/output_error.hpp"

namespace lapilli {
namespace {

constexpr std::string_view hdf5_mark = "\x89HDF\r\n\x1a\n";
constexpr std::string_view record_mark = "{\n  \"lapilli\": ";

std::string beginning(const File& file, std::size_t bytes) {
  std::string text(std::min(bytes, static_cast<std::size_t>(file.size())), '\0');
  file.read_at(0, std::as_writable_bytes(std::span(text)));
  return text;
}

/// Frames of an earlier version have no seal.
bool has_group_of_lapilli(const std::filesystem::path& path) {
  try {
    const Hdf5Session session;
    return hdf5_exists(hdf5_open(path), "lapilli");
  } catch (const OutputError&) {
    return false;
  }
}

bool is_ours(const File& file, OwnedFile kind) {
  switch (kind) {
    case OwnedFile::frames:
      return FileSeal::find(file).has_value() ||
             (beginning(file, hdf5_mark.size()) == hdf5_mark && has_group_of_lapilli(file.path()));
    case OwnedFile::data:  // nobody else ends the name of an HDF5 file like this
      return beginning(file, hdf5_mark.size()) == hdf5_mark;
    case OwnedFile::checkpoint:
      return beginning(file, sizeof checkpoint_mark) ==
             std::string(reinterpret_cast<const char*>(&checkpoint_mark), sizeof checkpoint_mark);
    case OwnedFile::record:
      return beginning(file, record_mark.size()) == record_mark;
  }
  return false;
}

/// Without links as far as it exists.
std::filesystem::path absolute_name(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::path name = std::filesystem::weakly_canonical(path, error);
  return error ? std::filesystem::absolute(path).lexically_normal() : name;
}

/// Whether the record names every column of the table. What is quoted or escaped is not compared.
bool is_told(const std::filesystem::path& history, const std::filesystem::path& record) {
  std::ifstream table(history);
  std::string line, cell;
  if (!std::getline(table, line) || (line != "time" && !line.starts_with("time,")) ||
      line.find('"') != std::string::npos) {
    return line.starts_with("time,") && std::filesystem::exists(record);
  }
  std::ifstream file(record);
  const std::string told((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) {
    if (told.find("\n    \"" + cell + "\": [") == std::string::npos) {
      return false;
    }
  }
  return true;
}

}  // namespace

void require_replaceable(const std::filesystem::path& path, OwnedFile kind) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::symlink_status(path, ignored);
  if (!std::filesystem::exists(status)) {
    return;
  }
  require(!std::filesystem::is_symlink(status), "'", path.string(),
          "' is a link: name the file itself, lapilli would put a new file in the link's place");
  require(std::filesystem::is_regular_file(status), "'", path.string(),
          "' is a folder or a device, not a file that could be replaced");
  const File file(path, File::Mode::read);
  require(file.size() == 0 || is_ours(file, kind), "'", path.string(),
          "' was not written by lapilli: it is not overwritten; choose another output or take it "
          "away");
}

void require_replaceable_history(const std::filesystem::path& history,
                                 const std::filesystem::path& record) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::symlink_status(history, ignored);
  if (!std::filesystem::exists(status)) {
    return;
  }
  require(std::filesystem::is_regular_file(status) &&
              (std::filesystem::file_size(history, ignored) == 0 || is_told(history, record)),
          "'", history.string(),
          "' was not written by lapilli: it is not overwritten; choose another output or take it "
          "away");
}

void require_apart(const std::vector<std::filesystem::path>& written,
                   const std::vector<std::filesystem::path>& inputs) {
  for (const std::filesystem::path& input : inputs) {
    for (const std::filesystem::path& file : written) {
      std::error_code error;
      const bool same = std::filesystem::equivalent(file, input, error) ||
                        absolute_name(file) == absolute_name(input);
      require(!same, "'", input.string(),
              "' is read by this scene, and the run would write over it: choose another output");
    }
  }
}

}  // namespace lapilli
