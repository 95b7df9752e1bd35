#include "lapilli/mpm/quasi_static/surface.hpp"

#include <algorithm>

namespace lapilli {
namespace {

constexpr double nudge = 1e-7;  // cells; how far inside the material its cell is looked up

/// Where a segment crosses grid lines, as shares of its length, ends included.
std::vector<double> crossings(const Grid<2>& grid, const Vec<2>& from, const Vec<2>& along) {
  constexpr double smallest = 1e-12;  // share of the length
  std::vector<double> shares{0.0, 1.0};
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(along[axis]) <= smallest * along.norm()) {
      continue;
    }
    for (int line = 0; line <= grid.cells(axis); ++line) {
      const double place = grid.lower()[axis] + (line - Grid<2>::padding) * grid.cell_size();
      const double share = (place - from[axis]) / along[axis];
      if (share > smallest && share < 1.0 - smallest) {
        shares.push_back(share);
      }
    }
  }
  std::sort(shares.begin(), shares.end());
  shares.erase(std::unique(shares.begin(), shares.end(),
                           [](double a, double b) { return b - a <= smallest; }),
               shares.end());
  shares.back() = 1.0;
  return shares;
}

bool inside(const Grid<2>& grid, const Grid<2>::Cell& cell) {
  return cell[0] >= 0 && cell[1] >= 0 && cell[0] < grid.cells(0) && cell[1] < grid.cells(1);
}

}  // namespace

std::vector<Facet<2>> cut_line(const Grid<2>& grid, std::span<const Vec<2>> line, int surface) {
  const double gauss_place[3] = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)};
  const double gauss_weight[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  std::vector<Facet<2>> facets;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec<2> along = line[k + 1] - line[k];
    const Vec<2> normal = Vec<2>(-along[1], along[0]).normalized();
    const std::vector<double> shares = crossings(grid, line[k], along);
    for (std::size_t j = 0; j + 1 < shares.size(); ++j) {
      const Vec<2> middle = line[k] + 0.5 * (shares[j] + shares[j + 1]) * along;
      Facet<2> facet{surface, grid.cell_containing(middle + nudge * grid.cell_size() * normal), {}};
      if (!inside(grid, facet.cell)) {
        continue;
      }
      const double share = shares[j + 1] - shares[j];
      for (int q = 0; q < 3; ++q) {
        facet.points.push_back({line[k] + (shares[j] + share * gauss_place[q]) * along, normal,
                                gauss_weight[q] * share * along.norm()});
      }
      facets.push_back(std::move(facet));
    }
  }
  return facets;
}

}  // namespace lapilli
