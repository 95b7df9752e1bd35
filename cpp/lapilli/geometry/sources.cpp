#include "lapilli/geometry/sources.hpp"

#include <cmath>
#include <ostream>
#include <span>

#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/npy_file.hpp"
#include "lapilli/geometry/number_rows.hpp"
#include "lapilli/geometry/point_columns.hpp"

namespace lapilli {
namespace {

// ", line 7" or ", row 6", for messages.
struct RowName {
  const char* kind;
  std::size_t number;
  friend std::ostream& operator<<(std::ostream& out, const RowName& name) {
    return out << name.kind << name.number;
  }
};

// Collects rows and sees that all are usable.
class Rows {
 public:
  Rows(std::string path, int dimension, double volume) : path_(std::move(path)), volume_(volume) {
    points_.dimension = dimension;
  }

  void add(std::span<const double> numbers, const RowName& where) {
    const auto dimension = static_cast<std::size_t>(points_.dimension);
    require(numbers.size() == dimension || numbers.size() == dimension + 1, path_, where,
            ": a point needs ", dimension, " coordinates and perhaps a volume, got ",
            numbers.size(), numbers.size() == 1 ? " number" : " numbers",
            points_.size() == 0 && numbers.size() == 1 && numbers[0] == std::floor(numbers[0])
                ? "; is it a count of rows? leave it out"
                : "");
    columns_ = columns_ == 0 ? numbers.size() : columns_;
    require(numbers.size() == columns_, path_, where, ": got ", numbers.size(),
            " numbers, the rows before have ", columns_);
    for (double number : numbers) {
      require(std::isfinite(number), path_, where, ": numbers must be finite, got ", number);
    }
    const bool has_volume = numbers.size() > dimension;
    require(has_volume || volume_ > 0.0, path_, where,
            ": the file has no column of volumes and no volume was given");
    const double volume = has_volume ? numbers.back() : volume_;
    require(volume > 0.0, path_, where, ": the volume must be positive, got ", volume);
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

void read_text(const std::string& path, int dimension, Rows& rows) {
  PointColumns columns;
  const auto add = [&](const std::vector<double>& numbers, int line) {
    require(columns.count() == 0 || numbers.size() == columns.count(), path, ", line ", line,
            ": got ", numbers.size(), numbers.size() == 1 ? " number" : " numbers",
            ", the names above are ", columns.count());
    rows.add(columns.in_order(numbers), {", line ", static_cast<std::size_t>(line)});
  };
  each_number_row(
      path, add, [&](const ColumnNames& names) { columns = PointColumns(path, dimension, names); });
}

void read_npy(const std::string& path, Rows& rows) {
  const NumberTable table = read_npy_table(path);
  for (std::size_t row = 0; row < table.rows; ++row) {
    const double* first = table.values.data() + row * table.columns;
    rows.add({first, table.columns}, {", row ", row});
  }
}

}  // namespace

FilledPoints read_points(const std::string& path, int dimension, double volume) {
  require(dimension >= 1 && dimension <= 3, "points have 1, 2 or 3 dimensions, got ", dimension);
  Rows rows(path, dimension, volume);
  if (path.ends_with(".npy")) {
    read_npy(path, rows);
  } else {
    read_text(path, dimension, rows);
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
