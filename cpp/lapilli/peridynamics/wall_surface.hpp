#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/geometry/cell_list.hpp"
#include "lapilli/peridynamics/wall_settings.hpp"

namespace lapilli {

/// Signed distance from the region of the fluid, m: positive outside it, where walls are.
using FluidDistance = std::function<double(const Vec3&)>;

/// A wall and the body that holds its points.
struct FluidWall {
  FluidWallSettings settings;
  int body = 0;
};

/// The walls of a fluid as layers of points: how deep each lies behind the wetted surface and which
/// way the fluid is. Near a wall point the surface is taken as a plane.
class WallSurface {
 public:
  /// Points of bodies that are no wall are fluid. Throws std::invalid_argument when a wall point
  /// lies in the fluid, a fluid point in a wall, or a body number occurs twice.
  /// `shapes`, one a wall or none at all, are signed distances from the walls, m, negative inside;
  /// without them walls are known by their points alone.
  WallSurface(Points& points, std::vector<FluidWall> walls, const FluidDistance& distance,
              double spacing, std::vector<FluidDistance> shapes = {});

  const std::vector<FluidWall>& walls() const { return walls_; }
  /// Which wall a point belongs to; -1: fluid.
  int wall(Index point) const { return wall_of_body_[points_.body()[point]]; }
  int wall_of_body(Index body) const { return wall_of_body_[body]; }
  Index bodies() const { return static_cast<Index>(wall_of_body_.size()); }
  /// Where a point is, m; unused coordinates 0.
  Vec3 place(Index point) const;
  const Points& points() const { return points_; }
  double spacing() const { return spacing_; }

  double depth(Index point) const { return depth_[point]; }  // m, behind the surface; 0 on it
  const double* normal(Index point) const {                  // unit, into the fluid
    return normal_.data() + point * points_.dimension();
  }
  /// Distance of `place` from the surface in front of wall point `point`, m.
  template <int Dim>
  double distance(const double* place, Index point) const {
    const double* n = normal(point);
    const double* x = points_.position().data() + point * Dim;
    double along = -depth_[point];
    for (int d = 0; d < Dim; ++d) {
      along += (place[d] - x[d]) * n[d];
    }
    return along;
  }

  /// Signed distance from the region of the fluid, m; empty where it was not given.
  const FluidDistance& region() const { return region_; }
  /// The wall that the fluid's surface meets at `place`, where `normal` points out of the fluid:
  /// the first one in front of it within 3/4 of a spacing; -1: none. Walls without a shape are told
  /// by their nearest point.
  int wall_at(const Vec3& place, const Vec3& normal) const;

  /// Throws std::invalid_argument, naming a place, unless the walls fill what a fluid
  /// point one spacing off their surface can feel within `horizon` (m).
  void require_thickness(double horizon) const;
  /// Throws std::invalid_argument, naming the place, where the fluid ends without a wall: a free
  /// surface is not modelled. `distance` is that from the region of the fluid.
  void require_closed(const FluidDistance& distance) const;

  void save(Archive& archive) const;
  void load(const Archive& archive);

 private:
  /// What lies behind a surface point along its normal.
  struct Behind {
    double filled;    // m from the surface: how far wall points go
    double to_fluid;  // m from the surface to fluid on the other side; infinite: none near
  };
  Behind behind(Index point, double reach, const CellList& near) const;

  Points& points_;
  std::vector<FluidWall> walls_;
  std::vector<int> wall_of_body_;
  double spacing_;
  PointArray depth_, normal_;
  FluidDistance region_;
  std::vector<FluidDistance> shapes_;
  std::unique_ptr<CellList> near_;  // all points, where walls have no shapes
};

}  // namespace lapilli
