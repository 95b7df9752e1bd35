#include "lapilli/mpm/quasi_static/surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

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

/// The point of the surface above one of a flat piece, along the normal of the piece; it stands for
/// the surface above its part of the piece. At an edge the point itself.
template <int Dim>
SurfacePoint<Dim> on_surface(const LevelSet& surface, double cell_size,
                             const SurfacePoint<Dim>& point) {
  constexpr double least_cosine = 0.5;
  Vec<Dim> at = point.position;
  for (int round = 0; round < 20; ++round) {
    const double distance = surface.distance(in_space<Dim>(at));
    const Vec<Dim> normal = surface.normal(in_space<Dim>(at)).template head<Dim>();
    const double cosine = normal.dot(point.normal);
    if (!(cosine > least_cosine) || (at - point.position).norm() > 0.5 * cell_size) {
      return point;
    }
    if (std::abs(distance) < 1e-14 * cell_size || round == 19) {
      return {at, normal, point.weight / cosine};
    }
    at -= distance / cosine * point.normal;
  }
  return point;
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

/// Where the level set is `nudge` inside the material, in one simplex of a cell.
template <int Dim>
Piece<Dim> cut_simplex(const std::array<Vec<Dim>, Dim + 1>& corner,
                       const std::array<double, Dim + 1>& value,
                       const std::function<double(const Vec<Dim>&)>& function) {
  std::array<int, Dim + 1> in{}, out{};
  int in_count = 0, out_count = 0;
  for (int k = 0; k <= Dim; ++k) {
    (value[k] > 0.0 ? in[in_count++] : out[out_count++]) = k;
  }
  const auto crossing = [&](int a, int b) {
    // Always from the same end, so that neighbours find the same place.
    if (std::lexicographical_compare(corner[b].begin(), corner[b].end(), corner[a].begin(),
                                     corner[a].end())) {
      std::swap(a, b);
    }
    const Vec<Dim> along = corner[b] - corner[a];
    return Vec<Dim>(
        corner[a] +
        along * zero_between([&](double share) { return function(corner[a] + share * along); },
                             value[a], value[b]));
  };
  Piece<Dim> piece;
  if (in_count == 0 || out_count == 0) {
    return piece;
  }
  if (Dim == 3 && in_count == 2) {
    return {crossing(in[0], out[0]), crossing(in[0], out[1]), crossing(in[1], out[1]),
            crossing(in[1], out[0])};
  }
  const bool lone_in = in_count == 1;
  for (int k = 0; k < Dim; ++k) {
    piece.push_back(lone_in ? crossing(in[0], out[k]) : crossing(in[k], out[0]));
  }
  return piece;
}

/// Unit normal of a piece, on the side of `towards`; nothing if the piece is degenerate.
template <int Dim>
std::optional<Vec<Dim>> normal_of(const Piece<Dim>& piece, const Vec<Dim>& towards,
                                  double cell_size) {
  Vec<Dim> normal = Vec<Dim>::Zero();
  if constexpr (Dim == 2) {
    const Vec<2> along = piece[1] - piece[0];
    normal = Vec<2>(-along[1], along[0]) * cell_size;
  } else {
    for (std::size_t k = 1; k + 1 < piece.size(); ++k) {
      normal += Vec<3>((piece[k] - piece[0]).cross(piece[k + 1] - piece[0]));
    }
  }
  const double size = normal.norm();
  if (size < 1e-14 * cell_size * cell_size) {
    return std::nullopt;
  }
  return Vec<Dim>((normal.dot(towards) < 0.0 ? -1.0 : 1.0) / size * normal);
}

/// The simplices of a cell: corners as bit patterns of the upper side along each axis (Kuhn).
template <int Dim>
std::vector<std::array<int, Dim + 1>> simplices() {
  std::array<int, Dim> axes;
  for (int axis = 0; axis < Dim; ++axis) {
    axes[axis] = axis;
  }
  std::vector<std::array<int, Dim + 1>> all;
  do {
    std::array<int, Dim + 1> corners{};
    for (int k = 0; k < Dim; ++k) {
      corners[k + 1] = corners[k] | (1 << axes[k]);
    }
    all.push_back(corners);
  } while (std::next_permutation(axes.begin(), axes.end()));
  return all;
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
      Piece<2> piece{line[k] + shares[j] * along, line[k] + shares[j + 1] * along};
      const Vec<2> middle = 0.5 * (piece[0] + piece[1]);
      Facet<2> facet{surface, grid.cell_containing(middle + nudge * grid.cell_size() * normal), {}};
      for (const auto& region : trims) {
        piece = piece.size() < 2 ? piece : trim<2>(piece, region, 1e-12 * grid.cell_size());
      }
      add_points<2>(piece, normal, facet.points);
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

template <int Dim>
std::vector<Facet<Dim>> cut_level_set(const Grid<Dim>& grid, std::span<const char> cells,
                                      const LevelSet& surface, int number, Trims trims) {
  const double h = grid.cell_size();
  const auto shifted = [&](const Vec<Dim>& at) {
    return surface.distance(in_space<Dim>(at)) - nudge * h;
  };
  const auto all_simplices = simplices<Dim>();
  std::vector<Facet<Dim>> facets;
  for (Index index = 0; index < grid.cell_count(); ++index) {
    if (!cells[index]) {
      continue;
    }
    const auto cell = grid.cell_at(index);
    const Vec<Dim> low = grid.node_position(grid.node_index(cell));
    const Vec<Dim> middle = low + Vec<Dim>::Constant(0.5 * h);
    if (std::abs(shifted(middle)) > 0.51 * h * std::sqrt(static_cast<double>(Dim))) {
      continue;
    }
    std::array<Vec<Dim>, 1 << Dim> corner;
    std::array<double, 1 << Dim> value;
    for (int k = 0; k < (1 << Dim); ++k) {
      corner[k] = low;
      for (int axis = 0; axis < Dim; ++axis) {
        corner[k][axis] += ((k >> axis) & 1) * h;
      }
      value[k] = shifted(corner[k]);
    }
    Facet<Dim> facet{number, cell, {}};
    for (const auto& simplex : all_simplices) {
      std::array<Vec<Dim>, Dim + 1> ends;
      std::array<double, Dim + 1> values;
      for (int k = 0; k <= Dim; ++k) {
        ends[k] = corner[simplex[k]];
        values[k] = value[simplex[k]];
      }
      Piece<Dim> piece = cut_simplex<Dim>(ends, values, shifted);
      if (piece.empty()) {
        continue;
      }
      const Vec<Dim> towards = surface.normal(in_space<Dim>(piece[0])).template head<Dim>();
      const auto normal = normal_of<Dim>(piece, towards, h);
      if (!normal) {
        continue;
      }
      for (Vec<Dim>& end : piece) {
        end -= nudge * h * surface.normal(in_space<Dim>(end)).template head<Dim>();
      }
      for (const auto& region : trims) {
        // Pieces of a curved surface are flat: what counts is the surface above them.
        const auto above = [&](const Vec3& at) {
          const SurfacePoint<Dim> flat{at.head<Dim>(), *normal, 1.0};
          return region(in_space<Dim>(on_surface<Dim>(surface, h, flat).position));
        };
        piece = piece.size() < Dim ? Piece<Dim>{} : trim<Dim>(piece, above, 1e-12 * h);
      }
      const std::size_t first = facet.points.size();
      add_points<Dim>(piece, *normal, facet.points);
      for (std::size_t k = first; k < facet.points.size(); ++k) {
        facet.points[k] = on_surface<Dim>(surface, h, facet.points[k]);
      }
    }
    if (facet.area() > 1e-13 * std::pow(h, Dim - 1)) {
      facets.push_back(std::move(facet));
    }
  }
  return facets;
}

template std::vector<Facet<2>> cut_level_set(const Grid<2>&, std::span<const char>, const LevelSet&,
                                             int, Trims);
template std::vector<Facet<3>> cut_level_set(const Grid<3>&, std::span<const char>, const LevelSet&,
                                             int, Trims);

}  // namespace lapilli
