#include "bind_struct.hpp"
#include "bindings.hpp"
#include "lapilli/core/build_info.hpp"

namespace lapilli::python {
namespace {

py::module_* being_bound = nullptr;

}  // namespace

py::module_& core_module() { return *being_bound; }

}  // namespace lapilli::python

PYBIND11_MODULE(_core, module) {
  // Signatures are written out where they are bound, in Python's own type names.
  pybind11::options options;
  options.disable_function_signatures();
  module.doc() = "The compiled part of lapilli.";
  module.attr("__version__") = lapilli::build_info().version;
  module.def(
      "version_text", &lapilli::version_text,
      "version_text() -> str\n\nVersion, compiler, processor level of the kernels, build type "
      "and threads, a line each.");

  using namespace lapilli::python;
  being_bound = &module;
  bind_core(module);
  bind_geometry(module);
  bind_materials(module);
  bind_mpm(module);
  bind_points(module);
  bind_scene(module);
  bind_reports(module);
  bind_simulation(module);
  bind_run(module);
  bind_frames(module);
  bind_pickling(module);
}
