#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lapilli/geometry/number_rows.hpp"

namespace lapilli {

/// Which column of a text file of points holds what.
class PointColumns {
 public:
  /// Columns in the order x, y, z, volume, as far as there are.
  PointColumns() = default;
  /// Columns as their names say: x, y, z and volume, in any order and case, perhaps with their unit
  /// (m) in brackets. Names of which none is known stand for the usual order. Throws
  /// std::invalid_argument naming line and column for a name that is unknown beside known ones,
  /// comes twice or is missing, and for another unit.
  PointColumns(const std::string& path, int dimension, const ColumnNames& names);

  /// How many names there are; 0: there are none.
  std::size_t count() const { return count_; }
  /// The numbers of a row in the usual order.
  std::vector<double> in_order(const std::vector<double>& row) const;

 private:
  std::vector<std::size_t> place_;  // of each column in the usual order; empty: as it is
  std::size_t count_ = 0;
};

}  // namespace lapilli
