#include "bind_struct.hpp"
#include "bindings.hpp"
#include "convert_core.hpp"
#include "convert_function.hpp"
#include "lapilli/materials/coupling.hpp"
#include "lapilli/materials/drucker_prager.hpp"
#include "lapilli/materials/elastic.hpp"
#include "lapilli/materials/modified_cam_clay.hpp"
#include "lapilli/materials/mohr_coulomb.hpp"
#include "lapilli/materials/newtonian.hpp"
#include "lapilli/materials/tabulated_mohr_coulomb.hpp"
#include "lapilli/materials/thermal.hpp"
#include "lapilli/materials/von_mises.hpp"

namespace lapilli::python {

void bind_materials(py::module_& module) {
  bind_struct<Newtonian>(module, "Newtonian",
                         "A viscous fluid, slightly lighter or heavier with temperature.");
  bind_struct<Thermal>(
      module, "Thermal",
      "A solid that stores and conducts heat (Fourier) and may melt; what depends on the "
      "temperature is a pair (temperatures, values).");
  bind_struct<LinearElastic>(module, "Elastic", "An isotropic linear elastic solid.");
  bind_struct<MohrCoulomb>(module, "MohrCoulomb",
                           "Elastic, perfectly plastic soil with friction, dilation, cohesion and "
                           "a tension cut-off.");
  bind_struct<DruckerPrager>(
      module, "DruckerPrager",
      "Elastic, perfectly plastic soil with a smooth cone, cut at its apex.");
  bind_struct<VonMises>(
      module, "VonMises",
      "Elastic, plastic solid with von Mises' yield stress, hardening by a table.");
  bind_struct<TabulatedMohrCoulomb>(module, "TabulatedMohrCoulomb",
                                    "Mohr-Coulomb soil whose strength and dilatancy are tables of "
                                    "its plastic strain.");
  bind_struct<ModifiedCamClay>(
      module, "ModifiedCamClay",
      "Clay that hardens with compaction and softens with dilation, up to a critical state.");
  bind_struct<FunctionSolid>(module, "FunctionSolid",
                             "A solid whose stress is a function over blocks of points.");
  bind_struct<ThermalExpansion>(module, "ThermalExpansion",
                                "Isotropic expansion with temperature, beside a solid and a "
                                "thermal material.");
  bind_struct<PlasticHeating>(module, "PlasticHeating",
                              "Heat released by plastic work, beside a solid and a thermal "
                              "material.");
}

}  // namespace lapilli::python
