#pragma once

#include <string>
#include <vector>

namespace lapilli {

/// Heights on a regular grid, rows from the top (the largest y).
struct HeightGrid {
  int width = 0, height = 0;
  double spacing = 1.0;        // m
  double x = 0.0, y = 0.0;     // m, of the lower left height
  std::vector<double> values;  // height x width; NaN where there is none
};

/// An ESRI ASCII grid: ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize and
/// perhaps nodata_value, then the heights, which stand in the middles of the cells. Throws
/// std::invalid_argument naming file and what is missing or unusable.
HeightGrid read_esri_grid(const std::string& path);

}  // namespace lapilli
