#include "lapilli/geometry/stl_file.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/file_bytes.hpp"
#include "lapilli/geometry/weld.hpp"

namespace lapilli {
namespace {

using Corners = std::array<Vec3, 3>;

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;
// Corners this near, as a share of the size of the body, are one vertex: the single precision of
// binary files leaves 6e-8.
constexpr double weld_share = 1e-7;

std::size_t binary_count(const std::string& bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_bytes - 4, 4);
  return count;
}

std::vector<Corners> read_binary(const std::string& bytes) {
  std::vector<Corners> all(binary_count(bytes));
  for (std::size_t k = 0; k < all.size(); ++k) {
    float numbers[12];  // normal, three corners
    std::memcpy(numbers, bytes.data() + header_bytes + k * triangle_bytes, sizeof numbers);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const float* at = numbers + 3 + 3 * corner;
      all[k][corner] = Vec3(at[0], at[1], at[2]);
    }
  }
  return all;
}

std::string in_small_letters(std::string word) {
  for (char& letter : word) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return word;
}

std::vector<Corners> read_text(const std::string& bytes, const std::string& path) {
  std::vector<Corners> all;
  std::vector<Vec3> corners;
  std::istringstream lines(bytes);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    word = in_small_letters(word);
    if (word == "vertex") {
      Vec3 at;
      words >> at[0] >> at[1] >> at[2];
      require(!words.fail(), path, ":", number, ": a vertex needs three numbers: '", line, "'");
      corners.push_back(at);
    } else if (word == "endloop") {
      require(corners.size() == 3, path, ":", number, ": a facet needs three vertices, got ",
              corners.size());
      all.push_back({corners[0], corners[1], corners[2]});
      corners.clear();
    }
  }
  require(corners.empty(), path, ": the file ends within a facet");
  return all;
}

// Text that starts with "solid", whatever letters and blanks, and holds a facet.
bool is_text(const std::string& bytes) {
  std::size_t first = bytes.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0;
  while (first < bytes.size() && std::isspace(static_cast<unsigned char>(bytes[first]))) {
    ++first;
  }
  if (in_small_letters(bytes.substr(first, 5)) != "solid") {
    return false;
  }
  const std::string begin = in_small_letters(bytes.substr(first, 4096));
  return begin.find("facet") != std::string::npos && begin.find('\0') == std::string::npos;
}

double size_of(const std::vector<Corners>& triangles, const std::string& path) {
  if (triangles.empty()) {
    return 0.0;
  }
  Vec3 lower = triangles.front()[0], upper = lower;
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    for (const Vec3& corner : triangles[k]) {
      require(corner.allFinite(), path, ": a vertex of triangle ", k, " is not finite");
      lower = lower.cwiseMin(corner);
      upper = upper.cwiseMax(corner);
    }
  }
  return (upper - lower).norm();
}

}  // namespace

Triangles read_stl(const std::string& path) {
  const std::string bytes = read_bytes(path);
  const std::size_t held =
      bytes.size() < header_bytes ? 0 : (bytes.size() - header_bytes) / triangle_bytes;
  const bool has_header = bytes.size() >= header_bytes;
  const bool is_exact =
      has_header && bytes.size() == header_bytes + triangle_bytes * binary_count(bytes);
  std::vector<Corners> triangles;
  if (!is_exact && is_text(bytes)) {
    triangles = read_text(bytes, path);
  } else {
    // Some programs write more behind the triangles that they count.
    require(is_exact || (has_header && binary_count(bytes) > 0 && held >= binary_count(bytes)),
            path,
            ": not an STL file, or cut short: neither text that starts with 'solid' nor binary of "
            "the size its triangle count asks for");
    triangles = read_binary(bytes);
  }
  return welded(triangles, weld_share * size_of(triangles, path));
}

}  // namespace lapilli
