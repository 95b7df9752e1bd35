#include "lapilli/mpm/surface/divide_pieces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lapilli/core/in_space.hpp"
#include "lapilli/mpm/surface/surface_regions.hpp"

namespace lapilli {
namespace {

// Lengths in cells.
constexpr double on_wall_by = 1e-6;
constexpr double on_edge = 1e-6;  // beyond its edge a place counts as in a region
constexpr double entered = 0.1;   // of the distance before: a tangent circle leaves a fourth

// A face goes on ahead where it turns off by no more: one of four cells radius does by .005 cells
// and 3 degrees in .2.
constexpr double turns_by = 0.03;  // cells
constexpr double one_face = 0.95;  // cosine

constexpr double least_slope = 0.09;  // of a region's boundary that surface passes, 5 degrees

}  // namespace

template <int Dim>
SurfaceDivision<Dim>::SurfaceDivision(const Grid<Dim>& grid, std::span<const Shape> bodies,
                                      std::size_t own, std::vector<const Shape*> regions,
                                      const ContactFaces& walls)
    : grid_(grid), bodies_(bodies), own_(own), regions_(std::move(regions)), walls_(walls) {
  has_regions_ = std::any_of(regions_.begin(), regions_.end(),
                             [](const Shape* region) { return region != nullptr; });
}

template <int Dim>
bool SurfaceDivision<Dim>::near_others(const SurfacePiece<Dim>& piece) const {
  const Vec3 at = in_space<Dim>(piece.middle());
  for (std::size_t other = 0; other < bodies_.size(); ++other) {
    if (other != own_ && distance(bodies_[other], at) < 2.0 * grid_.cell_size()) {
      return true;
    }
  }
  return std::any_of(walls_.begin(), walls_.end(), [](bool wall) { return wall; });
}

template <int Dim>
bool SurfaceDivision<Dim>::on_wall(const Vec<Dim>& at, const Vec<Dim>& normal) const {
  const double h = grid_.cell_size();
  for (int axis = 0; axis < Dim; ++axis) {
    const double lower = grid_.lower()[axis];
    const double upper = lower + (grid_.cells(axis) - 2 * Grid<Dim>::padding) * h;
    if ((walls_[static_cast<std::size_t>(2 * axis)] && at[axis] < lower + on_wall_by * h &&
         normal[axis] < -0.99) ||
        (walls_[static_cast<std::size_t>(2 * axis + 1)] && at[axis] > upper - on_wall_by * h &&
         normal[axis] > 0.99)) {
      return true;
    }
  }
  return false;
}

template <int Dim>
int SurfaceDivision<Dim>::label_at(const Vec<Dim>& at, const Vec<Dim>& normal, bool near) {
  if (near) {
    const Vec3 place = in_space<Dim>(at), outward = in_space<Dim>(normal);
    if (on_wall(at, normal)) {
      return on_wall_label;
    }
    const Vec3 beyond = project(bodies_[own_], place) + contact_gap * grid_.cell_size() * outward;
    for (std::size_t other = 0; other < bodies_.size(); ++other) {
      if (other != own_ && distance(bodies_[other], beyond) <= 0.0) {
        if (std::find(touching_.begin(), touching_.end(), other) == touching_.end()) {
          touching_.push_back(other);
        }
        return on_body(other);
      }
    }
  }
  for (std::size_t law = 0; law < regions_.size(); ++law) {
    if (depth_in(law, at, normal, on_edge) >= 0.0) {
      return static_cast<int>(law);
    }
  }
  return nobody;
}

/// Whether the surface, followed from a place outside of a region against its gradient along the
/// surface, soon comes into it: then it passes the region's boundary and does not run along it.
template <int Dim>
bool SurfaceDivision<Dim>::enters(const Shape& region, const Vec3& place, double from,
                                  const Vec3& along) const {
  const double slope = along.norm();
  if (slope < least_slope) {
    return false;
  }
  const Vec3 there = project(bodies_[own_], place - (from / (slope * slope)) * along);
  return distance(region, there) < std::max(entered * from, on_edge * grid_.cell_size());
}

template <int Dim>
double SurfaceDivision<Dim>::depth_in(std::size_t law, const Vec<Dim>& at, const Vec<Dim>& normal,
                                      double margin) const {
  const double h = grid_.cell_size();
  const Shape* region = regions_[law];
  if (region == nullptr) {
    return h;
  }
  const Vec3 place = in_space<Dim>(at);
  const double from = distance(*region, place);
  if (std::abs(from) > region_slack * h) {
    return -from;
  }
  const Vec3 outward = in_space<Dim>(normal), away = gradient(*region, place);
  const double across = std::max(away.dot(outward), 0.0);
  const Vec3 along = away - across * outward;
  const bool passes = from > 0.0 && across > 0.0 && enters(*region, place, from, along);
  return h * (passes ? margin : std::max(margin, region_slack * std::pow(across, 8))) - from;
}

template <int Dim>
bool SurfaceDivision<Dim>::may_end_near(int law, const Vec<Dim>& at, double way) const {
  const double far = way + region_slack * grid_.cell_size();
  const Vec3 place = in_space<Dim>(at);
  for (int one = 0; one <= law; ++one) {
    const Shape* region = regions_[static_cast<std::size_t>(one)];
    if (region != nullptr &&
        (one == law ? distance(*region, place) > -far : distance(*region, place) < far)) {
      return true;
    }
  }
  return false;
}

template <int Dim>
std::optional<int> SurfaceDivision<Dim>::beside(int law, const Vec<Dim>& at, const Vec<Dim>& normal,
                                                double way) {
  constexpr int ways = Dim == 3 ? 8 : 2;
  const Vec3 place = in_space<Dim>(at), up = in_space<Dim>(normal);
  const Vec3 along = Dim == 3 ? Vec3(up.unitOrthogonal()) : Vec3(-up[1], up[0], 0.0);
  const Vec3 across = up.cross(along);
  for (int k = 0; k < ways; ++k) {
    const double angle = 2.0 * M_PI * k / ways;
    const Vec3 ahead = place + way * (std::cos(angle) * along + std::sin(angle) * across);
    const Vec3 outward = gradient(bodies_[own_], ahead);
    if (std::abs(distance(bodies_[own_], ahead)) > turns_by * grid_.cell_size() ||
        outward.dot(up) < one_face) {
      continue;
    }
    const Vec3 there = project(bodies_[own_], ahead);
    const int label = label_at(there.template head<Dim>(), outward.template head<Dim>(), true);
    if (label >= nobody && label != law) {
      return label;
    }
  }
  return std::nullopt;
}

/// At its corners, its middle and half way between these and each other.
template <int Dim>
std::optional<int> SurfaceDivision<Dim>::only_label(const SurfacePiece<Dim>& piece, bool near) {
  const Vec<Dim> middle = piece.middle();
  const int label = label_at(middle, piece.normal, near);
  if (!near && !has_regions_) {
    return label;
  }
  const auto is_same = [&](const Vec<Dim>& at) {
    return label_at(Vec<Dim>(at + 1e-6 * (middle - at)), piece.normal, near) == label;
  };
  const std::size_t count = piece.corners.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec<Dim>&corner = piece.corners[k], &next = piece.corners[(k + 1) % count];
    if (!is_same(corner) || !is_same(Vec<Dim>(0.5 * (corner + middle))) ||
        (Dim == 3 && !is_same(Vec<Dim>(0.5 * (corner + next))))) {
      return std::nullopt;
    }
  }
  return label;
}

template class SurfaceDivision<1>;
template class SurfaceDivision<2>;
template class SurfaceDivision<3>;

}  // namespace lapilli
