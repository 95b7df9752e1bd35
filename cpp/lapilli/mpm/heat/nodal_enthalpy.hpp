#pragma once

#include <span>
#include <vector>

#include "lapilli/materials/enthalpy.hpp"
#include "lapilli/mpm/heat/heat_part.hpp"

namespace lapilli {

/// The heat that the nodes of a part hold, where it does not grow in proportion to the temperature:
/// the sum of volume times enthalpy over the bodies at a node.
template <int Dim>
class NodalEnthalpy {
 public:
  NodalEnthalpy() = default;
  /// Takes the volumes of the part over.
  NodalEnthalpy(const std::vector<HeatBody>& bodies, HeatPart<Dim>& part);

  bool leads(Index place) const { return leads_[place] != 0; }
  /// Heat of a node that leads at a temperature, J; that of the solid where it melts at once.
  double stored(Index place, double temperature) const;
  /// The temperature (K) of a node that leads and holds `stored` (J), and how it rises with it
  /// (K/J).
  RisingIntegral::Place at(Index place, double stored) const;
  /// The share of body number `body` of the part that is liquid at a node.
  double liquid_fraction(std::size_t body, Index place, double temperature, double stored) const;
  /// Volume that is liquid, m^dim, of nodes with these temperatures and heats.
  double liquid_volume(std::span<const double> temperature, std::span<const double> stored) const;

  /// Kirchhoff's potential of body number `body` of the part, by place, K.
  void potentials(std::size_t body, std::span<const double> temperature,
                  std::span<double> potential) const;

 private:
  std::vector<Enthalpy> enthalpy_;           // by body of the part
  std::vector<RisingIntegral> potential_;    //
  std::vector<bool> conducts_evenly_;        // whether the potential is the temperature
  std::vector<std::vector<double>> volume_;  // by body and place, m^dim
  std::vector<unsigned char> leads_;         // by place
  std::vector<int> only_;  // by place: the one body there, -1 where there are several
};

}  // namespace lapilli
