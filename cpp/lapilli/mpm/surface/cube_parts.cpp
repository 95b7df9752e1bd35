#include "lapilli/mpm/surface/cube_parts.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "lapilli/core/symmetric_modes.hpp"

namespace lapilli {
namespace {

template <int Dim>
using QuadraturePoints = std::vector<QuadraturePoint<Dim>>;

template <int Dim>
Cut<Dim> other_side(const Cut<Dim>& cut) {
  return {-cut.normal, -cut.offset};
}

/// Four Gauss points in what the cuts leave of an interval.
void add_convex(const Cube<1>& cube, std::span<const Cut<1>> cuts, QuadraturePoints<1>& points) {
  double low = cube.low[0], high = low + cube.side;
  for (const Cut<1>& cut : cuts) {
    const double at = cut.offset / cut.normal[0];
    (cut.normal[0] > 0.0 ? high : low) =
        cut.normal[0] > 0.0 ? std::min(high, at) : std::max(low, at);
  }
  constexpr double place[] = {0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                              0.93056815579702629};
  constexpr double weight[] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                               0.17392742256872693};
  for (int k = 0; k < 4 && high > low; ++k) {
    points.push_back({Vec<1>(low + place[k] * (high - low)), weight[k] * (high - low)});
  }
}

/// Six points of degree 4 (Dunavant 1985) in each triangle of a fan.
void add_convex(const Cube<2>& cube, std::span<const Cut<2>> cuts, QuadraturePoints<2>& points) {
  const Vec<2> high = cube.low + Vec<2>::Constant(cube.side);
  const Outline left = clip_polygon(rectangle(cube.low, high), cuts);
  constexpr double share[] = {0.445948490915965, 0.091576213509771};
  constexpr double weight[] = {0.223381589678011, 0.109951743655322};
  for (std::size_t k = 1; k + 1 < left.size(); ++k) {
    const Vec<2>&a = left[0], &b = left[k], &c = left[k + 1];
    const Vec<2> ab = b - a, ac = c - a;
    const double area = 0.5 * (ab[0] * ac[1] - ab[1] * ac[0]);
    for (int ring = 0; ring < 2 && area > 0.0; ++ring) {
      const Vec<2> even = share[ring] * (a + b + c);
      for (const Vec<2>* corner : {&a, &b, &c}) {
        points.push_back({even + (1.0 - 3.0 * share[ring]) * *corner, weight[ring] * area});
      }
    }
  }
}

/// Four points with the volume, centroid and second moments of the solid.
void add_convex(const Cube<3>& cube, std::span<const Cut<3>> cuts, QuadraturePoints<3>& points) {
  const Vec3 high = cube.low + Vec3::Constant(cube.side), from = cube.middle();
  double volume_sum = 0.0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
  for (const Tetrahedron& part : tetrahedra(clip_polyhedron(cuboid(cube.low, high), cuts))) {
    const double size = volume(part);
    Vec3 sum = Vec3::Zero();
    Mat3 squares = Mat3::Zero();
    for (const Vec3& corner : part) {
      const Vec3 x = corner - from;
      sum += x;
      squares += x * x.transpose();
    }
    volume_sum += size;
    first += 0.25 * size * sum;
    second += 0.05 * size * (squares + sum * sum.transpose());
  }
  if (!(volume_sum > 0.0)) {
    return;
  }
  const Vec3 mean = first / volume_sum;
  const Mat3 spread = second / volume_sum - mean * mean.transpose();
  const SymmetricModes<3> axes = symmetric_modes<3>(spread);
  const Vec3 width = axes.eigenvalues.cwiseMax(0.0).cwiseSqrt();
  // Corners of a regular tetrahedron have mean 0 and unit second moments.
  for (const Vec3& corner : {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)}) {
    const Vec3 at = axes.eigenvectors * width.cwiseProduct(corner);
    points.push_back({from + mean + at, 0.25 * volume_sum});
  }
}

// A face between two cubes, to this share of their side, belongs to the upper one.
constexpr double on_face = 1e-9;

/// The plane of a cut through a cube and further.
std::vector<Vec<1>> section(const Cube<1>& cube, const Cut<1>& cut) {
  const double at = cut.offset / cut.normal[0], low = cube.low[0] - on_face * cube.side;
  return at >= low && at < low + cube.side ? std::vector{Vec<1>(at)} : std::vector<Vec<1>>{};
}

std::vector<Vec<2>> section(const Cube<2>& cube, const Cut<2>& cut) {
  const Vec<2> middle = cube.middle(), along(-cut.normal[1], cut.normal[0]);
  const Vec<2> foot = middle - (cut.normal.dot(middle) - cut.offset) * cut.normal;
  return {foot - 2.0 * cube.side * along, foot + 2.0 * cube.side * along};
}

std::vector<Vec<3>> section(const Cube<3>& cube, const Cut<3>& cut) {
  const Vec3 middle = cube.middle(), one = cut.normal.unitOrthogonal();
  const Vec3 other = cut.normal.cross(one);
  const Vec3 foot = middle - (cut.normal.dot(middle) - cut.offset) * cut.normal;
  const double r = 2.0 * cube.side;
  return {foot + r * (one + other), foot + r * (other - one), foot - r * (one + other),
          foot + r * (one - other)};
}

template <int Dim>
void trim_to_cube(std::vector<Vec<Dim>>& corners, const Cube<Dim>& cube) {
  for (int axis = 0; axis < Dim && !corners.empty(); ++axis) {
    const Vec<Dim> along = Vec<Dim>::Unit(axis);
    const double low = cube.low[axis] - on_face * cube.side;
    clip_piece<Dim>(corners, {-along, -low});
    if (!corners.empty()) {
      clip_piece<Dim>(corners, {along, low + cube.side});
    }
  }
}

}  // namespace

template <int Dim>
void clip_piece(std::vector<Vec<Dim>>& corners, const Cut<Dim>& cut) {
  std::vector<Vec<Dim>> kept;
  const std::size_t count = corners.size(), sides = Dim == 2 ? count - 1 : count;
  for (std::size_t k = 0; k < count; ++k) {
    const Vec<Dim>&here = corners[k], &next = corners[(k + 1) % count];
    const double from = cut.normal.dot(here) - cut.offset, to = cut.normal.dot(next) - cut.offset;
    if (from <= 0.0) {
      kept.push_back(here);
    }
    if (k < sides && ((from < 0.0 && to > 0.0) || (from > 0.0 && to < 0.0))) {
      kept.push_back(here + from / (from - to) * (next - here));
    }
  }
  corners = kept.size() < static_cast<std::size_t>(Dim) ? std::vector<Vec<Dim>>{} : std::move(kept);
}

template <int Dim>
double SurfacePiece<Dim>::area() const {
  if constexpr (Dim == 1) {
    return 1.0;
  } else if constexpr (Dim == 2) {
    return (corners[1] - corners[0]).norm();
  } else {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      sum += (corners[k] - corners[0]).cross(corners[k + 1] - corners[0]);
    }
    return 0.5 * sum.norm();
  }
}

template <int Dim>
Vec<Dim> SurfacePiece<Dim>::middle() const {
  Vec<Dim> sum = Vec<Dim>::Zero();
  for (const Vec<Dim>& corner : corners) {
    sum += corner / static_cast<double>(corners.size());
  }
  return sum;
}

template <int Dim>
QuadraturePoints<Dim> SurfacePiece<Dim>::quadrature() const {
  if constexpr (Dim == 1) {
    return {{corners[0], 1.0}};
  } else if constexpr (Dim == 2) {
    const Vec<2> along = corners[1] - corners[0];
    const double length = along.norm(), off = std::sqrt(0.15);
    return {{corners[0] + (0.5 - off) * along, 5.0 / 18.0 * length},
            {corners[0] + 0.5 * along, 8.0 / 18.0 * length},
            {corners[0] + (0.5 + off) * along, 5.0 / 18.0 * length}};
  } else {
    const Vec3 from = corners[0];
    double size = 0.0;
    Vec3 moment = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      const Vec3 b = corners[k] - from, c = corners[k + 1] - from;
      const double part = 0.5 * b.cross(c).norm();
      size += part;
      moment += part / 3.0 * (b + c);
    }
    return {{size > 0.0 ? Vec3(from + moment / size) : from, size}};
  }
}

template <int Dim>
std::vector<SurfacePiece<Dim>> SurfacePiece<Dim>::parts() const {
  if constexpr (Dim == 1) {
    return {*this};
  } else if constexpr (Dim == 2) {
    return {{{corners[0], middle()}, normal}, {{middle(), corners[1]}, normal}};
  } else {
    std::vector<SurfacePiece> all;
    const std::size_t count = corners.size();
    // The centroid: only from there all parts are convex.
    const Vec3 centre = quadrature().front().position;
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3 before = 0.5 * (corners[(k + count - 1) % count] + corners[k]);
      const Vec3 after = 0.5 * (corners[k] + corners[(k + 1) % count]);
      all.push_back({{before, corners[k], after, centre}, normal});
    }
    return all;
  }
}

template <int Dim>
QuadraturePoints<Dim> volume_points(const Cube<Dim>& cube, const PlaneFit<Dim>& fit) {
  using Fit = PlaneFit<Dim>;
  QuadraturePoints<Dim> points;
  if (fit.join == Fit::Join::all) {
    add_convex(cube, std::span<const Cut<Dim>>(fit.planes), points);
    return points;
  }
  std::vector<Cut<Dim>> cuts;
  for (const Cut<Dim>& plane : fit.planes) {
    cuts.push_back(plane);
    add_convex(cube, std::span<const Cut<Dim>>(cuts), points);
    cuts.back() = other_side(plane);
  }
  return points;
}

template <int Dim>
SurfacePiece<Dim> surface_piece(const Cube<Dim>& cube, const PlaneFit<Dim>& fit,
                                std::size_t plane) {
  SurfacePiece<Dim> piece{section(cube, fit.planes[plane]), fit.planes[plane].normal};
  if constexpr (Dim > 1) {
    trim_to_cube<Dim>(piece.corners, cube);
    for (std::size_t j = 0; j < fit.planes.size() && !piece.corners.empty(); ++j) {
      if (j != plane) {
        const Cut<Dim>& other = fit.planes[j];
        clip_piece<Dim>(piece.corners,
                        fit.join == PlaneFit<Dim>::Join::all ? other : other_side<Dim>(other));
      }
    }
  }
  if (!piece.corners.empty() && !(piece.area() > 0.0)) {
    piece.corners.clear();
  }
  return piece;
}

template <int Dim>
std::vector<SurfacePiece<Dim>> surface_pieces(const Cube<Dim>& cube, const PlaneFit<Dim>& fit) {
  std::vector<SurfacePiece<Dim>> pieces;
  for (std::size_t k = 0; k < fit.planes.size(); ++k) {
    SurfacePiece<Dim> piece = surface_piece(cube, fit, k);
    if (!piece.corners.empty()) {
      pieces.push_back(std::move(piece));
    }
  }
  return pieces;
}

#define LAPILLI_INSTANTIATE(Dim)                                                                 \
  template struct SurfacePiece<Dim>;                                                             \
  template SurfacePiece<Dim> surface_piece(const Cube<Dim>&, const PlaneFit<Dim>&, std::size_t); \
  template std::vector<QuadraturePoint<Dim>> volume_points(const Cube<Dim>&,                     \
                                                           const PlaneFit<Dim>&);                \
  template std::vector<SurfacePiece<Dim>> surface_pieces(const Cube<Dim>&, const PlaneFit<Dim>&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE
template void clip_piece(std::vector<Vec<2>>&, const Cut<2>&);
template void clip_piece(std::vector<Vec<3>>&, const Cut<3>&);

}  // namespace lapilli
