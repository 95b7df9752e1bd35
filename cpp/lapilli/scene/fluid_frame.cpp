#include "lapilli/scene/fluid_frame.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "lapilli/geometry/support.hpp"
#include "lapilli/scene/body_points.hpp"
#include "lapilli/scene/build_peridynamics.hpp"

namespace lapilli {
namespace {

/// How far lengths are from whole spacings: sum of squares, in spacings.
double misfit(const std::vector<double>& lengths, double spacing) {
  double sum = 0.0;
  for (const double length : lengths) {
    const double gap = std::remainder(length / spacing, 1.0);
    sum += gap * gap;
  }
  return sum;
}

/// A spacing near the one asked for of which all lengths are multiples, or the best there is within
/// a tenth: gaps of a fraction of a spacing between particles and wall shift a boundary layer.
double fitting_spacing(const std::vector<double>& lengths, double asked) {
  constexpr double fits = 1e-12, widest = 1.1;
  double best = asked, least = misfit(lengths, asked);
  if (least < fits) {
    return asked;
  }
  for (const double length : lengths) {
    const double count = length / asked;
    for (double n = std::ceil(count / widest); n >= 1.0 && n <= count * widest; n += 1.0) {
      const double spacing = length / n, change = spacing / asked - 1.0;
      const double cost = misfit(lengths, spacing) + change * change;
      if (cost < least) {
        least = cost;
        best = spacing;
      }
    }
  }
  return best;
}

std::vector<double> coordinates(const Vec3& at, int dimension) {
  return {at.data(), at.data() + dimension};
}

}  // namespace

FluidFrame::FluidFrame(const Scene& scene, int points_per_axis) {
  lattice_.lower = place(scene.grid.lower);
  lattice_.cell = scene.grid.cell;
  lattice_.points_per_axis = points_per_axis;
  const std::optional<Shape> shape = placed_shape(scene.bodies.front());
  if (shape && flows(scene)) {
    follow(*shape);
    fit_lattice(*shape, dimension_of(scene));
  }
}

// at = origin + turn x, motion by motion from the outermost one inwards.
void FluidFrame::follow(const Shape& shape) {
  if (const auto* turned = std::get_if<Rotated>(&shape)) {
    const Vec3 center = place(turned->center);
    const Mat3 matrix = turned->matrix();
    origin_ += turn_ * (center - matrix * center);
    turn_ = turn_ * matrix;
    follow(*turned->shape);
  } else if (const auto* moved = std::get_if<Translated>(&shape)) {
    origin_ += turn_ * place(moved->by);
    follow(*moved->shape);
  }
}

void FluidFrame::fit_lattice(const Shape& shape, int dimension) {
  const TightBounds there = tight_bounds(seen_from_here(shape, dimension));
  if (!there.is_tight) {
    return;
  }
  const Vec3 size = there.box.upper - there.box.lower;
  std::vector<double> lengths;
  std::copy_if(size.data(), size.data() + dimension, std::back_inserter(lengths),
               [](double length) { return std::isfinite(length); });
  const double spacing = fitting_spacing(lengths, lattice_.spacing());
  lattice_.cell = spacing * lattice_.points_per_axis;
  for (int axis = 0; axis < dimension; ++axis) {
    if (!std::isfinite(size[axis])) {
      continue;
    }
    const double middle = 0.5 * (there.box.lower[axis] + there.box.upper[axis]);
    const double first = middle - 0.5 * spacing * std::round(size[axis] / spacing);
    const double shift = std::remainder(first - lattice_.lower[axis], spacing);
    // A body that fits the lattice of the grid stays on it, to the last digit.
    lattice_.lower[axis] += std::abs(shift) > 1e-9 * spacing ? shift : 0.0;
  }
}

Shape FluidFrame::seen_from_here(const Shape& shape, int dimension) const {
  Shape seen = shape;
  if (!origin_.isZero(0.0)) {
    Translated moved;
    moved.shape = seen;
    moved.by = coordinates(-origin_, dimension);
    seen = Shape(moved);
  }
  if (!turn_.isIdentity(0.0)) {
    const Eigen::AngleAxisd back(turn_.transpose());
    Rotated turned;
    turned.shape = seen;
    turned.degrees = back.angle() * 180.0 / std::numbers::pi;
    turned.axis = coordinates(back.axis(), 3);
    seen = Shape(turned);
  }
  return seen;
}

Bounds FluidFrame::seen_from_here(const Bounds& box, int dimension) const {
  Bounds seen;
  seen.lower = here(box.lower);
  seen.upper = seen.lower;
  for (int corner = 1; corner < 1 << dimension; ++corner) {
    Vec3 at = box.lower;
    for (int axis = 0; axis < dimension; ++axis) {
      at[axis] = (corner >> axis & 1) != 0 ? box.upper[axis] : box.lower[axis];
    }
    seen.lower = seen.lower.cwiseMin(here(at));
    seen.upper = seen.upper.cwiseMax(here(at));
  }
  return seen;
}

FilledPoints FluidFrame::fill(const Shape& shape, FillOptions options, int dimension) const {
  options.within = seen_from_here(options.within, dimension);
  const Vec3 margin = Vec3::Constant(lattice_.cell);
  options.reach = {options.within.lower - margin, options.within.upper + margin};
  FilledPoints points =
      lapilli::fill(seen_from_here(shape, dimension), lattice_, options, dimension);
  if (turn_.isIdentity(0.0) && origin_.isZero(0.0)) {
    return points;
  }
  points.move([&](const Vec3& at) { return Vec3(origin_ + turn_ * at); });
  return points;
}

std::array<long, 3> FluidFrame::site(const Vec3& at) const {
  const Vec3 box = ((here(at) - lattice_.lower) / lattice_.spacing()).array().floor();
  return {std::lround(box[0]), std::lround(box[1]), std::lround(box[2])};
}

}  // namespace lapilli
