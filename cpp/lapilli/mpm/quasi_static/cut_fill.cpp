#include "lapilli/mpm/quasi_static/cut_fill.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

using Face = std::vector<Vec3>;  // corners of a flat convex face, in order
using Solid = std::vector<Face>;

struct Plane {
  Vec3 at;
  Vec3 inward;
};

/// The planes that bound a convex shape with flat faces; nothing for other shapes.
std::optional<std::vector<Plane>> planes_of(const Shape& shape) {
  std::vector<Plane> planes;
  if (const auto* half = std::get_if<HalfSpace>(&shape)) {
    planes.push_back({place(half->point), -place(half->normal).normalized()});
  } else if (const auto* box = std::get_if<Box>(&shape)) {
    for (std::size_t axis = 0; axis < box->lower.size(); ++axis) {
      const Vec3 direction = Vec3::Unit(static_cast<int>(axis));
      planes.push_back({place(box->lower), direction});
      planes.push_back({place(box->upper), -direction});
    }
  } else if (const auto* turned = std::get_if<Rotated>(&shape)) {
    auto before = planes_of(*turned->shape);
    if (!before) {
      return std::nullopt;
    }
    const Vec3 centre = place(turned->center);
    const Mat3 turn = turned->matrix();
    for (const Plane& plane : *before) {
      planes.push_back({centre + turn * (plane.at - centre), turn * plane.inward});
    }
  } else if (const auto* moved = std::get_if<Translated>(&shape)) {
    auto before = planes_of(*moved->shape);
    if (!before) {
      return std::nullopt;
    }
    for (const Plane& plane : *before) {
      planes.push_back({plane.at + place(moved->by), plane.inward});
    }
  } else if (const auto* common = std::get_if<Intersection>(&shape)) {
    for (const Shape& part : common->shapes) {
      const auto of_part = planes_of(part);
      if (!of_part) {
        return std::nullopt;
      }
      planes.insert(planes.end(), of_part->begin(), of_part->end());
    }
  } else {
    return std::nullopt;
  }
  return planes;
}

/// Corners of a flat convex face in order around their middle.
Face ordered(Face corners, const Vec3& normal) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& corner : corners) {
    middle += corner / static_cast<double>(corners.size());
  }
  int least = 0;
  normal.cwiseAbs().minCoeff(&least);
  const Vec3 one = normal.cross(Vec3(Vec3::Unit(least))).normalized(), other = normal.cross(one);
  std::sort(corners.begin(), corners.end(), [&](const Vec3& a, const Vec3& b) {
    return std::atan2((a - middle).dot(other), (a - middle).dot(one)) <
           std::atan2((b - middle).dot(other), (b - middle).dot(one));
  });
  return corners;
}

/// The part of a convex solid on the inner side of a plane.
Solid clip(const Solid& solid, const Plane& plane, double slack) {
  Solid kept;
  Face cap;
  for (const Face& face : solid) {
    Face rest;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vec3 &p = face[k], &q = face[(k + 1) % face.size()];
      const double a = (p - plane.at).dot(plane.inward), b = (q - plane.at).dot(plane.inward);
      if (a >= -slack) {
        rest.push_back(p);
      }
      if (std::abs(a) <= slack) {
        cap.push_back(p);
      }
      if ((a > slack && b < -slack) || (a < -slack && b > slack)) {
        rest.push_back(p + (q - p) * (a / (a - b)));
        cap.push_back(rest.back());
      }
    }
    if (rest.size() >= 3) {
      kept.push_back(std::move(rest));
    }
  }
  if (cap.size() >= 3) {
    kept.push_back(ordered(std::move(cap), plane.inward));
  }
  return kept;
}

Solid box_at(const Vec3& low, double size) {
  const auto corner = [&](int k) {
    return Vec3(low + size * Vec3(k & 1, (k >> 1) & 1, (k >> 2) & 1));
  };
  const int faces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  Solid solid;
  for (const auto& face : faces) {
    solid.push_back({corner(face[0]), corner(face[1]), corner(face[2]), corner(face[3])});
  }
  return solid;
}

/// Four points of degree 2 in each tetrahedron between the middle of a solid and its faces.
void add_points(const Solid& solid, double smallest, FilledPoints& points) {
  constexpr double near = 0.5854101966249685, far = 0.1381966011250105;
  Vec3 middle = Vec3::Zero();
  double corners = 0.0;
  for (const Face& face : solid) {
    for (const Vec3& corner : face) {
      middle += corner;
      corners += 1.0;
    }
  }
  middle /= corners;
  for (const Face& face : solid) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const std::array<Vec3, 4> tetrahedron{middle, face[0], face[k], face[k + 1]};
      const Vec3 a = tetrahedron[1] - middle, b = tetrahedron[2] - middle,
                 c = tetrahedron[3] - middle;
      const double volume = std::abs(a.dot(b.cross(c))) / 6.0;
      if (volume <= smallest) {
        continue;
      }
      for (int q = 0; q < 4; ++q) {
        Vec3 at = Vec3::Zero();
        for (int j = 0; j < 4; ++j) {
          at += (j == q ? near : far) * tetrahedron[j];
        }
        points.position.insert(points.position.end(), at.data(), at.data() + 3);
        points.volume.push_back(0.25 * volume);
      }
    }
  }
}

/// The part of a box in a shape with curved faces or edges: its six tetrahedra, each cut by the
/// plane through the linear interpolant of the distance.
void add_curved(const Shape& shape, const Vec3& low, double size, FilledPoints& points) {
  const double slack = 1e-13 * size;
  std::array<int, 3> axes{0, 1, 2};
  do {
    std::array<Vec3, 4> corner;
    std::array<double, 4> value;
    corner[0] = low;
    for (int k = 0; k < 3; ++k) {
      corner[k + 1] = corner[k] + size * Vec3::Unit(axes[k]);
    }
    for (int k = 0; k < 4; ++k) {
      value[k] = distance(shape, corner[k]);
    }
    Solid solid{{corner[0], corner[1], corner[2]},
                {corner[0], corner[1], corner[3]},
                {corner[0], corner[2], corner[3]},
                {corner[1], corner[2], corner[3]}};
    if (*std::max_element(value.begin(), value.end()) > 0.0) {
      Mat3 edges;
      Vec3 rise;
      for (int k = 0; k < 3; ++k) {
        edges.row(k) = (corner[k + 1] - corner[0]).transpose();
        rise[k] = value[k + 1] - value[0];
      }
      const Vec3 slope = edges.inverse() * rise;
      if (slope.norm() < 1e-12) {
        continue;
      }
      const Vec3 at = corner[0] - slope * (value[0] / slope.squaredNorm());
      solid = clip(solid, {at, -slope.normalized()}, slack);
    }
    if (solid.size() >= 4) {
      add_points(solid, 1e-16 * size * size * size, points);
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
}

}  // namespace

FilledPoints fill_exactly(const Shape& shape, const Lattice& lattice, int dimension) {
  FillOptions options;
  options.clip = true;
  options.smallest_volume = 1e-12;  // below it a box is cut by rounding alone
  if (dimension < 3) {
    return fill(shape, lattice, options, dimension);
  }
  check(shape, 3);
  const Bounds ends = bounds(shape);
  require(ends.lower.allFinite() && ends.upper.allFinite(),
          "fill: the shape has no end along every axis");
  const auto planes = planes_of(shape);
  const double size = lattice.spacing(), slack = 1e-12 * size;
  FilledPoints points;
  points.dimension = 3;
  points.spacing = size;
  std::array<Index, 3> first, last;
  for (int axis = 0; axis < 3; ++axis) {
    first[axis] = static_cast<Index>(std::floor((ends.lower[axis] - lattice.lower[axis]) / size));
    last[axis] = static_cast<Index>(std::ceil((ends.upper[axis] - lattice.lower[axis]) / size));
  }
  for (Index k = first[2]; k <= last[2]; ++k) {
    for (Index j = first[1]; j <= last[1]; ++j) {
      for (Index i = first[0]; i <= last[0]; ++i) {
        const Vec3 low = lattice.lower + size * Vec3(static_cast<double>(i), static_cast<double>(j),
                                                     static_cast<double>(k));
        const Vec3 middle = low + Vec3::Constant(0.5 * size);
        const double to_surface = distance(shape, middle);
        if (to_surface > 0.87 * size) {
          continue;
        }
        bool cut = true;
        if (planes) {
          cut = std::any_of(planes->begin(), planes->end(), [&](const Plane& plane) {
            return (middle - plane.at).dot(plane.inward) <
                   0.5 * size * plane.inward.lpNorm<1>() - slack;
          });
        } else {
          cut = to_surface > -0.87 * size;
        }
        if (!cut) {
          points.position.insert(points.position.end(), middle.data(), middle.data() + 3);
          points.volume.push_back(size * size * size);
          continue;
        }
        if (!planes) {
          add_curved(shape, low, size, points);
          continue;
        }
        Solid solid = box_at(low, size);
        for (const Plane& plane : *planes) {
          solid = solid.size() >= 4 ? clip(solid, plane, slack) : Solid{};
        }
        if (solid.size() >= 4) {
          add_points(solid, 1e-15 * size * size * size, points);
        }
      }
    }
  }
  require(!points.volume.empty(), "fill: no point of the lattice lies in the shape");
  return points;
}

}  // namespace lapilli
