#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <iterator>

#include "bindings.hpp"
#include "lapilli/core/diagnostics.hpp"
#include "lapilli/core/warnings.hpp"
#include "lapilli/mpm/surface/surface_view.hpp"
#include "lapilli/scene/body_volumes.hpp"
#include "lapilli/scene/resolve_files.hpp"
#include "lapilli/scene/stage_scenes.hpp"
#include "simulation.hpp"

namespace lapilli::python {
namespace {

const std::string of_simulation = "(self: lapilli._core.Simulation";

py::dict diagnostics(PythonSimulation& simulation) {
  py::dict all;
  for (const Scalar& scalar : diagnostics_of(simulation.get())) {
    all[py::str(scalar.name)] = scalar.value;
  }
  return all;
}

py::list warnings(PythonSimulation& simulation) {
  std::vector<Note> all;
  for (const auto& physics : simulation.get().physics()) {
    std::ranges::copy(warnings_of(*physics), std::back_inserter(all));
  }
  return notes_in_python(all);
}

py::dict volumes(PythonSimulation& simulation) {
  py::dict all;
  const Simulation& now = simulation.get();
  const Scene scene = stage_scenes(with_resolved_files(simulation.scene())).at(now.stage()).scene;
  const std::vector<BodyVolume> of_bodies = [&] {
    const py::gil_scoped_release release;
    return body_volumes(scene, now.points());
  }();
  for (const BodyVolume& body : of_bodies) {
    all[py::str(body.name)] = py::make_tuple(body.volume, body.of_shape);
  }
  return all;
}

py::dict limits(PythonSimulation& simulation) {
  py::dict all;
  for (const auto& physics : simulation.get().physics()) {
    const StepLimit limit = physics->step_limit();
    all[py::str(physics->name())] = py::make_tuple(limit.automatic, limit.hard, limit.reason);
  }
  return all;
}

py::dict surface(PythonSimulation& simulation) {
  py::dict all;
  for (const auto& physics : simulation.get().physics()) {
    if (const auto* owner = dynamic_cast<const HasSurface*>(physics.get())) {
      const SurfaceView view = owner->surface();
      if (view.area.empty()) {
        continue;
      }
      const auto rows = static_cast<py::ssize_t>(view.area.size());
      const std::vector<py::ssize_t> shape = {rows, view.dimension};
      all["position"] = py::array_t<double>(shape, view.position.data());
      all["normal"] = py::array_t<double>(shape, view.normal.data());
      all["area"] = py::array_t<double>(rows, view.area.data());
    }
  }
  return all;
}

}  // namespace

void bind_accounts(py::class_<PythonSimulation>& bound) {
  bound
      .def(
          "balance", [](PythonSimulation& of) { return of.get().balances(); },
          ("balance" + of_simulation +
           ") -> list[Balance]\n\nThe account of every conserved quantity.")
              .c_str())
      .def("diagnostics", &diagnostics,
           ("diagnostics" + of_simulation +
            ") -> dict[str, float]\n\nNumbers worth watching, by physics.")
               .c_str())
      .def("warnings", &warnings,
           ("warnings" + of_simulation +
            ") -> list[lapilli.note.Note]\n\nWhat each physics says of its present state that is "
            "not wrong but not right either.")
               .c_str())
      .def("volumes", &volumes,
           ("volumes" + of_simulation +
            ") -> dict[str, tuple[float, float | None]]\n\nOf each body the volume of its points "
            "now and that of its shape, None where it has none; area, length in fewer dimensions.")
               .c_str())
      .def("surface", &surface,
           ("surface" + of_simulation +
            ") -> dict[str, numpy.typing.NDArray[numpy.float64]]\n\nThe nodes that boundary "
            "conditions "
            "act on: position on the surface, outward normal, area. Empty without them.")
               .c_str())
      .def("limits", &limits,
           ("limits" + of_simulation +
            ") -> dict[str, tuple[float, float, str]]\n\nOf each physics the automatic step, the "
            "largest one allowed and why, s.")
               .c_str());
}

}  // namespace lapilli::python
