#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "lapilli/materials/mohr_coulomb.hpp"

using namespace lapilli;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Sorted, largest first; an iterative solver, unlike the one under test.
Vec3 principal(const SymmetricTensor& stress) {
  static Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(3);
  solver.compute(Eigen::MatrixXd(stress.matrix()), Eigen::EigenvaluesOnly);
  return {solver.eigenvalues()[2], solver.eigenvalues()[1], solver.eigenvalues()[0]};
}

/// How far a stress lies outside of the cone or above the cut-off, Pa.
double excess(const MohrCoulomb& m, const SymmetricTensor& stress) {
  const Vec3 s = principal(stress);
  const double sine = std::sin(m.friction_angle * degree),
               cosine = std::cos(m.friction_angle * degree);
  return std::max((1 + sine) * s[0] - (1 - sine) * s[2] - 2 * m.cohesion * cosine,
                  s[0] - m.tension_cutoff);
}

/// Elastic strain of a stress.
SymmetricTensor compliance(const LinearElastic& e, const SymmetricTensor& s) {
  const double nu = e.poissons_ratio, shear = 2.0 * e.shear_modulus();
  const double pressure = nu / (1.0 + nu) * s.trace();
  return {(s[0] - pressure) / shear,
          (s[1] - pressure) / shear,
          (s[2] - pressure) / shear,
          s[3] / shear,
          s[4] / shear,
          s[5] / shear};
}

double contract(const SymmetricTensor& a, const SymmetricTensor& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + 2 * (a[3] * b[3] + a[4] * b[4] + a[5] * b[5]);
}

SymmetricTensor minus(const SymmetricTensor& a, const SymmetricTensor& b) {
  SymmetricTensor c;
  for (int k = 0; k < 6; ++k) {
    c[k] = a[k] - b[k];
  }
  return c;
}

double norm(const SymmetricTensor& a) { return std::sqrt(contract(a, a)); }

struct Draw {
  std::mt19937_64 engine{7};
  double uniform(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(engine);
  }
  double power(double a, double b) { return std::pow(10.0, uniform(a, b)); }
  bool chance(double p) { return uniform(0, 1) < p; }

  MohrCoulomb material() {
    MohrCoulomb m;
    m.elastic = {2000.0, power(3, 11), chance(0.2) ? 0.4999 : uniform(-0.9, 0.4999)};
    m.friction_angle = chance(0.1) ? 0.0 : chance(0.1) ? 89.0 : uniform(0, 89);
    m.dilatancy_angle = chance(0.3)   ? 0.0
                        : chance(0.3) ? m.friction_angle
                                      : uniform(0, m.friction_angle);
    m.cohesion = chance(0.3) ? 0.0 : power(-6, 9);
    if (chance(0.4)) {
      m.tension_cutoff = chance(0.2) ? 0.0 : m.cohesion * power(-3, 3);
    }
    return m;
  }
  /// General, nearly isotropic, nearly axisymmetric, or diagonal.
  SymmetricTensor stress() {
    std::normal_distribution<double> normal;
    SymmetricTensor s;
    for (double& component : s.components) {
      component = normal(engine);
    }
    if (chance(0.3)) {
      const double gap = power(-18, -4);
      const Mat3 q =
          Eigen::AngleAxisd(uniform(0, 6), Vec3(s[0], s[1], s[2]).normalized()).toRotationMatrix();
      const double sign = chance(0.5) ? 1.0 : -1.0;
      const Vec3 values(sign, chance(0.5) ? sign * (1 - gap) : 0.3, 0.3 + gap);
      s = symmetric_part(Mat3(q * values.asDiagonal() * q.transpose()));
    } else if (chance(0.1)) {
      s[3] = s[4] = s[5] = 0.0;
    }
    const double size = power(-6, 12);
    for (double& component : s.components) {
      component *= size;
    }
    const double shift = chance(0.5) ? size * uniform(-3, 3) : 0.0;
    for (int k = 0; k < 3; ++k) {
      s[k] += shift;
    }
    return s;
  }
};

}  // namespace

TEST_CASE("every trial stress ends on or inside the yield surface and dissipates") {
  Draw draw;
  double worst = 0.0, least = 0.0;
  const int materials = 2000, trials = 500;  // a million
  std::vector<double> block(6 * trials);
  for (int k = 0; k < materials; ++k) {
    const MohrCoulomb m = draw.material();
    const MohrCoulombLaw constants(m);
    std::vector<SymmetricTensor> trial(trials);
    for (int row = 0; row < trials; ++row) {
      trial[row] = draw.stress();
      for (int c = 0; c < 6; ++c) {
        block[c * trials + row] = trial[row][c];
      }
    }
    return_stresses<6>(constants, block.data(), nullptr, trials, trials);
    for (int row = 0; row < trials; ++row) {
      SymmetricTensor s;
      for (int c = 0; c < 6; ++c) {
        s[c] = block[c * trials + row];
      }
      const double size = std::max(norm(trial[row]), m.cohesion);
      const SymmetricTensor strain = compliance(m.elastic, minus(trial[row], s));
      worst = std::max(worst, excess(m, s) / size);
      // Relative to the shear energy of the trial, whose rounding the difference carries.
      least = std::min(least, contract(s, strain) * 2 * m.elastic.shear_modulus() /
                                  contract(trial[row], trial[row]));
    }
  }
  INFO("worst excess " << worst << ", least dissipation " << least);
  CHECK(worst <= 1e-10);
  // 1e-16 of the trial, times the 1 / (1 - sin phi) = 7e3 that the cone's tip loses at 89 degrees.
  CHECK(least >= -1e-12);
}

TEST_CASE("with dilation equal to friction the return is the closest point in the energy norm") {
  // Optimality: (t - s) : C^-1 : (y - s) <= 0 for every admissible y.
  Draw draw;
  for (int k = 0; k < 3000; ++k) {
    MohrCoulomb m = draw.material();
    m.dilatancy_angle = m.friction_angle;
    m.cohesion = draw.uniform(0, 1);
    m.tension_cutoff = draw.chance(0.5) ? draw.uniform(0, 2) : m.tension_cutoff;
    m.elastic.youngs_modulus = 1.0;
    const MohrCoulombLaw constants(m);
    SymmetricTensor trial = draw.stress();
    const double size = norm(trial);
    for (double& component : trial.components) {
      component *= 3.0 / size;
    }
    const SymmetricTensor s = return_point(constants, trial, nullptr);
    const SymmetricTensor strain = compliance(m.elastic, minus(trial, s));
    for (int other = 0; other < 50; ++other) {
      SymmetricTensor y;
      for (int c = 0; c < 6; ++c) {
        y[c] = s[c] + draw.uniform(-1, 1);
      }
      if (excess(m, y) <= 0.0) {
        CAPTURE(m.friction_angle, m.elastic.poissons_ratio, m.cohesion, m.tension_cutoff);
        REQUIRE(contract(strain, minus(y, s)) <= 1e-10 * std::max(1.0, norm(strain)));
      }
    }
  }
}

TEST_CASE("plastic strain is a non-negative sum of the flow of the surfaces the stress ends on") {
  Draw draw;
  int plastic = 0;
  for (int k = 0; k < 5000; ++k) {
    MohrCoulomb m = draw.material();
    m.friction_angle = draw.uniform(1, 60);
    m.dilatancy_angle = draw.uniform(0, m.friction_angle);
    m.cohesion = draw.uniform(0, 1);
    m.tension_cutoff = draw.chance(0.5) ? draw.uniform(0, 1) : m.tension_cutoff;
    m.elastic = {1.0, 1.0, draw.uniform(-0.4, 0.45)};
    const double sine = std::sin(m.friction_angle * degree),
                 flow = std::sin(m.dilatancy_angle * degree);
    const double apex = m.cohesion / std::tan(m.friction_angle * degree);
    const double cutoff = std::min(m.tension_cutoff, apex);
    SymmetricTensor trial(draw.uniform(-4, 4), draw.uniform(-4, 4), draw.uniform(-4, 4), 0, 0, 0);
    const SymmetricTensor s = return_point(MohrCoulombLaw(m), trial, nullptr);
    const SymmetricTensor strain = compliance(m.elastic, minus(trial, s));
    Eigen::VectorXd increment(3);
    increment << strain[0], strain[1], strain[2];
    if (increment.norm() < 1e-12) {
      continue;
    }
    ++plastic;
    std::vector<Eigen::VectorXd> active;
    const auto unit = [](int axis) { return Eigen::VectorXd(Eigen::VectorXd::Unit(3, axis)); };
    for (int i = 0; i < 3; ++i) {
      if (s[i] > cutoff - 1e-9) {
        active.push_back(unit(i));
      }
      for (int j = 0; j < 3; ++j) {
        if (i != j && (1 + sine) * s[i] - (1 - sine) * s[j] >
                          2 * m.cohesion * std::cos(m.friction_angle * degree) - 1e-9) {
          active.push_back((1 + flow) * unit(i) - (1 - flow) * unit(j));
        }
      }
    }
    // Some three of the active directions (repeats allowed) must carry the increment.
    double best = 1e9;
    for (const Eigen::VectorXd& a : active) {
      for (const Eigen::VectorXd& b : active) {
        for (const Eigen::VectorXd& c : active) {
          Eigen::MatrixXd directions(3, 3);
          directions << a, b, c;
          const Eigen::VectorXd share =
              directions.completeOrthogonalDecomposition().solve(increment).cwiseMax(0.0);
          best = std::min(best, (directions * share - increment).norm());
        }
      }
    }
    CAPTURE(m.friction_angle, m.dilatancy_angle, m.cohesion, cutoff, trial[0], trial[1], trial[2],
            s[0], s[1], s[2]);
    REQUIRE(best <= 1e-9);
  }
  REQUIRE(plastic > 2000);
}

TEST_CASE("plane strain and the full form agree, alone and in blocks") {
  Draw draw;
  for (int k = 0; k < 500; ++k) {
    const MohrCoulombLaw constants(draw.material());
    const int rows = 7;  // a quad and a rest
    std::vector<double> full(6 * rows), plane(4 * rows);
    double size = 0.0;
    std::vector<SymmetricTensor> alone;
    for (int row = 0; row < rows; ++row) {
      SymmetricTensor s = draw.stress();
      s[4] = s[5] = 0.0;
      size = std::max(size, norm(s));
      for (int c = 0; c < 6; ++c) {
        full[c * rows + row] = s[c];
      }
      for (int c = 0; c < 4; ++c) {
        plane[c * rows + row] = s[c];
      }
      alone.push_back(return_point(constants, s, nullptr));
    }
    return_stresses<6>(constants, full.data(), nullptr, rows, rows);
    return_stresses<4>(constants, plane.data(), nullptr, rows, rows);
    for (int row = 0; row < rows; ++row) {
      for (int c = 0; c < 6; ++c) {
        REQUIRE(full[c * rows + row] == alone[row][c]);  // the same arithmetic in both forms
      }
      for (int c = 0; c < 4; ++c) {
        REQUIRE(std::abs(full[c * rows + row] - plane[c * rows + row]) <= 1e-12 * size);
      }
    }
  }
}
