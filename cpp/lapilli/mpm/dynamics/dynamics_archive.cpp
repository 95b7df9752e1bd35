// What momentum needs to go on with the same bytes.
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/dynamics/dynamics.hpp"

namespace lapilli {

template <int Dim>
template <class Self, class Visit>
void Dynamics<Dim>::for_each_point_array(Self& self, const Visit& visit) {
  auto& data = self.data_;
  visit("mass", data.mass);
  visit("velocity", data.velocity);
  visit("stress", data.stress);
  const auto visit_optional = [&](const char* name, const auto& array) {
    if (array) {
      visit(name, *array);
    }
  };
  visit_optional("affine", data.affine);
  visit_optional("carried", data.carried);
  visit_optional("opened", data.opened);
  visit_optional("strain_rate", data.strain_rate);
  visit_optional("deformation", data.deformation);
  visit_optional("plastic", data.plastic);
  visit_optional("free_strain", data.free_strain);
}

template <int Dim>
template <class Self, class Visit>
void Dynamics<Dim>::for_each_part(Self& self, const Visit& visit) {
  visit("dynamics/state/", self.data_.states);
  visit("dynamics/strips", self.data_.order);
  if (self.loads_) {
    visit("dynamics/loads", *self.loads_);
  }
  if (self.obstacles_) {
    visit("dynamics/obstacles", *self.obstacles_);
  }
  if (self.contacts_) {
    visit("dynamics/fields", self.data_.fields);
    visit("dynamics/contacts", *self.contacts_);
  }
  if (self.wall_friction_) {
    visit("dynamics/walls", *self.wall_friction_);
  }
}

template <int Dim>
template <class Self, class Visit>
void Dynamics<Dim>::for_each_number(Self& self, const Visit& visit) {
  auto& flows = self.flows_;
  for (auto* number : {&flows.plastic, &flows.friction, &flows.strain, &flows.impact,
                       &flows.transfer, &flows.expansion, &flows.damping, &flows.gravity_changes,
                       &self.initial_energy_, &self.kinetic_, &self.speed_, &self.wave_speed_,
                       &self.drift_, &self.total_mass_, &self.strain_rate_, &self.ahead_}) {
    visit(*number);
  }
  for (auto* vector : {&flows.gravity, &flows.walls, &flows.damped, &self.data_.gravity,
                       &self.initial_momentum_}) {
    for (int axis = 0; axis < 3; ++axis) {
      visit((*vector)[axis]);
    }
  }
}

template <int Dim>
void Dynamics<Dim>::save(Archive& archive) const {
  for_each_point_array(*this, [&](const char* name, const PointArray& array) {
    archive.write(message("dynamics/", name), array.values());
  });
  for_each_part(*this, [&](const char* name, const auto& part) { part.save(archive, name); });
  std::vector<double> numbers;
  for_each_number(*this, [&](double number) { numbers.push_back(number); });
  archive.write("dynamics/account", numbers);
  archive.write("dynamics/watch", std::vector{watch_.stored(), watch_.largest(),
                                              static_cast<double>(watch_.steps_above())});
  archive.write("dynamics/open_energy", open_energy_.numbers());
  save_removed(archive);
  save_setting(archive);
}

/// What a run that goes on from this one asks of it, by body.
template <int Dim>
void Dynamics<Dim>::save_setting(Archive& archive) const {
  std::vector<double> density;
  for (const StressMaterial& material : data_.materials) {
    density.push_back(material.density);
  }
  archive.write("dynamics/body/density", density);
  archive.write("dynamics/body/spacing", spacing_);
  archive.write("dynamics/transfer", std::string(name_of(data_.settings.transfer)));
}

template <int Dim>
void Dynamics<Dim>::load(const Archive& archive) {
  for_each_point_array(*this, [&](const char* name, PointArray& array) {
    archive.read(message("dynamics/", name), array.values());
  });
  for_each_part(*this, [&](const char* name, auto& part) { part.load(archive, name); });
  std::vector<double> numbers;
  for_each_number(*this, [&](double) { numbers.push_back(0.0); });
  archive.read("dynamics/account", std::span<double>(numbers));
  auto next = numbers.begin();
  for_each_number(*this, [&](double& number) { number = *next++; });
  double watched[3];
  archive.read("dynamics/watch", std::span<double>(watched));
  watch_.restore(watched[0], watched[1], watched[2]);
  open_energy_.restore(archive.read_numbers("dynamics/open_energy"));
  load_removed(archive);
  ordering_ = data_.points.ordering();
}

template void Dynamics<2>::save(Archive&) const;
template void Dynamics<3>::save(Archive&) const;
template void Dynamics<2>::load(const Archive&);
template void Dynamics<3>::load(const Archive&);

}  // namespace lapilli
