// What momentum needs to go on with the same bytes.
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/dynamics/dynamics.hpp"

namespace lapilli {

template <int Dim>
void Dynamics<Dim>::save(Archive& archive) const {
  const auto keep = [&](const char* name, const PointArray& array) {
    archive.write(message("dynamics/", name), array.values());
  };
  keep("mass", data_.mass);
  keep("velocity", data_.velocity);
  keep("stress", data_.stress);
  if (data_.affine) {
    keep("affine", *data_.affine);
    keep("carried", *data_.carried);
  }
  if (data_.opened) {
    keep("opened", *data_.opened);
  }
  if (data_.strain_rate) {
    keep("strain_rate", *data_.strain_rate);
  }
  if (data_.deformation) {
    keep("deformation", *data_.deformation);
  }
  if (data_.plastic) {
    keep("plastic", *data_.plastic);
  }
  if (data_.free_strain) {
    keep("free_strain", *data_.free_strain);
  }
  data_.states.save(archive, "dynamics/state/");
  data_.order.save(archive, "dynamics/strips");
  if (loads_) {
    loads_->save(archive, "dynamics/loads");
  }
  if (obstacles_) {
    obstacles_->save(archive, "dynamics/obstacles");
  }
  if (contacts_) {
    data_.fields.save(archive, "dynamics/fields");
    contacts_->save(archive, "dynamics/contacts");
  }
  if (wall_friction_) {
    wall_friction_->save(archive, "dynamics/walls");
  }
  const double numbers[] = {
      flows_.plastic,      flows_.friction, flows_.strain,    flows_.impact,
      flows_.transfer,     initial_energy_, kinetic_,         speed_,
      wave_speed_,         drift_,          total_mass_,      flows_.expansion,
      strain_rate_,        watch_.stored(), watch_.largest(), ahead_,
      watch_.steps_above()};
  archive.write("dynamics/account", std::span<const double>(numbers));
  archive.write("dynamics/impulse/gravity", std::span<const double>(flows_.gravity.data(), 3));
  archive.write("dynamics/impulse/walls", std::span<const double>(flows_.walls.data(), 3));
  archive.write("dynamics/impulse/damping", std::span<const double>(flows_.damped.data(), 3));
  archive.write("dynamics/damping", flows_.damping);
  archive.write("dynamics/gravity", std::span<const double>(data_.gravity.data(), 3));
  archive.write("dynamics/gravity_changes", flows_.gravity_changes);
  archive.write("dynamics/impulse/initial", std::span<const double>(initial_momentum_.data(), 3));
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
  const auto fetch = [&](const char* name, PointArray& array) {
    archive.read(message("dynamics/", name), array.values());
  };
  fetch("mass", data_.mass);
  fetch("velocity", data_.velocity);
  fetch("stress", data_.stress);
  if (data_.affine) {
    fetch("affine", *data_.affine);
    fetch("carried", *data_.carried);
  }
  if (data_.opened) {
    fetch("opened", *data_.opened);
  }
  if (data_.strain_rate) {
    fetch("strain_rate", *data_.strain_rate);
  }
  if (data_.deformation) {
    fetch("deformation", *data_.deformation);
  }
  if (data_.plastic) {
    fetch("plastic", *data_.plastic);
  }
  if (data_.free_strain) {
    fetch("free_strain", *data_.free_strain);
  }
  data_.states.load(archive, "dynamics/state/");
  data_.order.load(archive, "dynamics/strips");
  if (loads_) {
    loads_->load(archive, "dynamics/loads");
  }
  if (obstacles_) {
    obstacles_->load(archive, "dynamics/obstacles");
  }
  if (contacts_) {
    data_.fields.load(archive, "dynamics/fields");
    contacts_->load(archive, "dynamics/contacts");
  }
  if (wall_friction_) {
    wall_friction_->load(archive, "dynamics/walls");
  }
  double numbers[17];
  archive.read("dynamics/account", std::span<double>(numbers));
  flows_.plastic = numbers[0];
  flows_.friction = numbers[1];
  flows_.strain = numbers[2];
  flows_.impact = numbers[3];
  flows_.transfer = numbers[4];
  initial_energy_ = numbers[5];
  kinetic_ = numbers[6];
  speed_ = numbers[7];
  wave_speed_ = numbers[8];
  drift_ = numbers[9];
  total_mass_ = numbers[10];
  flows_.expansion = numbers[11];
  strain_rate_ = numbers[12];
  watch_.restore(numbers[13], numbers[14], numbers[16]);
  ahead_ = numbers[15];
  archive.read("dynamics/impulse/gravity", std::span<double>(flows_.gravity.data(), 3));
  archive.read("dynamics/impulse/walls", std::span<double>(flows_.walls.data(), 3));
  archive.read("dynamics/impulse/damping", std::span<double>(flows_.damped.data(), 3));
  flows_.damping = archive.read_number("dynamics/damping");
  archive.read("dynamics/gravity", std::span<double>(data_.gravity.data(), 3));
  flows_.gravity_changes = archive.read_number("dynamics/gravity_changes");
  archive.read("dynamics/impulse/initial", std::span<double>(initial_momentum_.data(), 3));
  open_energy_.restore(archive.read_numbers("dynamics/open_energy"));
  load_removed(archive);
  ordering_ = data_.points.ordering();
}

template void Dynamics<2>::save(Archive&) const;
template void Dynamics<3>::save(Archive&) const;
template void Dynamics<2>::load(const Archive&);
template void Dynamics<3>::load(const Archive&);

}  // namespace lapilli
