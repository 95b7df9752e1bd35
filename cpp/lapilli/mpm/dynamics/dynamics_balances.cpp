// What momentum stores and shows: energies, momenta, balances and fields.
#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "lapilli/core/parallel.hpp"
#include "lapilli/mpm/dynamics/dynamics.hpp"
#include "lapilli/mpm/dynamics/point_values.hpp"

namespace lapilli {
namespace {

constexpr const char* momentum_names[] = {"momentum x", "momentum y", "momentum z"};

}  // namespace

template <int Dim>
Vec3 Dynamics<Dim>::linear_momentum() const {
  return parallel_sum(data_.points.size(), Vec3(Vec3::Zero()), [&](Index row) {
    Vec3 momentum = Vec3::Zero();
    momentum.head<Dim>() =
        data_.mass[row] * Eigen::Map<const Vec<Dim>>(data_.velocity.data() + row * Dim);
    return momentum;
  });
}

template <int Dim>
Vec3 Dynamics<Dim>::angular_momentum() const {
  return parallel_sum(data_.points.size(), Vec3(Vec3::Zero()), [&](Index row) {
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero();
    place.head<Dim>() = data_.points.template position<Dim>(row);
    velocity.head<Dim>() = Eigen::Map<const Vec<Dim>>(data_.velocity.data() + row * Dim);
    Vec3 moment = place.cross(velocity);
    if (data_.affine) {
      // sum S (x_I - x) x v_I: the antisymmetric part of sum v_I (x_I - x) S.
      const Vec<Dim> moments = data_.settings.transfer == VelocityTransfer::apic
                                   ? Vec<Dim>(Vec<Dim>::Ones())
                                   : second_moments(data_, row);
      Mat3 b = Mat3::Zero();
      for (int axis = 0; axis < Dim; ++axis) {
        for (int along = 0; along < Dim; ++along) {
          b(axis, along) = (*data_.affine)[(row * Dim + axis) * Dim + along] * moments[along];
        }
      }
      moment += Vec3(b(2, 1) - b(1, 2), b(0, 2) - b(2, 0), b(1, 0) - b(0, 1));
    }
    return Vec3(data_.mass[row] * moment);
  });
}

template <int Dim>
Balance Dynamics<Dim>::energy_balance() const {
  const double elastic = elastic_energy_stored();
  const double stored = kinetic_ + potential_energy() + elastic;
  Balance energy{"energy",
                 "J",
                 initial_energy_,
                 stored,
                 {{"plastic", -flows_.plastic},
                  {"wall friction", -flows_.friction},
                  {"wall impact", -flows_.impact},
                  {"transfer", -flows_.transfer},
                  {"strain transfer", -flows_.strain}},
                 kinetic_ + elastic};
  if (data_.settings.outside == Outside::remove) {
    energy.entries.push_back({"removed points", -removed_.energy});
  }
  if (data_.settings.local_damping > 0.0) {
    energy.entries.push_back({"damping", -flows_.damping});
  }
  if (!data_.settings.gravity_factor.is_constant()) {
    energy.entries.push_back({"changes of gravity", flows_.gravity_changes});
  }
  if (data_.free_strain) {
    energy.entries.push_back({"expansion", flows_.expansion});
  }
  if (loads_) {
    std::ranges::copy(loads_->work_entries(), std::back_inserter(energy.entries));
  }
  if (obstacles_) {
    std::ranges::copy(obstacles_->work_entries(), std::back_inserter(energy.entries));
  }
  if (contacts_) {
    energy.entries.push_back({"contact friction", contacts_->friction()});
    energy.entries.push_back({"contact impact", contacts_->impact()});
  }
  return energy;
}

template <int Dim>
std::vector<Balance> Dynamics<Dim>::balances() const {
  std::vector<Balance> all = {energy_balance()};
  const Vec3 now = linear_momentum();
  for (int axis = 0; axis < Dim; ++axis) {
    all.push_back({momentum_names[axis],
                   "kg m/s",
                   initial_momentum_[axis],
                   now[axis],
                   {{"gravity", flows_.gravity[axis]}, {"walls", flows_.walls[axis]}},
                   total_mass_ * speed_});
    if (data_.settings.outside == Outside::remove) {
      all.back().entries.push_back({"removed points", -removed_.momentum[axis]});
    }
    if (data_.settings.local_damping > 0.0) {
      all.back().entries.push_back({"damping", flows_.damped[axis]});
    }
    if (loads_) {
      std::ranges::copy(loads_->impulse_entries(axis), std::back_inserter(all.back().entries));
    }
    if (obstacles_) {
      std::ranges::copy(obstacles_->impulse_entries(axis), std::back_inserter(all.back().entries));
    }
  }
  return all;
}

template <int Dim>
SurfaceView Dynamics<Dim>::surface() const {
  return loads_ ? loads_->surface() : SurfaceView{};
}

template <int Dim>
std::vector<std::pair<std::string, double>> Dynamics<Dim>::diagnostics() const {
  std::vector<std::pair<std::string, double>> all{{"kinetic energy", kinetic_},
                                                  {"elastic energy", elastic_energy_stored()},
                                                  {"potential energy", potential_energy()},
                                                  {"plastic dissipation", flows_.plastic},
                                                  {"wall friction", flows_.friction},
                                                  {"wall impact", flows_.impact},
                                                  {"transfer loss", flows_.transfer},
                                                  {"strain transfer loss", flows_.strain},
                                                  {"expansion work", flows_.expansion},
                                                  {"energy gained", energy_gained()},
                                                  {"load work", loads_ ? loads_->work() : 0.0}};
  if (data_.settings.local_damping > 0.0) {
    all.emplace_back("damping loss", flows_.damping);
  }
  if (data_.settings.outside == Outside::remove) {
    all.emplace_back("removed points", removed_.points);
    all.emplace_back("removed mass", removed_.mass);
  }
  if (loads_) {
    all.emplace_back("area ratio", loads_->area_ratio());
  }
  if (obstacles_) {
    std::ranges::copy(obstacles_->diagnostics(), std::back_inserter(all));
  }
  if (contacts_) {
    std::ranges::copy(contacts_->diagnostics(), std::back_inserter(all));
  }
  return all;
}

template <int Dim>
std::vector<std::string> Dynamics<Dim>::modelled() const {
  std::vector<std::string> all = described_contacts_;
  std::string averaged;
  for (std::size_t body = 0; data_.dilatation && body < data_.materials.size(); ++body) {
    if (data_.dilatation->of_body(static_cast<Index>(body))) {
      averaged += (averaged.empty() ? "" : ", ") + data_.materials[body].body;
    }
  }
  if (!averaged.empty()) {
    all.push_back("one dilatation a cell (b_bar) in " + averaged);
  }
  return all;
}

template <int Dim>
void Dynamics<Dim>::refresh_output() {
  const Index count = data_.points.size();
  output_stress_.resize(static_cast<std::size_t>(6 * count));
  output_density_.resize(static_cast<std::size_t>(count));
  parallel_for(count, [&](Index row) {
    const SymmetricTensor stress = stress_of(data_, row);
    std::copy(stress.components.begin(), stress.components.end(), output_stress_.data() + 6 * row);
    output_density_[row] = data_.mass[row] / data_.points.volume()[row];
  });
}

template <int Dim>
std::vector<Field> Dynamics<Dim>::fields() {
  if (output_density_.empty()) {
    refresh_output();
  }
  std::vector<Field> all{{"velocity", "m/s", Dim, data_.velocity.values()},
                         {"stress", "Pa", 6, output_stress_},
                         {"density", "kg/m^3", 1, output_density_}};
  std::ranges::copy(data_.states.fields(), std::back_inserter(all));
  return all;
}

template Vec3 Dynamics<2>::linear_momentum() const;
template Vec3 Dynamics<3>::linear_momentum() const;
template Vec3 Dynamics<2>::angular_momentum() const;
template Vec3 Dynamics<3>::angular_momentum() const;
template Balance Dynamics<2>::energy_balance() const;
template Balance Dynamics<3>::energy_balance() const;
template std::vector<Balance> Dynamics<2>::balances() const;
template std::vector<Balance> Dynamics<3>::balances() const;
template std::vector<std::pair<std::string, double>> Dynamics<2>::diagnostics() const;
template std::vector<std::pair<std::string, double>> Dynamics<3>::diagnostics() const;
template SurfaceView Dynamics<2>::surface() const;
template SurfaceView Dynamics<3>::surface() const;
template std::vector<std::string> Dynamics<2>::modelled() const;
template std::vector<std::string> Dynamics<3>::modelled() const;
template void Dynamics<2>::refresh_output();
template void Dynamics<3>::refresh_output();
template std::vector<Field> Dynamics<2>::fields();
template std::vector<Field> Dynamics<3>::fields();

}  // namespace lapilli
