#pragma once

#include "lapilli/core/describe.hpp"

namespace lapilli {

/// A viscous fluid whose stress is linear in the rate of strain, slightly heavier or lighter with
/// temperature (Boussinesq). Not modelled: viscosity that depends on temperature or rate.
struct Newtonian {
  static constexpr const char* kind = "newtonian";
  double density = 0.0;                // kg/m^3, at the reference temperature and no pressure
  double viscosity = 0.0;              // Pa s
  double thermal_expansion = 0.0;      // 1/K
  double reference_temperature = 0.0;  // K

  bool operator==(const Newtonian&) const = default;

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    visit(Key("density").unit("kg/m^3").positive().required().text("mass per volume at rest"),
          self.density);
    visit(Key("viscosity").unit("Pa s").non_negative().required().text("dynamic viscosity"),
          self.viscosity);
    visit(Key("thermal_expansion").unit("1/K").text("thermal expansion per volume"),
          self.thermal_expansion);
    visit(Key("reference_temperature")
              .unit("K")
              .text("at which the fluid has its density; 0: the mean of the fluid"),
          self.reference_temperature);
  }
};

/// Throws std::invalid_argument unless the density is positive, the viscosity not negative and all
/// numbers finite.
void check(const Newtonian& material);

}  // namespace lapilli
