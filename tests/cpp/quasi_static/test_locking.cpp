// Nearly incompressible bodies: as right as others on the same grid.
#include <catch2/catch.hpp>

#include "lapilli/geometry/cell_fill.hpp"
#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

constexpr double inner = 1.0, outer = 2.5, pressure = 1e-3;

/// Error of the radial displacement of a quarter ring (eighth of a hollow sphere) under pressure
/// from inside, over its largest value; all on defaults, on rollers at its flat sides.
template <int Dim>
double lame_error(double poisson, double cell, ShapeFunction shape_function) {
  const LinearElastic material{1e-9, 1.0, poisson};
  const double off = 0.37 * cell, reach = outer + 2.0 * cell;
  const auto vector = [](double value) { return std::vector<double>(Dim, value); };
  Shape hole, ball;
  if constexpr (Dim == 2) {
    hole = Disk{vector(off), inner};
    ball = Disk{vector(off), outer};
  } else {
    hole = Sphere{vector(off), inner};
    ball = Sphere{vector(off), outer};
  }
  const Shape part = Intersection{{Difference{ball, {hole}}, Box{vector(off), vector(4.0)}}};
  const double cells = std::ceil(reach / cell) + 2.0;
  const Grid<Dim> grid(Vec<Dim>::Constant(-2.0 * cell), Vec<Dim>::Constant((cells - 2.0) * cell),
                       cell);
  Points points(Dim);
  const FilledPoints filled =
      fill_cells(part, Lattice{Vec3::Constant(-2.0 * cell), cell, 2}, {}, Dim);
  points.append(filled.position, filled.volume, 0);
  QuasiStaticSettings settings;
  for (int axis = 0; axis < Dim; ++axis) {
    std::vector<double> out = vector(0.0);
    out[axis] = -1.0;
    settings.supports.push_back(
        {"flat", HeldMotion::roller, {HalfSpace{vector(off), out}, true, {}, {}}, {}});
  }
  TractionSettings load{"load", {hole, false, {}, {}}, {}};
  load.pressure = pressure;
  settings.tractions = {load};
  QuasiStatic<Dim> physics(points, grid, shape_function, {material}, settings, {part});
  physics.advance({0.0, 1.0, 0});
  const double growth = std::pow(outer / inner, Dim) - 1.0;
  const double stretch = Dim == 2 ? (1.0 + poisson) * (1.0 - 2.0 * poisson) : 1.0 - 2.0 * poisson;
  const double turned = Dim == 2 ? 1.0 + poisson : 0.5 * (1.0 + poisson);
  const auto exact = [&](double r) {
    return pressure / growth * (stretch * r + turned * std::pow(outer, Dim) / std::pow(r, Dim - 1));
  };
  double squares = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<Dim> u = Eigen::Map<const Vec<Dim>>(physics.displacement().data() + Dim * p);
    const Vec<Dim> x = points.position<Dim>(p) - u - Vec<Dim>::Constant(off);
    squares += std::pow((u - exact(x.norm()) * x.normalized()).norm() / exact(inner), 2);
  }
  return std::sqrt(squares / static_cast<double>(points.size()));
}

/// Mean deflection of the free end of a cantilever of 12 x 3 turned by 30 degrees under its weight,
/// over that of a beam with shear (Timoshenko, plane strain).
double tip_share(double poisson, double cell, ShapeFunction shape_function) {
  const double length = 12.0, height = 3.0, weight = 1e-6;
  const LinearElastic material{1e-9, 1.0, poisson};
  const Rectangle beam = Rectangle::turned(30.0, {0.3 * cell, 0.1 * cell}, length, height);
  const Grid<2> grid = grid_around(beam.corners(), cell);
  Points points(2);
  fill_clipped(points, grid, polygon(beam.corners()), 2);
  QuasiStaticSettings settings;
  const Corners c = beam.corners();
  settings.supports = {{"end", HeldMotion::fixed, {{}, false, numbers({c[3], c[0]}), {}}, {}}};
  settings.body_force = {-weight * beam.e2[0], -weight * beam.e2[1]};
  QuasiStatic<2> physics(points, grid, shape_function, {material}, settings);
  physics.advance({0.0, 1.0, 0});
  double sum = 0.0, count = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    const Vec<2> u = Eigen::Map<const Vec<2>>(physics.displacement().data() + 2 * p);
    if (beam.local(points.position<2>(p) - u)[0] > length - 0.5 * cell) {
      sum -= u.dot(beam.e2);
      count += 1.0;
    }
  }
  const double plane = 1.0 / (1.0 - poisson * poisson), moment = std::pow(height, 3) / 12.0;
  const double shear = 5.0 / 6.0 * height * material.shear_modulus();
  const double at = length - 0.25 * cell, load = weight * height;
  const double bent = load * at * at * (6.0 * length * length - 4.0 * length * at + at * at) /
                      (24.0 * plane * moment);
  return sum / count / (bent + load * (length * at - 0.5 * at * at) / shear);
}

}  // namespace

TEST_CASE("nearly incompressible rings are as right as others") {
  for (const ShapeFunction shape : {ShapeFunction::linear, ShapeFunction::gimp}) {
    double before = 1.0;
    for (const double cell : {0.25, 0.125}) {
      const double soft = lame_error<2>(0.3, cell, shape);
      const double hard = lame_error<2>(0.4999, cell, shape);
      INFO("cell " << cell << ": " << soft << " at 0.3, " << hard << " at 0.4999");
      CHECK(hard < 1.5 * soft);
      CHECK(hard < 0.35 * before);  // second order
      before = hard;
    }
    CHECK(before < 6e-3);
  }
}

TEST_CASE("nearly incompressible hollow spheres are as right as others") {
  const double soft = lame_error<3>(0.3, 0.5, ShapeFunction::linear);
  const double hard = lame_error<3>(0.4999, 0.5, ShapeFunction::linear);
  INFO(soft << " at 0.3, " << hard << " at 0.4999");
  CHECK(hard < 1.5 * soft);
}

TEST_CASE("nearly incompressible cantilevers bend as others") {
  for (const ShapeFunction shape : {ShapeFunction::linear, ShapeFunction::gimp}) {
    // Shares of fitted quadratic elements: a clamped end holds the beam across, too.
    const double soft = 1.0 - tip_share(0.3, 0.5, shape) / 0.9891;
    const double hard = 1.0 - tip_share(0.4999, 0.5, shape) / 0.9529;
    INFO("too stiff by " << soft << " at 0.3, " << hard << " at 0.4999");
    CHECK(hard < 1.5 * soft);
    CHECK(std::abs(hard) < 0.05);
  }
}
