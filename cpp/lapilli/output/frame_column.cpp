#include "lapilli/output/frame_column.hpp"

#include <bit>
#include <numeric>
#include <set>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

std::vector<int> in_order(int components) {
  std::vector<int> source(static_cast<std::size_t>(components));
  std::iota(source.begin(), source.end(), 0);
  return source;
}

std::vector<int> as_vector(int dimension) {
  std::vector<int> source = in_order(dimension);
  source.resize(3, -1);
  return source;
}

std::vector<int> stored_components(int given, int dimension) {
  if (dimension > 1 && given == dimension) {
    return as_vector(dimension);
  }
  if (dimension == 2 && given == 4) {
    return {0, 1, -1, 2, 3, -1, -1, -1, -1};
  }
  if (given == 6) {
    return {0, 3, 5, 3, 1, 4, 5, 4, 2};
  }
  return in_order(given);
}

Column point_column(const char* name, const char* unit, int components, bool is_index) {
  return {name, unit, components, is_index, true};
}

FrameColumn field_column(const Field& field, const Points& points) {
  require(field.components >= 1 &&
              static_cast<Index>(field.values.size()) == points.size() * field.components,
          "field '", field.name, "' has ", field.values.size(), " values; ", points.size(),
          " points with ", field.components, " components need ", points.size() * field.components);
  require(!field.name.empty() && field.name.find_first_of("/\n\t") == std::string::npos,
          "field name '", field.name,
          "' cannot be stored: it is empty or contains '/', tab or newline");
  std::vector<int> source = stored_components(field.components, points.dimension());
  const int components = static_cast<int>(source.size());
  return {{"PointData/" + field.name, field.unit, components, false, false},
          std::span<const double>(field.values),
          std::move(source)};
}

}  // namespace

std::vector<FrameColumn> frame_columns(const Points& points, std::span<const Field> fields) {
  static const char* const volume_units[] = {"m", "m^2", "m^3"};
  const int dimension = points.dimension();
  std::vector<FrameColumn> columns = {
      {point_column("Points", "m", 3, false), points.position(), as_vector(dimension)},
      {point_column("PointData/id", "", 1, true), points.id(), {0}},
      {point_column("PointData/body", "", 1, true), points.body(), {0}},
      {point_column("PointData/volume", volume_units[dimension - 1], 1, false),
       points.volume(),
       {0}},
  };
  for (const Field& field : fields) {
    columns.push_back(field_column(field, points));
  }
  std::set<std::string> names;
  for (const FrameColumn& entry : columns) {
    require(names.insert(entry.column.name).second, "two fields are called '",
            entry.column.name.substr(entry.column.name.find('/') + 1),
            "'; id, body and volume are always written");
  }
  return columns;
}

Words pack(const FrameColumn& column, std::span<const Index> id) {
  const std::size_t stored = column.source.size();
  Words words(id.size() * stored, 0);
  std::visit(
      [&](auto values) {
        const std::size_t given = values.size() / id.size();
        parallel_for(static_cast<Index>(id.size()), [&](Index row) {
          std::uint64_t* to = words.data() + static_cast<std::size_t>(id[row]) * stored;
          for (std::size_t k = 0; k < stored; ++k) {
            if (const int from = column.source[k]; from >= 0) {
              to[k] = std::bit_cast<std::uint64_t>(values[row * given + from]);
            }
          }
        });
      },
      column.values);
  return words;
}

}  // namespace lapilli
