#include "lapilli/geometry/lattice.hpp"

#include <cmath>

#include "lapilli/geometry/checks.hpp"

namespace lapilli {
Sites::Sites(const Shape& body, const Lattice& lattice, const FillOptions& options, int dimension)
    : dimension_(dimension),
      spacing_(lattice.spacing()),
      lower_(lattice.lower),
      fixed_(place(options.center)),
      turn_(rotation(options.degrees, Vec3::UnitZ())) {
  Bounds there = bounds(body);
  there.lower = there.lower.cwiseMax(options.reach.lower);
  there.upper = there.upper.cwiseMin(options.reach.upper).cwiseMax(there.lower);
  for (int axis = dimension; axis < 3; ++axis) {
    there.lower[axis] = there.upper[axis] = 0.0;
  }
  const Vec3 middle = 0.5 * (there.lower + there.upper);
  const Vec3 half = 0.5 * (there.upper - there.lower);
  const Vec3 center = fixed_ + turn_.transpose() * (middle - fixed_);
  const Vec3 reach = turn_.transpose().cwiseAbs() * half;
  double count = 1.0;
  for (int axis = 0; axis < dimension; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    // Half a millionth of a box more, so that sites on the surface are looked at.
    const double from = (center[axis] - reach[axis] - lower_[axis]) / spacing_ - 1e-6;
    const double to = (center[axis] + reach[axis] - lower_[axis]) / spacing_ + 1e-6;
    count *= std::max(0.0, to - from);
    require(std::abs(from) < 1e15 && std::abs(to) < 1e15 && count < 4e9, kind_of(body),
            ": more than 4e9 lattice sites of spacing ", spacing_,
            " m to look at: choose larger cells or a smaller body");
    first_[k] = static_cast<Index>(std::floor(from));
    last_[k] = static_cast<Index>(std::floor(to));
  }
}

double Sites::box_volume() const { return std::pow(spacing_, dimension_); }

Vec3 Sites::corner(const Site& site) const {
  Vec3 at = Vec3::Zero();
  for (int axis = 0; axis < dimension_; ++axis) {
    at[axis] = lower_[axis] + static_cast<double>(site[static_cast<std::size_t>(axis)]) * spacing_;
  }
  return at;
}

Vec3 Sites::middle(const Site& site) const {
  Vec3 at = Vec3::Zero();
  for (int axis = 0; axis < dimension_; ++axis) {
    const double steps = static_cast<double>(site[static_cast<std::size_t>(axis)]) + 0.5;
    at[axis] = lower_[axis] + steps * spacing_;
  }
  return at;
}

}  // namespace lapilli
