#include "lapilli/geometry/esri_grid.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include "lapilli/core/require.hpp"
#include "lapilli/geometry/file_bytes.hpp"

namespace lapilli {
namespace {

bool is_number(const std::string& word, double& number) {
  const char* first = word.data() + (word.front() == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(first, word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

class Header {
 public:
  explicit Header(const std::string& path) : path_(path) {}

  void set(const std::string& key, double value) { values_[key] = value; }
  bool has(const std::string& key) const { return values_.contains(key); }
  double at(const std::string& key) const {
    require(has(key), path_, ": ", key, " is missing in the header of the grid");
    return values_.at(key);
  }
  int count(const std::string& key) const {
    const double value = at(key);
    require(value == std::floor(value) && value >= 1.0 && value <= 100'000.0, path_, ": ", key,
            " must be 1 to 100000, got ", value);
    return static_cast<int>(value);
  }
  // The lower left height along one axis: given itself, or by the corner of its cell.
  double lower_left(const std::string& axis) const {
    const std::string center = axis + "llcenter";
    return has(center) ? at(center) : at(axis + "llcorner") + 0.5 * at("cellsize");
  }

 private:
  const std::string& path_;
  std::map<std::string, double> values_;
};

}  // namespace

HeightGrid read_esri_grid(const std::string& path) {
  std::istringstream words(read_bytes(path));
  Header header(path);
  std::string word;
  double number = 0.0;
  while (words >> word && !is_number(word, number)) {
    for (char& letter : word) {
      letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    std::string value;
    require(static_cast<bool>(words >> value) && is_number(value, number), path, ": '",
            word.substr(0, 40), "' must be followed by a number in the header of an ESRI grid");
    header.set(word, number);
  }
  HeightGrid grid;
  grid.width = header.count("ncols");
  grid.height = header.count("nrows");
  grid.spacing = header.at("cellsize");
  require(grid.spacing > 0.0, path, ": cellsize must be positive, got ", grid.spacing);
  grid.x = header.lower_left("x");
  grid.y = header.lower_left("y");
  const double gap = header.has("nodata_value") ? header.at("nodata_value") : -9999.0;
  const std::size_t count =
      static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
  while (words && grid.values.size() < count) {
    require(is_number(word, number), path, ": '", word.substr(0, 40), "' is no height, in row ",
            grid.values.size() / grid.width, ", column ", grid.values.size() % grid.width);
    grid.values.push_back(number == gap ? std::numeric_limits<double>::quiet_NaN() : number);
    words >> word;
  }
  require(grid.values.size() == count, path, ": cut short: ", grid.width, " x ", grid.height,
          " heights are promised, ", grid.values.size(), " are held");
  return grid;
}

}  // namespace lapilli
