#pragma once

#include <cmath>
#include <memory>
#include <random>

#include "lapilli/core/points.hpp"

/// Points laid out in the ways a fill or a run can leave them.
namespace lapilli::scenes {

struct Layout {
  double angle = 0.0;   // degrees the lattice is turned by, with the body
  double jitter = 0.0;  // largest displacement an axis over the spacing
  bool random = false;  // uniformly random places instead of a lattice
  unsigned seed = 1;
};

/// Uniform numbers in [0, 1), the same on every machine.
class Uniform {
 public:
  explicit Uniform(unsigned seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * (*this)(); }

 private:
  std::mt19937_64 engine_;
};

template <int Dim>
Mat<Dim> turn(double degrees) {
  Mat<Dim> rotation = Mat<Dim>::Identity();
  if constexpr (Dim > 1) {
    const double angle = degrees * std::acos(-1.0) / 180.0;
    rotation(0, 0) = rotation(1, 1) = std::cos(angle);
    rotation(1, 0) = std::sin(angle);
    rotation(0, 1) = -std::sin(angle);
  }
  return rotation;
}

/// Append points of spacing `spacing` wherever inside(y) holds, y in [-reach, reach]^Dim measured
/// from `centre` and turned with the layout.
template <int Dim, class Inside>
void append(Points& points, const Vec<Dim>& centre, double reach, double spacing,
            const Layout& layout, const Inside& inside, int body = 0) {
  Uniform uniform(layout.seed);
  const Mat<Dim> rotation = turn<Dim>(layout.angle);
  const auto count = static_cast<Index>(std::lround(2.0 * reach / spacing));
  const Index sites = Dim == 1 ? count : Dim == 2 ? count * count : count * count * count;
  std::vector<double> positions, volumes;
  for (Index site = 0; site < sites; ++site) {
    Vec<Dim> y, shift;
    Index rest = site;
    for (int axis = 0; axis < Dim; ++axis, rest /= count) {
      y[axis] = (static_cast<double>(rest % count) + 0.5) * spacing - reach;
      shift[axis] = layout.jitter * spacing * uniform.between(-1.0, 1.0);
      if (layout.random) {
        y[axis] = uniform.between(-reach, reach);
      }
    }
    if (inside(y)) {
      const Vec<Dim> x = centre + rotation * (y + shift);
      positions.insert(positions.end(), x.data(), x.data() + Dim);
      volumes.push_back(std::pow(spacing, Dim));
    }
  }
  points.append(positions, volumes, body);
}

template <int Dim, class Inside>
std::unique_ptr<Points> scatter(const Vec<Dim>& centre, double reach, double spacing,
                                const Layout& layout, const Inside& inside) {
  auto points = std::make_unique<Points>(Dim);
  append<Dim>(*points, centre, reach, spacing, layout, inside);
  return points;
}

}  // namespace lapilli::scenes
