#pragma once

#include <string>

#include "lapilli/geometry/fill.hpp"

namespace lapilli {

/// Points of a file: one a row, its coordinates and, if there is one more column, its volume.
/// Text files are read as by `each_number_row` (number_rows.hpp), their columns as their names say
/// (`PointColumns`); files ending in .npy hold a NumPy array of float64 or float32, rows x columns.
/// `volume` (m^dimension) is taken for files without volumes. The spacing is that of the mean
/// volume. Throws std::invalid_argument naming file and line (row) for what cannot be used.
FilledPoints read_points(const std::string& path, int dimension, double volume = 0.0);

/// Points in the set pixels of an image: blocks of `pixels_per_point` x `pixels_per_point` pixels,
/// counted from the image's lower left corner, give one point each at the centroid and with the
/// area of their set pixels.
FilledPoints points_of_image(const ImageMask& mask, int pixels_per_point);

}  // namespace lapilli
