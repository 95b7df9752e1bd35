#include "lapilli/geometry/stl_file.hpp"

#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/file_bytes.hpp"

namespace lapilli {
namespace {

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;

// Gives each place one number.
class Welder {
 public:
  Welder(Triangles& triangles, const std::string& path) : triangles_(triangles), path_(path) {}

  int vertex(const Vec3& at) {
    require(at.allFinite(), path_, ": a vertex of triangle ", triangles_.rows.size(),
            " is not finite");
    const auto [entry, is_new] =
        known_.try_emplace({at[0], at[1], at[2]}, static_cast<int>(triangles_.vertices.size()));
    if (is_new) {
      triangles_.vertices.push_back(at);
    }
    return entry->second;
  }

 private:
  Triangles& triangles_;
  const std::string& path_;
  std::map<std::array<double, 3>, int> known_;
};

std::size_t binary_count(const std::string& bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_bytes - 4, 4);
  return count;
}

Triangles read_binary(const std::string& bytes, const std::string& path) {
  Triangles all;
  Welder welder(all, path);
  for (std::size_t k = 0; k < binary_count(bytes); ++k) {
    float numbers[12];  // normal, three corners
    std::memcpy(numbers, bytes.data() + header_bytes + k * triangle_bytes, sizeof numbers);
    std::array<int, 3> row{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const float* at = numbers + 3 + 3 * corner;
      row[corner] = welder.vertex(Vec3(at[0], at[1], at[2]));
    }
    all.rows.push_back(row);
  }
  return all;
}

Triangles read_text(const std::string& bytes, const std::string& path) {
  Triangles all;
  Welder welder(all, path);
  std::vector<int> corners;
  std::istringstream lines(bytes);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "vertex") {
      Vec3 at;
      words >> at[0] >> at[1] >> at[2];
      require(!words.fail(), path, ":", number, ": a vertex needs three numbers: '", line, "'");
      corners.push_back(welder.vertex(at));
    } else if (word == "endloop") {
      require(corners.size() == 3, path, ":", number, ": a facet needs three vertices, got ",
              corners.size());
      all.rows.push_back({corners[0], corners[1], corners[2]});
      corners.clear();
    }
  }
  require(corners.empty(), path, ": the file ends within a facet");
  return all;
}

}  // namespace

Triangles read_stl(const std::string& path) {
  const std::string bytes = read_bytes(path);
  if (bytes.size() >= header_bytes &&
      bytes.size() == header_bytes + triangle_bytes * binary_count(bytes)) {
    return read_binary(bytes, path);
  }
  const bool is_text =
      bytes.compare(0, 5, "solid") == 0 && bytes.find("facet") != std::string::npos;
  require(
      is_text, path,
      ": not an STL file, or cut short: neither text that starts with 'solid' nor binary of the "
      "size its triangle count asks for");
  return read_text(bytes, path);
}

}  // namespace lapilli
