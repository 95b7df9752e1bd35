#include "lapilli/mpm/transfer/point_start.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"

namespace lapilli {

void PointStart::fetch(const std::string& name, const Points& points, PointArray& into) const {
  const std::vector<double> from = state->read_numbers(name);
  const auto width = static_cast<Index>(into.components());
  for (Index here = 0; here < points.size(); ++here) {
    const Index there = row[static_cast<std::size_t>(points.id()[here])];
    if (there >= 0) {
      require((there + 1) * width <= static_cast<Index>(from.size()),
              "the state to start from holds ", name, " of another dimension");
      std::copy_n(from.begin() + there * width, width, into.data() + here * width);
    }
  }
}

}  // namespace lapilli
