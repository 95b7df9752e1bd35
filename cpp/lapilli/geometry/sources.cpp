#include "lapilli/geometry/sources.hpp"

#include <charconv>
#include <cmath>
#include <sstream>

#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/file_bytes.hpp"
#include "lapilli/geometry/npy_file.hpp"

namespace lapilli {
namespace {

// Collects rows and sees that all are usable.
class Rows {
 public:
  Rows(std::string path, int dimension, double volume) : path_(std::move(path)), volume_(volume) {
    points_.dimension = dimension;
  }

  // `where` is "line 7" or "row 6".
  void add(const std::vector<double>& numbers, const std::string& where) {
    const auto dimension = static_cast<std::size_t>(points_.dimension);
    require(numbers.size() == dimension || numbers.size() == dimension + 1, path_, ", ", where,
            ": a point needs ", dimension, " coordinates and perhaps a volume, got ",
            numbers.size(), numbers.size() == 1 ? " number" : " numbers");
    columns_ = columns_ == 0 ? numbers.size() : columns_;
    require(numbers.size() == columns_, path_, ", ", where, ": got ", numbers.size(),
            " numbers, the rows before have ", columns_);
    for (double number : numbers) {
      require(std::isfinite(number), path_, ", ", where, ": numbers must be finite, got ", number);
    }
    const bool has_volume = numbers.size() > dimension;
    require(has_volume || volume_ > 0.0, path_, ", ", where,
            ": the file has no column of volumes and no volume was given");
    const double volume = has_volume ? numbers.back() : volume_;
    require(volume > 0.0, path_, ", ", where, ": the volume must be positive, got ", volume);
    points_.position.insert(points_.position.end(), numbers.data(), numbers.data() + dimension);
    points_.volume.push_back(volume);
  }

  FilledPoints finish() {
    require(points_.size() > 0, path_, ": the file holds no points");
    double sum = 0.0;
    for (double volume : points_.volume) {
      sum += volume;
    }
    points_.spacing = std::pow(sum / static_cast<double>(points_.size()), 1.0 / points_.dimension);
    return std::move(points_);
  }

 private:
  std::string path_;
  double volume_;
  std::size_t columns_ = 0;
  FilledPoints points_;
};

// The numbers of a line; false if a word is none, which `word` then holds.
bool parse(std::string line, std::vector<double>& numbers, std::string& word) {
  line = line.substr(0, line.find('#'));
  for (char& letter : line) {
    if (letter == ',' || letter == ';') {
      letter = ' ';
    }
  }
  std::istringstream words(line);
  numbers.clear();
  while (words >> word) {
    const char* first = word.data() + (word.front() == '+' ? 1 : 0);
    const char* last = word.data() + word.size();
    double number = 0.0;
    const auto [end, error] = std::from_chars(first, last, number);
    if (error != std::errc() || end != last) {
      return false;
    }
    numbers.push_back(number);
  }
  return true;
}

void read_text(const std::string& path, Rows& rows) {
  std::istringstream lines(read_bytes(path));
  std::string line, word;
  std::vector<double> numbers;
  bool names_allowed = true;
  for (int number = 1; std::getline(lines, line); ++number) {
    const bool is_numbers = parse(line, numbers, word);
    const bool is_names = !is_numbers && numbers.empty() && names_allowed;
    require(is_numbers || is_names, path, ", line ", number, ": '", word, "' is no number");
    if (is_numbers && numbers.empty()) {
      continue;
    }
    names_allowed = false;
    if (is_numbers) {
      rows.add(numbers, message("line ", number));
    }
  }
}

void read_npy(const std::string& path, Rows& rows) {
  const NumberTable table = read_npy_table(path);
  for (std::size_t row = 0; row < table.rows; ++row) {
    const double* first = table.values.data() + row * table.columns;
    rows.add({first, first + table.columns}, message("row ", row));
  }
}

}  // namespace

FilledPoints read_points(const std::string& path, int dimension, double volume) {
  require(dimension >= 1 && dimension <= 3, "points have 1, 2 or 3 dimensions, got ", dimension);
  Rows rows(path, dimension, volume);
  if (path.ends_with(".npy")) {
    read_npy(path, rows);
  } else {
    read_text(path, rows);
  }
  return rows.finish();
}

FilledPoints points_of_image(const ImageMask& mask, int pixels_per_point) {
  require(pixels_per_point >= 1, "image: pixels_per_point must be at least 1, got ",
          pixels_per_point);
  mask.check(2);
  const PixelDistance& pixels = pixels_of(mask);
  FilledPoints points;
  points.dimension = 2;
  points.spacing = pixels_per_point * mask.pixel;
  for (int low = 0; low < pixels.height(); low += pixels_per_point) {
    for (int left = 0; left < pixels.width(); left += pixels_per_point) {
      int count = 0;
      Vec<2> sum = Vec<2>::Zero();
      for (int row = low; row < std::min(low + pixels_per_point, pixels.height()); ++row) {
        for (int column = left; column < std::min(left + pixels_per_point, pixels.width());
             ++column) {
          if (pixels.inside(column, row)) {
            ++count;
            sum += Vec<2>(column + 0.5, row + 0.5);
          }
        }
      }
      if (count > 0) {
        points.position.push_back(mask.origin[0] + mask.pixel * sum[0] / count);
        points.position.push_back(mask.origin[1] + mask.pixel * sum[1] / count);
        points.volume.push_back(count * mask.pixel * mask.pixel);
      }
    }
  }
  return points;
}

}  // namespace lapilli
