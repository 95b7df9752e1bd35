#include "lapilli/mpm/heat/nodal_enthalpy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/parallel.hpp"

namespace lapilli {

template <int Dim>
NodalEnthalpy<Dim>::NodalEnthalpy(const std::vector<HeatBody>& bodies, HeatPart<Dim>& part)
    : volume_(std::move(part.volume)),
      leads_(part.capacity.size(), 0),
      only_(part.capacity.size(), -1) {
  for (const std::size_t body : part.bodies) {
    enthalpy_.emplace_back(bodies[body].material);
    potential_.push_back(kirchhoff_potential(bodies[body].material));
    conducts_evenly_.push_back(!bodies[body].material.conductivity.varies());
  }
  for (std::size_t place = 0; place < leads_.size(); ++place) {
    leads_[place] = part.capacity[place] > 0.0 ? 1 : 0;
    int bodies_here = 0;
    for (std::size_t k = 0; k < volume_.size(); ++k) {
      if (volume_[k][place] != 0.0) {
        only_[place] = static_cast<int>(k);
        ++bodies_here;
      }
    }
    only_[place] = bodies_here == 1 ? only_[place] : -1;
  }
}

template <int Dim>
double NodalEnthalpy<Dim>::stored(Index place, double temperature) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < volume_.size(); ++k) {
    sum += volume_[k][place] * enthalpy_[k].at(temperature);
  }
  return sum;
}

template <int Dim>
RisingIntegral::Place NodalEnthalpy<Dim>::at(Index place, double stored) const {
  if (const int only = only_[place]; only >= 0) {
    const double volume = volume_[only][place];
    const RisingIntegral::Place found = enthalpy_[only].place(stored / volume);
    return {found.temperature, found.slope / volume};
  }
  // Between the temperatures that each body would have with the mean enthalpy; Newton's steps, the
  // halves of the bracket where they leave it.
  double volume = 0.0;
  for (const auto& own : volume_) {
    volume += own[place];
  }
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t k = 0; k < volume_.size(); ++k) {
    if (volume_[k][place] > 0.0) {
      const double alone = enthalpy_[k].place(stored / volume).temperature;
      low = std::min(low, alone);
      high = std::max(high, alone);
    }
  }
  constexpr int most = 100;
  double temperature = 0.5 * (low + high), slope = 0.0;
  for (int round = 0; round < most && high > low; ++round) {
    const double left = stored - this->stored(place, temperature);
    (left > 0.0 ? low : high) = temperature;
    slope = 0.0;
    for (std::size_t k = 0; k < volume_.size(); ++k) {
      slope += volume_[k][place] * enthalpy_[k].slope(temperature);
    }
    double next = temperature + left / slope;
    if (!(next > low && next < high)) {
      next = 0.5 * (low + high);
    }
    if (std::abs(next - temperature) <= 4e-16 * std::abs(temperature)) {
      break;
    }
    temperature = next;
  }
  const double left = stored - this->stored(place, temperature);
  const bool melts_here = std::abs(left) > 1e-9 * slope * std::max(1e-300, std::abs(temperature));
  return {temperature, melts_here || slope == 0.0 ? 0.0 : 1.0 / slope};
}

template <int Dim>
double NodalEnthalpy<Dim>::liquid_fraction(std::size_t body, Index place, double temperature,
                                           double stored) const {
  if (only_[place] >= 0) {
    return enthalpy_[body].liquid_fraction(temperature, stored / volume_[only_[place]][place]);
  }
  // What melts at once here and now shares what is left beyond the solids' heat.
  double latent = 0.0;
  for (std::size_t k = 0; k < volume_.size(); ++k) {
    latent += volume_[k][place] * enthalpy_[k].latent_at(temperature);
  }
  const double share = latent > 0.0 ? (stored - this->stored(place, temperature)) / latent : 0.0;
  const double own = enthalpy_[body].latent_at(temperature);
  return enthalpy_[body].liquid_fraction(temperature,
                                         enthalpy_[body].at(temperature) + share * own);
}

template <int Dim>
double NodalEnthalpy<Dim>::liquid_volume(std::span<const double> temperature,
                                         std::span<const double> stored) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < volume_.size(); ++k) {
    for (std::size_t place = 0; enthalpy_[k].melts() && place < leads_.size(); ++place) {
      if (leads_[place] != 0 && volume_[k][place] != 0.0) {
        sum += volume_[k][place] *
               liquid_fraction(k, static_cast<Index>(place), temperature[place], stored[place]);
      }
    }
  }
  return sum;
}

template <int Dim>
void NodalEnthalpy<Dim>::potentials(std::size_t body, std::span<const double> temperature,
                                    std::span<double> potential) const {
  if (conducts_evenly_[body]) {
    std::copy(temperature.begin(), temperature.end(), potential.begin());
    return;
  }
  const RisingIntegral& of = potential_[body];
  parallel_for(static_cast<Index>(temperature.size()),
               [&](Index place) { potential[place] = of.at(temperature[place]); });
}

template class NodalEnthalpy<1>;
template class NodalEnthalpy<2>;
template class NodalEnthalpy<3>;

}  // namespace lapilli
