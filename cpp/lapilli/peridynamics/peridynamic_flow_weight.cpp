// How a fluid bears its weight.
#include "lapilli/peridynamics/heat.hpp"
#include "lapilli/peridynamics/peridynamic_flow.hpp"

namespace lapilli {

template <int Dim>
double PeridynamicFlow<Dim>::share_of_gravity(Index point) const {
  const double warmer = heat_ != nullptr ? heat_->temperature()[point] - reference_ : 0.0;
  return -fluid_.thermal_expansion * warmer;
}

template <int Dim>
Vec<Dim> PeridynamicFlow<Dim>::middle() const {
  Vec<Dim> moment = Vec<Dim>::Zero();
  double mass = 0.0;
  for (Index i = 0; i < points_.size(); ++i) {
    if (fluid(i)) {
      moment += mass_[i] * points_.position<Dim>(i);
      mass += mass_[i];
    }
  }
  return moment / mass;
}

template <int Dim>
void PeridynamicFlow<Dim>::balance_density() {
  if (!borne_) {
    return;
  }
  std::vector<double> weights(static_cast<std::size_t>(families_.bonds()), 0.0);
  parallel_for(points_.size(), [&](Index i) {
    for (Index k = families_.begin(i); k < families_.end(i); ++k) {
      const Index j = families_.neighbour(k);
      weights[k] = weight_((points_.position<Dim>(j) - points_.position<Dim>(i)).norm());
    }
  });
  const std::vector<double> pressure = borne_->pressure(weights, std::as_const(points_).volume());
  for (Index i = 0; i < points_.size(); ++i) {
    density_[i] = pressure_.density_at(fluid_.density * pressure[i]);
  }
  gather_rows();
}

#define LAPILLI_INSTANTIATE(Dim)                                       \
  template double PeridynamicFlow<Dim>::share_of_gravity(Index) const; \
  template Vec<Dim> PeridynamicFlow<Dim>::middle() const;              \
  template void PeridynamicFlow<Dim>::balance_density();
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
