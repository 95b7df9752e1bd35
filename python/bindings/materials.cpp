#include "bind_struct.hpp"
#include "bindings.hpp"
#include "convert_core.hpp"
#include "lapilli/materials/elastic.hpp"
#include "lapilli/materials/newtonian.hpp"
#include "lapilli/materials/thermal.hpp"

namespace lapilli::python {

void bind_materials(py::module_& module) {
  bind_struct<Newtonian>(module, "Newtonian",
                         "A viscous fluid, slightly lighter or heavier with temperature.");
  bind_struct<Thermal>(
      module, "Thermal",
      "A solid that stores and conducts heat (Fourier), with constant coefficients.");
  bind_struct<LinearElastic>(module, "Elastic", "An isotropic linear elastic solid.");
}

}  // namespace lapilli::python
