// What momentum stores, in its points.
#include "lapilli/core/parallel.hpp"
#include "lapilli/mpm/dynamics/dynamics.hpp"
#include "lapilli/mpm/dynamics/point_values.hpp"

namespace lapilli {
namespace {

/// The norm of the elastic strain that bears a stress.
double strain_under(const SymmetricTensor& stress, const ElasticConstants& m) {
  const double share = m.lambda / (3.0 * m.lambda + 2.0 * m.shear_modulus);
  const Mat3 full = stress.matrix();
  return (full - share * full.trace() * Mat3::Identity()).norm() / (2.0 * m.shear_modulus);
}

}  // namespace

/// The affine matrix belongs to the place of the point at the start of the step.
template <int Dim>
double Dynamics<Dim>::kinetic_energy_of(Index row) const {
  double square = Eigen::Map<const Vec<Dim>>(data_.velocity.data() + row * Dim).squaredNorm();
  if (data_.affine) {
    const Vec<Dim> moments = second_moments(data_, row);
    const double* matrix = data_.affine->data() + row * Dim * Dim;
    for (int k = 0; k < Dim * Dim; ++k) {
      const double moment = moments[k % Dim];
      if (moment > 0.0) {
        square += matrix[k] * matrix[k] *
                  (data_.settings.transfer == VelocityTransfer::apic ? 1.0 / moment : moment);
      }
    }
  }
  return 0.5 * data_.mass[row] * square;
}

template <int Dim>
double Dynamics<Dim>::kinetic_energy() const {
  return parallel_sum(data_.points.size(), 0.0, [&](Index row) { return kinetic_energy_of(row); });
}

template <int Dim>
double Dynamics<Dim>::potential_energy() const {
  const Vec<Dim> gravity = data_.gravity.template head<Dim>();
  return parallel_sum(data_.points.size(), 0.0, [&](Index row) {
    return -data_.mass[row] * gravity.dot(data_.points.template position<Dim>(row));
  });
}

template <int Dim>
double Dynamics<Dim>::elastic_energy_of(Index row) const {
  return data_.points.volume()[row] *
         elastic_energy(data_.materials[data_.points.body()[row]], stress_of(data_, row));
}

template <int Dim>
double Dynamics<Dim>::elastic_energy_stored() const {
  return parallel_sum(data_.points.size(), 0.0, [&](Index row) { return elastic_energy_of(row); });
}

/// The mean over the points, weighted by the energy they store.
template <int Dim>
double Dynamics<Dim>::elastic_strain() const {
  const Vec3 sums = parallel_sum(data_.points.size(), Vec3(Vec3::Zero()), [&](Index row) -> Vec3 {
    const StressMaterial& material = data_.materials[data_.points.body()[row]];
    const double energy = elastic_energy_of(row);
    return {energy, energy * strain_under(stress_of(data_, row), material), 0.0};
  });
  return sums[0] > 0.0 ? sums[1] / sums[0] : 0.0;
}

template <int Dim>
void Dynamics<Dim>::look_at_energy(OpenEnergy& open) const {
  open.look(energy_balance(), watch_.largest(), elastic_strain(), energy_gained() - rounding());
}

/// At the end too, but not in the first steps, in which the half step between strain and force is
/// much of all there is.
template <int Dim>
OpenEnergy Dynamics<Dim>::energy_looked_at() const {
  OpenEnergy looked_at = open_energy_;
  if (looked_at.has_looked()) {
    look_at_energy(looked_at);
  }
  return looked_at;
}

template double Dynamics<2>::kinetic_energy() const;
template double Dynamics<3>::kinetic_energy() const;
template double Dynamics<2>::kinetic_energy_of(Index) const;
template double Dynamics<3>::kinetic_energy_of(Index) const;
template double Dynamics<2>::potential_energy() const;
template double Dynamics<3>::potential_energy() const;
template double Dynamics<2>::elastic_energy_of(Index) const;
template double Dynamics<3>::elastic_energy_of(Index) const;
template double Dynamics<2>::elastic_energy_stored() const;
template double Dynamics<3>::elastic_energy_stored() const;
template double Dynamics<2>::elastic_strain() const;
template double Dynamics<3>::elastic_strain() const;
template void Dynamics<2>::look_at_energy(OpenEnergy&) const;
template void Dynamics<3>::look_at_energy(OpenEnergy&) const;
template OpenEnergy Dynamics<2>::energy_looked_at() const;
template OpenEnergy Dynamics<3>::energy_looked_at() const;

}  // namespace lapilli
