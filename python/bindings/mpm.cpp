#include "bindings.hpp"
#include "convert_core.hpp"
#include "convert_geometry.hpp"
#include "lapilli/mpm/dynamics/dynamics_settings.hpp"
#include "lapilli/mpm/heat/heat_settings.hpp"
#include "lapilli/mpm/quasi_static/settings.hpp"

namespace lapilli::python {

void bind_mpm(py::module_& module) {
  bind_struct<Flux>(module, "Flux", "A prescribed flux, positive into the body.");
  bind_struct<Convection>(
      module, "Convection",
      "Newton's law of cooling: flux into the body = coefficient (ambient - T).");
  bind_struct<Radiation>(module, "Radiation",
                         "Grey-body exchange: flux into the body = emissivity sigma (ambient^4 - "
                         "T^4), in absolute kelvin.");
  bind_struct<PrescribedTemperature>(module, "PrescribedTemperature",
                                     "A temperature held on a surface that need not fit the grid.");
  bind_struct<HeatContact>(module, "HeatContact",
                           "A thermal resistance where two bodies, or all other pairs, touch.");
  bind_struct<HeatSettings>(module, "Heat", "Heat conduction: the section [heat] of a scene.");
  bind_struct<NoSlipBoundary>(module, "NoSlipBoundary",
                              "A face of the grid that the material sticks to.");
  bind_struct<RollerBoundary>(
      module, "RollerBoundary",
      "A face of the grid that the material slides along and cannot part from.");
  bind_struct<FrictionalBoundary>(
      module, "FrictionalBoundary",
      "A face of the grid that the material parts from freely and slides "
      "along with Coulomb friction.");
  bind_struct<Obstacle>(module, "Obstacle",
                        "A rigid obstacle of any shape, at rest or with a prescribed motion.");
  bind_struct<BodyContact>(module, "BodyContact",
                           "What one pair of bodies, or every other pair, does where it meets.");
  bind_struct<Pressure>(module, "Pressure", "A pressure on a free surface.");
  bind_struct<Traction>(module, "Traction", "A force per area of a free surface.");
  bind_struct<DynamicsSettings>(module, "Dynamics",
                                "Explicit dynamics: the section [dynamics] of a scene.");
  bind_struct<SupportSettings>(module, "Support",
                               "A surface on which the displacement is prescribed; it need not fit "
                               "the grid.");
  bind_struct<TractionSettings>(module, "SurfaceTraction",
                                "A surface on which a force per area acts.");
  bind_struct<QuasiStaticSettings>(module, "QuasiStatic",
                                   "Equilibrium under load steps with implicit boundaries: the "
                                   "section [quasi_static] of a scene.");
}

}  // namespace lapilli::python
