#include "lapilli/output/frame_column.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <set>
#include <type_traits>

#include "lapilli/core/allowed.hpp"
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
  return {name, unit, components, is_index, true, false};
}

/// The body of every point, by the number that users see.
std::vector<Index> bodies_of(const Points& points, std::span<const Index> numbers) {
  std::vector<Index> bodies(points.body().begin(), points.body().end());
  if (!numbers.empty()) {
    for (Index& body : bodies) {
      body = numbers[static_cast<std::size_t>(body)];
    }
  }
  return bodies;
}

FrameColumn field_column(const Field& field, const Points& points, bool single) {
  require(field.components >= 1 &&
              static_cast<Index>(field.values.size()) == points.size() * field.components,
          "field '", field.name, "' has ", field.values.size(), " values; ", points.size(),
          " points with ", field.components, " components need ", points.size() * field.components);
  require(!field.name.empty() && field.name.find_first_of("/\n\t") == std::string::npos,
          "field name '", field.name,
          "' cannot be stored: it is empty or contains '/', tab or newline");
  std::vector<int> source = stored_components(field.components, points.dimension());
  const int components = static_cast<int>(source.size());
  return {{"PointData/" + field.name, field.unit, components, false, false, single},
          std::span<const double>(field.values),
          std::move(source)};
}

/// Number is double, float or Index.
template <class Number, class Values>
void pack_rows(const Values& values, const std::vector<int>& source, std::span<const Index> rows,
               Words& words) {
  const std::size_t stored = source.size(), given = values.size() / rows.size();
  auto* const packed = reinterpret_cast<std::byte*>(words.data());
  parallel_for(static_cast<Index>(rows.size()), [&](Index row) {
    std::byte* to = packed + static_cast<std::size_t>(rows[row]) * stored * sizeof(Number);
    for (std::size_t k = 0; k < stored; ++k, to += sizeof(Number)) {
      if (const int from = source[k]; from >= 0) {
        const auto number = static_cast<Number>(values[row * given + from]);
        std::memcpy(to, &number, sizeof number);
      }
    }
  });
}

void require_finite(const Words& words, const Column& column) {
  constexpr std::uint64_t exponents = 0x7f8000007f800000, low = 0x7f800000, high = exponents - low;
  for (const std::uint64_t word : words) {
    require(
        (word & low) != low && (word & high) != high, field_name(column),
        " has a value that output.precision = \"single\" cannot hold: numbers of four bytes end "
        "at 3.4e38");
  }
}

}  // namespace

bool is_asked_for(const Field& field, const FrameOptions& options) {
  return !options.fields || std::ranges::find(*options.fields, field.name) != options.fields->end();
}

void require_fields(std::span<const Field> fields, const FrameOptions& options) {
  std::vector<std::string> names = {"position", "id", "body", "volume"};
  std::string listed;
  for (const Field& field : fields) {
    names.push_back(field.name);
    listed += (listed.empty() ? "" : ", ") + field.name;
  }
  for (const std::string& name : options.fields.value_or(std::vector<std::string>())) {
    const std::string nearest = nearest_name(name, names);
    require(std::ranges::find(names, name) != names.end(), "output.fields: unknown field '", name,
            "'; ", nearest.empty() ? "" : "did you mean '" + nearest + "'? ",
            "fields of this scene: ", listed);
  }
}

std::vector<FrameColumn> frame_columns(const Points& points, std::span<const Field> fields,
                                       const FrameOptions& options,
                                       std::span<const Index> body_numbers) {
  require_fields(fields, options);
  static const char* const volume_units[] = {"m", "m^2", "m^3"};
  const int dimension = points.dimension();
  std::vector<FrameColumn> columns = {
      {point_column("Points", "m", 3, false), points.position(), as_vector(dimension)},
      {point_column("PointData/id", "", 1, true), points.id(), {0}},
      {point_column("PointData/body", "", 1, true), bodies_of(points, body_numbers), {0}},
      {point_column("PointData/volume", volume_units[dimension - 1], 1, false),
       points.volume(),
       {0}},
  };
  for (const Field& field : fields) {
    if (is_asked_for(field, options)) {
      columns.push_back(field_column(field, points, options.single));
    }
  }
  std::set<std::string> names;
  for (const FrameColumn& entry : columns) {
    require(names.insert(entry.column.name).second, "two fields are called '",
            entry.column.name.substr(entry.column.name.find('/') + 1),
            "'; id, body and volume are always written");
  }
  return columns;
}

Words pack(const FrameColumn& column, std::span<const Index> rows) {
  const std::size_t numbers = rows.size() * column.source.size();
  Words words(column.column.is_single ? (numbers + 1) / 2 : numbers, 0);
  std::visit(
      [&](const auto& values) {
        using Number = std::remove_cv_t<typename std::decay_t<decltype(values)>::value_type>;
        if (column.column.is_single) {
          pack_rows<float>(values, column.source, rows, words);
        } else {
          pack_rows<Number>(values, column.source, rows, words);
        }
      },
      column.values);
  if (column.column.is_single) {
    require_finite(words, column.column);
  }
  return words;
}

std::string field_name(const Column& column) {
  return column.name == "Points" ? "position" : column.name.substr(column.name.find('/') + 1);
}

}  // namespace lapilli
