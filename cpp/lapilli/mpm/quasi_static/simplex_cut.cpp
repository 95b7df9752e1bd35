#include "lapilli/mpm/quasi_static/simplex_cut.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <optional>

#include "lapilli/mpm/quasi_static/surface_piece.hpp"

namespace lapilli {
namespace {

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

template <int Dim>
void cut_simplices(const LevelSet& surface, const Cube<Dim>& cube, double shift, Trims trims,
                   std::vector<SurfacePoint<Dim>>& points) {
  static const auto all_simplices = simplices<Dim>();
  const double size = cube.side;
  const auto shifted = [&](const Vec<Dim>& at) {
    return surface.distance(in_space<Dim>(at)) - shift;
  };
  std::array<Vec<Dim>, 1 << Dim> corner;
  std::array<double, 1 << Dim> value;
  for (int k = 0; k < (1 << Dim); ++k) {
    corner[k] = cube.corner(k);
    value[k] = shifted(corner[k]);
  }
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
    const auto normal = normal_of<Dim>(piece, towards, size);
    if (!normal) {
      continue;
    }
    for (Vec<Dim>& end : piece) {
      end -= shift * surface.normal(in_space<Dim>(end)).template head<Dim>();
    }
    // Pieces of a curved surface are flat: what counts is the surface above them.
    const auto lifted = [&](const Vec3& at) {
      const SurfacePoint<Dim> below{at.head<Dim>(), *normal, 1.0};
      return in_space<Dim>(on_surface<Dim>(surface, size, below).position);
    };
    std::vector<LevelSet> above;
    for (const LevelSet& region : trims) {
      above.push_back({[&](const Vec3& at) { return region.distance(lifted(at)); }, {}});
    }
    for (const Piece<Dim>& part : trim_to<Dim>(above, piece, 1e-12 * size)) {
      const std::size_t first = points.size();
      add_points<Dim>(part, *normal, points);
      for (std::size_t k = first; k < points.size(); ++k) {
        points[k] = on_surface<Dim>(surface, size, points[k]);
      }
    }
  }
}

template void cut_simplices(const LevelSet&, const Cube<2>&, double, Trims,
                            std::vector<SurfacePoint<2>>&);
template void cut_simplices(const LevelSet&, const Cube<3>&, double, Trims,
                            std::vector<SurfacePoint<3>>&);

}  // namespace lapilli
