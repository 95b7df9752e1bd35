#include "lapilli/mpm/quasi_static/solid_state.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "lapilli/core/require.hpp"
#include "lapilli/materials/return_along.hpp"

namespace lapilli {
namespace {

std::vector<std::vector<StateVariable>> variables_of(const std::vector<Solid>& solids) {
  std::vector<std::vector<StateVariable>> all;
  for (const Solid& solid : solids) {
    all.push_back(state_variables(solid));
  }
  return all;
}

SymmetricTensor tensor_at(const double* c) { return {c[0], c[1], c[2], c[3], c[4], c[5]}; }

double largest_principal(const SymmetricTensor& tensor) {
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(tensor.matrix(), Eigen::EigenvaluesOnly);
  return principal.eigenvalues().cwiseAbs().maxCoeff();
}

}  // namespace

SolidState::SolidState(Points& points, const std::vector<Solid>& solids)
    : stress_(points, 6), states_(points, variables_of(solids)) {
  for (const Solid& solid : solids) {
    check(solid);
    elastic_.push_back(elastic_part(solid));
    laws_.push_back(law_of(solid));
    require(has_tangent(laws_.back()),
            "quasi_static needs the tangent of a solid, which a function does not give");
    can_yield_ = can_yield_ || yields(laws_.back());
  }
  for (Index p = 0; p < points.size(); ++p) {
    require(points.body()[p] >= 0 && points.body()[p] < static_cast<Index>(solids.size()), "body ",
            points.body()[p], " has no solid for quasi_static");
  }
  if (can_yield_) {
    strain_ = std::make_unique<PointArray>(points, 6);
  }
}

double SolidState::largest_stress(Index point) const {
  double largest = 0.0;
  for (int c = 0; c < 6; ++c) {
    largest = std::max(largest, std::abs(stress_[6 * point + c]));
  }
  return largest;
}

SymmetricTensor SolidState::stress(Index point) const {
  return tensor_at(stress_.data() + 6 * point);
}

SymmetricTensor SolidState::stress_after(Index point, Index body,
                                         const SymmetricTensor& strain) const {
  auto state = states_.read(body, point);
  return return_along(laws_[body], stress(point), stress_of(elastic_[body], strain), state.data());
}

bool SolidState::yields_after(Index point, Index body, const SymmetricTensor& strain) const {
  auto state = states_.read(body, point);
  const SymmetricTensor before = stress(point), more = stress_of(elastic_[body], strain);
  const SymmetricTensor elastic = added(before, more);
  const SymmetricTensor reached = return_along(laws_[body], before, more, state.data());
  constexpr double rounding = 1e-12;
  double size = 0.0, change = 0.0;
  for (int c = 0; c < 6; ++c) {
    size = std::max(size, std::abs(elastic[c]));
    change = std::max(change, std::abs(reached[c] - elastic[c]));
  }
  return change > rounding * size;
}

Stiffness SolidState::tangent_after(Index point, Index body, const SymmetricTensor& strain,
                                    double elastic_share) const {
  const Stiffness elastic = stiffness_of(elastic_[body]);
  auto state = states_.read(body, point);
  StressSlope slope;
  slope_along(laws_[body], stress(point), stress_of(elastic_[body], strain), state.data(), slope);
  const Stiffness tangent = slope * elastic;
  return elastic_share * elastic + (1.0 - elastic_share) * 0.5 * (tangent + tangent.transpose());
}

double SolidState::stiffness_left(Index point, Index body, const SymmetricTensor& strain) const {
  constexpr double least = 1e-3;  // of what slivers need to be held
  if (!yields(laws_[body])) {
    return 1.0;
  }
  const Mat3 stress = stress_after(point, body, strain).matrix();
  const LinearElastic& material = elastic_[body];
  const double nu = material.poissons_ratio;
  const Mat3 elastic =
      ((1.0 + nu) * stress - nu * stress.trace() * Mat3::Identity()) / material.youngs_modulus;
  const Mat3 whole = tensor_at(strain_->data() + 6 * point).matrix() + strain.matrix();
  const double size = whole.norm();
  return size > 0.0 ? std::clamp(elastic.norm() / size, least, 1.0) : 1.0;
}

void SolidState::strain(Index point, Index body, const SymmetricTensor& strain) {
  auto state = states_.read(body, point);
  const SymmetricTensor reached =
      return_along(laws_[body], stress(point), stress_of(elastic_[body], strain), state.data());
  states_.write(body, point, state.data());
  for (int c = 0; c < 6; ++c) {
    stress_[6 * point + c] = reached[c];
    if (strain_) {
      (*strain_)[6 * point + c] += strain[c];
    }
  }
}

/// From the stress where the law is elastic: it starts at zero.
double SolidState::largest_strain(const Points& points) const {
  double largest = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    if (strain_) {
      largest = std::max(largest, largest_principal(tensor_at(strain_->data() + 6 * p)));
      continue;
    }
    const LinearElastic& material = elastic_[points.body()[p]];
    const SymmetricTensor stress = this->stress(p);
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(stress.matrix(), Eigen::EigenvaluesOnly);
    const double nu = material.poissons_ratio;
    const Vec3 strain = ((1.0 + nu) * principal.eigenvalues().array() - nu * stress.trace()) /
                        material.youngs_modulus;
    largest = std::max(largest, strain.cwiseAbs().maxCoeff());
  }
  return largest;
}

std::vector<Field> SolidState::fields() {
  std::vector<Field> all{{"stress", "Pa", 6, stress_.values()}};
  for (Field& field : states_.fields()) {
    all.push_back(std::move(field));
  }
  return all;
}

void SolidState::save(Archive& archive) const {
  archive.write("quasi_static/stress", stress_.values());
  states_.save(archive, "quasi_static/state/");
  if (strain_) {
    archive.write("quasi_static/strain", std::as_const(*strain_).values());
  }
}

void SolidState::load(const Archive& archive) {
  archive.read("quasi_static/stress", stress_.values());
  states_.load(archive, "quasi_static/state/");
  if (strain_) {
    archive.read("quasi_static/strain", strain_->values());
  }
}

}  // namespace lapilli
