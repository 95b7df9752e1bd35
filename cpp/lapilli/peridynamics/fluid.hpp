#pragma once

#include <vector>

#include "lapilli/core/value.hpp"
#include "lapilli/materials/newtonian.hpp"
#include "lapilli/materials/thermal.hpp"

namespace lapilli {

/// How one body of the fluid starts and what heats it.
struct FluidBody {
  int body = 0;
  Value temperature = 0.0;       // K, at the start
  Value source = 0.0;            // W/m^3
  std::vector<double> velocity;  // m/s, at the start; empty: at rest
};

/// The one fluid of a scene. `thermal` counts where heat is modelled, `newtonian` where flow is.
struct Fluid {
  Thermal thermal;
  Newtonian newtonian;
  std::vector<FluidBody> bodies;

  double conductivity() const { return thermal.conductivity.constant()[0]; }  // W/(m K), isotropic
  double diffusivity() const { return conductivity() / thermal.capacity(); }  // m^2/s
};

}  // namespace lapilli
