#include "lapilli/mpm/quasi_static/surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "lapilli/mpm/quasi_static/surface_piece.hpp"

namespace lapilli {
namespace {

constexpr double nudge = 1e-7;  // cells; how far inside the material its cell is looked up

constexpr double slight_bend = 0.8;  // cosine between normals of one facet

template <int Dim>
bool inside(const Grid<Dim>& grid, const typename Grid<Dim>::Cell& cell) {
  for (int axis = 0; axis < Dim; ++axis) {
    if (cell[axis] < 0 || cell[axis] >= grid.cells(axis)) {
      return false;
    }
  }
  return true;
}

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

}  // namespace

std::vector<Facet<2>> cut_line(const Grid<2>& grid, std::span<const Vec<2>> line, int surface,
                               Trims trims) {
  std::vector<Facet<2>> facets;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vec<2> along = line[k + 1] - line[k];
    const Vec<2> normal = Vec<2>(-along[1], along[0]).normalized();
    const std::vector<double> shares = crossings(grid, line[k], along);
    for (std::size_t j = 0; j + 1 < shares.size(); ++j) {
      const Piece<2> piece{line[k] + shares[j] * along, line[k] + shares[j + 1] * along};
      const Vec<2> middle = 0.5 * (piece[0] + piece[1]);
      Facet<2> facet{surface, grid.cell_containing(middle + nudge * grid.cell_size() * normal), {}};
      for (const Piece<2>& part : trim_to<2>(trims, piece, 1e-12 * grid.cell_size())) {
        add_points<2>(part, normal, facet.points);
      }
      if (!inside<2>(grid, facet.cell) || facet.area() <= 1e-13 * grid.cell_size()) {
        continue;
      }
      // A slight bend inside a cell belongs to a curve: one facet, or its two mean gaps would hold
      // the motion along it as well.
      if (!facets.empty() && facets.back().cell == facet.cell &&
          facets.back().points.back().normal.dot(normal) > slight_bend) {
        auto& points = facets.back().points;
        points.insert(points.end(), facet.points.begin(), facet.points.end());
      } else {
        facets.push_back(std::move(facet));
      }
    }
  }
  return facets;
}

}  // namespace lapilli
