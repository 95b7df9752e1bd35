#include "lapilli/peridynamics/fluid_surface.hpp"

#include <cmath>
#include <set>

namespace lapilli {
namespace {

// No box past the next one to a point this far inside holds surface.
constexpr double deep = 2.6;  // spacings

/// A corner of the boxes that points were filled into: the point deepest in the body sits in the
/// middle of its box.
Vec3 lattice_corner(const WallSurface& walls) {
  Vec3 deepest = Vec3::Zero();
  double least = 1e300;
  for (Index i = 0; i < walls.points().size(); ++i) {
    const double outside = walls.wall(i) < 0 ? walls.region()(walls.place(i)) : 1e300;
    if (outside < least) {
      least = outside;
      deepest = walls.place(i);
    }
  }
  return deepest - Vec3::Constant(0.5 * walls.spacing());
}

}  // namespace

FluidSurface::BoxIndex FluidSurface::box_of(const Vec3& at) const {
  BoxIndex box{0, 0, 0};
  for (int d = 0; d < dimension; ++d) {
    box[static_cast<std::size_t>(d)] = std::lround(std::floor((at[d] - lattice[d]) / side + 1e-9));
  }
  return box;
}

FluidSurface find_fluid_surface(const WallSurface& walls) {
  const double side = walls.spacing();
  const int dimension = walls.points().dimension();
  FluidSurface surface{lattice_corner(walls), side, dimension, {}, {}};
  std::set<FluidSurface::BoxIndex> wanted;
  for (Index i = 0; i < walls.points().size(); ++i) {
    if (walls.wall(i) >= 0 || walls.region()(walls.place(i)) < -deep * side) {
      continue;
    }
    const FluidSurface::BoxIndex own = surface.box_of(walls.place(i));
    for (int which = 0; which < (dimension == 1 ? 3 : dimension == 2 ? 9 : 27); ++which) {
      FluidSurface::BoxIndex box = own;
      for (int d = 0, rest = which; d < dimension; ++d, rest /= 3) {
        box[static_cast<std::size_t>(d)] += rest % 3 - 1;
      }
      wanted.insert(box);
    }
  }
  for (const FluidSurface::BoxIndex& box : wanted) {
    Vec3 lower = Vec3::Zero();
    for (int d = 0; d < dimension; ++d) {
      lower[d] = surface.lattice[d] + static_cast<double>(box[static_cast<std::size_t>(d)]) * side;
    }
    surface.boxes.push_back(lower);
  }
  surface.pieces = boundary_pieces(
      walls.region(), SurfaceBoxes{surface.boxes, side, dimension},
      [&](const Vec3& place, const Vec3& normal) { return walls.wall_at(place, normal); });
  return surface;
}

std::vector<double> shared_areas(const WallSurface& walls) {
  std::vector<double> area(walls.walls().size(), 0.0);
  for (const auto& in_box : find_fluid_surface(walls).pieces) {
    for (const BoundaryPiece& piece : in_box) {
      if (piece.wall >= 0) {
        area[static_cast<std::size_t>(piece.wall)] += piece.area;
      }
    }
  }
  return area;
}

}  // namespace lapilli
