// A cube of 4 cells, turned about three axes, between six rollers, one of which is moved: uniaxial
// strain. Beyond the paper.
#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "lapilli/geometry/cell_fill.hpp"
#include "quasi_static/scenes.hpp"

using namespace lapilli;
using namespace lapilli::test;

namespace {

struct CubeErrors {
  double displacement = 0.0, stress = 0.0, volume = 0.0;
};

CubeErrors solve_cube(const Mat3& turn, Enforcement form) {
  const double size = 4.0;
  const Vec3 origin(0.31, 0.17, 0.23);
  Vec3 low = Vec3::Constant(1e300), high = -low;
  for (int k = 0; k < 8; ++k) {
    const Vec3 corner = origin + size * (turn * Vec3(k & 1, (k >> 1) & 1, (k >> 2) & 1));
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = std::floor(low[axis]) - 1.0;
    high[axis] = std::ceil(high[axis]) + 1.0;
  }
  QuasiStaticSettings settings;
  settings.enforcement = form;
  for (int axis = 0; axis < 3; ++axis) {
    for (int end : {0, 1}) {
      const Vec3 at = origin + end * size * turn.col(axis);
      const Vec3 out = (end ? 1.0 : -1.0) * turn.col(axis);
      const HalfSpace half{{at[0], at[1], at[2]}, {out[0], out[1], out[2]}};
      SupportSettings wall{"side", HeldMotion::roller, {half, true, {}, {}}, {}};
      if (axis == 0 && end == 1) {
        for (int k = 0; k < 3; ++k) {
          wall.displacement.push_back(Table{{0.0, 1.0}, {0.0, 0.01 * size * turn(k, 0)}});
        }
      }
      settings.supports.push_back(wall);
    }
  }
  Points points(3);
  const Eigen::AngleAxisd angle(turn);
  Shape cube = Rotated{Shape(Box{{origin[0], origin[1], origin[2]},
                                 {origin[0] + size, origin[1] + size, origin[2] + size}}),
                       angle.angle() * 180.0 / std::numbers::pi,
                       {origin[0], origin[1], origin[2]},
                       {angle.axis()[0], angle.axis()[1], angle.axis()[2]}};
  const FilledPoints filled = fill_cells(cube, Lattice{low, 1.0, 1}, {}, 3);
  points.append(filled.position, filled.volume, 0);
  const std::vector<double> start = filled.position;
  QuasiStatic<3> physics(points, Grid<3>(low, high, 1.0), ShapeFunction::linear, {elastic},
                         settings);
  physics.advance({0.0, 1.0, 0});
  Mat3 strain = Mat3::Zero();
  strain(0, 0) = 0.01;
  const Mat3 exact = stress_of(elastic, symmetric_part(turn * strain * turn.transpose())).matrix();
  CubeErrors errors;
  for (Index p = 0; p < points.size(); ++p) {
    const double v = filled.volume[static_cast<std::size_t>(p)];  // as it was filled
    const Vec3 x = Eigen::Map<const Vec3>(start.data() + 3 * p);
    const Vec3 u = Eigen::Map<const Vec3>(physics.displacement().data() + 3 * p);
    const double* s = physics.stress().data() + 6 * p;
    const Mat3 stress = SymmetricTensor(s[0], s[1], s[2], s[3], s[4], s[5]).matrix();
    const Vec3 there = 0.01 * turn.col(0).dot(x - origin) * turn.col(0);
    errors.volume += v;
    errors.displacement += v * (u - there).norm() / (0.01 * size) / 64.0;
    errors.stress += v * (stress - exact).norm() / exact.norm() / 64.0;
  }
  return errors;
}

Mat3 about_three_axes() {
  const double degree = std::numbers::pi / 180.0;
  return (Eigen::AngleAxisd(40.0 * degree, Vec3::UnitZ()) *
          Eigen::AngleAxisd(30.0 * degree, Vec3::UnitY()) *
          Eigen::AngleAxisd(20.0 * degree, Vec3::UnitX()))
      .toRotationMatrix();
}

}  // namespace

TEST_CASE("turned cube: clipped points fill it exactly") {
  const CubeErrors errors = solve_cube(about_three_axes(), Enforcement::mean_gap);
  CHECK(errors.volume == Approx(64.0).epsilon(1e-12));
}

TEST_CASE("turned cube: passes the patch test about one and three axes") {
  // Rounding times the stiffness ratio, as in the plane; one centroid point a cell leaves 2.4e-3.
  const double degree = std::numbers::pi / 180.0;
  const Mat3 about_z = Eigen::AngleAxisd(30.0 * degree, Vec3::UnitZ()).toRotationMatrix();
  for (const Mat3& turn : {about_z, about_three_axes()}) {
    for (Enforcement form : {Enforcement::mean_gap, Enforcement::literal}) {
      const CubeErrors errors = solve_cube(turn, form);
      INFO(name_of(form) << ": ru " << errors.displacement << ", rs " << errors.stress);
      CHECK(errors.displacement <= 1e-8);
      CHECK(errors.stress <= 1e-8);
    }
  }
}
