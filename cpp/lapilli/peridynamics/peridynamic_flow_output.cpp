#include <cmath>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/peridynamics/heat.hpp"
#include "lapilli/peridynamics/peridynamic_flow.hpp"

namespace lapilli {
namespace {

// Measured on cavities of Ra 1e3 to 1e6: too much heat by this share of the noise squared times
// what motion carries of it, and the noise falls as the spacing to the power 1.4.
constexpr double excess_heat = 0.5;
constexpr double coarse_excess = 0.03, resolved_excess = 0.02;
constexpr double half_carried = 8.0;  // Peclet number where motion carries half of the heat

// Measured in cavities with a moving lid, Reynolds numbers 10 to 400 on 10 to 36 points: extreme
// velocities are off by this share of the noise, which falls with the spacing.
constexpr double velocity_off = 0.3;
constexpr double coarse_velocity = 0.05, resolved_velocity = 0.04;

double two_digits(double number) {
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1.0);
  return unit * std::floor(number / unit);
}

}  // namespace

template <int Dim>
void PeridynamicFlow<Dim>::refresh_output() {
  for (Index i = 0; i < points_.size(); ++i) {
    pressure_field_[i] = pressure_(density_[i]);
  }
  if (settings_.buoyancy == Buoyancy::full) {
    // The pressure of the uniform weight balances it wherever points are: neither is in the sums.
    const Vec<Dim> from = middle();
    for (Index i = 0; i < points_.size(); ++i) {
      pressure_field_[i] += fluid_.density * gravity_.dot(points_.position<Dim>(i) - from);
    }
  }
}

template <int Dim>
std::vector<Field> PeridynamicFlow<Dim>::fields() {
  return {{"velocity", "m/s", Dim, velocity_.values()},
          {"density", "kg/m^3", 1, density_.values()},
          {"pressure", "Pa", 1, pressure_field_.values()}};
}

template <int Dim>
std::vector<std::pair<std::string, double>> PeridynamicFlow<Dim>::diagnostics() const {
  const auto [low, high] = density_variation();
  return {
      {"velocity_noise", velocity_noise()}, {"least_density_variation", low},
      {"greatest_density_variation", high}, {"smallest_spacing", smallest_spacing()},
      {"sound_speed", sound_speed_},        {"family_searches", static_cast<double>(searches())}};
}

template <int Dim>
typename PeridynamicFlow<Dim>::Pace PeridynamicFlow<Dim>::pace() const {
  const Vec<Dim> vessel = vessel_velocity<Dim>(*walls_);
  double squared = 0.0, volume = 0.0;
  for (Index i = 0; i < points_.size(); ++i) {
    if (fluid(i)) {
      const Eigen::Map<const Vec<Dim>> own(velocity_.data() + i * Dim);
      squared += points_.volume()[i] * (own - vessel).squaredNorm();
      volume += points_.volume()[i];
    }
  }
  return {std::sqrt(squared / volume), std::pow(volume, 1.0 / Dim)};
}

template <int Dim>
std::vector<Note> PeridynamicFlow<Dim>::warnings() const {
  std::vector<Note> all;
  if (two_field_) {
    all.push_back(note(
        "peridynamics.comparison-laplacian", "flow.laplacian = \"", name_of(settings_.laplacian),
        "\" is there for comparison: between walls 12 points apart it flows 40 % or more too "
        "fast; leave it out"));
  }
  // What stands still has nothing but noise, and what has hardly moved is a start.
  const Pace now = pace();
  if (now.speed * age_ <= 0.25 * now.width) {
    return all;
  }
  const double noise = velocity_noise();
  if (heat_ == nullptr) {
    const double off = velocity_off * noise;
    if (off <= coarse_velocity) {
      return all;
    }
    all.push_back(note("peridynamics.coarse-velocity",
                       "the points are too few for this flow: neighbours do not share ",
                       std::round(100.0 * noise), " % of the velocity, which may be off by about ",
                       std::round(100.0 * off), " %; take cells of ",
                       two_digits(walls_->spacing() * resolved_velocity / off), " m"));
    return all;
  }
  const double peclet = now.speed * now.width / heat_->material().diffusivity();
  const double excess =
      excess_heat * noise * noise * (1.0 - half_carried / (half_carried + peclet));
  if (excess <= coarse_excess) {
    return all;
  }
  all.push_back(note("peridynamics.coarse",
                     "the points are too few for the layers of this flow: neighbours do not share ",
                     std::round(100.0 * noise), " % of the velocity, and it may carry about ",
                     std::round(100.0 * excess), " % too much heat; take cells of ",
                     two_digits(walls_->spacing() * std::pow(resolved_excess / excess, 0.36)),
                     " m"));
  return all;
}

template <int Dim>
void PeridynamicFlow<Dim>::save(Archive& archive) const {
  archive.write("flow/velocity", velocity_.values());
  archive.write("flow/acceleration", acceleration_.values());
  archive.write("flow/density", density_.values());
  archive.write("flow/mass", mass_.values());
  archive.write("flow/shift", shift_.values());
  archive.write("flow/shifted", shifted_.values());
  const double numbers[] = {least_density_, most_density_,        smallest_spacing_,
                            sound_speed_,   started_ ? 1.0 : 0.0, age_};
  archive.write("flow/numbers", numbers);
  if (dissipation_) {
    archive.write("flow/dissipation", dissipation_->values());
  }
  families_.save(archive, "flow/families");
  if (heat_ == nullptr) {
    walls_->save(archive);
  }
}

template <int Dim>
void PeridynamicFlow<Dim>::load(const Archive& archive) {
  archive.read("flow/velocity", velocity_.values());
  archive.read("flow/acceleration", acceleration_.values());
  archive.read("flow/density", density_.values());
  archive.read("flow/mass", mass_.values());
  archive.read("flow/shift", shift_.values());
  archive.read("flow/shifted", shifted_.values());
  double numbers[6];
  archive.read("flow/numbers", numbers);
  least_density_ = numbers[0];
  most_density_ = numbers[1];
  smallest_spacing_ = numbers[2];
  sound_speed_ = numbers[3];
  pressure_.sound_speed = sound_speed_;
  started_ = numbers[4] == 1.0;
  age_ = numbers[5];
  if (dissipation_) {
    archive.read("flow/dissipation", dissipation_->values());
  }
  if (heat_ == nullptr) {
    walls_->load(archive);
  }
  families_.load(archive, "flow/families");
  reach_ = families_.reach(flow_piece);
  fastest_known_ = false;
}

#define LAPILLI_INSTANTIATE(Dim)                                                                  \
  template void PeridynamicFlow<Dim>::refresh_output();                                           \
  template std::vector<Field> PeridynamicFlow<Dim>::fields();                                     \
  template std::vector<std::pair<std::string, double>> PeridynamicFlow<Dim>::diagnostics() const; \
  template std::vector<Note> PeridynamicFlow<Dim>::warnings() const;                              \
  template void PeridynamicFlow<Dim>::save(Archive& archive) const;                               \
  template void PeridynamicFlow<Dim>::load(const Archive& archive);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
