#include "simulation.hpp"

#include <pybind11/stl.h>

#include <algorithm>

#include "bindings.hpp"
#include "convert_scene.hpp"
#include "lapilli/core/interruption.hpp"
#include "lapilli/scene/build.hpp"

namespace lapilli::python {
namespace {

/// A view of numbers that keeps `owner` alive; users may not write to it,
/// because what a physics evolves need not be what it shows. A copy where a next stage will let go
/// of the numbers.
template <class Number>
py::array_t<Number> view(const py::object& owner, std::span<const Number> values,
                         const std::vector<py::ssize_t>& shape) {
  const bool stays = owner.cast<PythonSimulation&>().get().later_stages().empty();
  py::array_t<Number> array(shape, values.data(), stays ? owner : py::object());
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::array_t<Index> view(const py::object& owner, std::span<const Index> values) {
  return view<Index>(owner, values, {static_cast<py::ssize_t>(values.size())});
}

std::vector<std::string> field_names(PythonSimulation& simulation) {
  std::vector<std::string> names = {"position", "volume", "id", "body"};
  for (const Field& field : simulation.get().fields()) {
    names.push_back(field.name);
  }
  return names;
}

py::object field(const py::object& self, const std::string& name) {
  auto& simulation = self.cast<PythonSimulation&>();
  Points& points = simulation.get().points();
  if (name == "position") {
    return view<double>(self, points.position(), {points.size(), points.dimension()});
  }
  if (name == "volume") {
    return view<double>(self, points.volume(), {points.size()});
  }
  if (name == "id" || name == "body") {
    const std::vector<Index>& numbers = simulation.get().body_numbers();
    if (name == "body" && !numbers.empty()) {
      std::vector<Index> bodies(points.body().begin(), points.body().end());
      std::ranges::transform(bodies, bodies.begin(), [&](Index body) { return numbers[body]; });
      return view<Index>(self, bodies, {points.size()});
    }
    return view(self, name == "id" ? points.id() : points.body());
  }
  for (const Field& candidate : simulation.get().fields()) {
    if (candidate.name == name) {
      return candidate.components == 1
                 ? view<double>(self, candidate.values, {points.size()})
                 : view<double>(self, candidate.values, {points.size(), candidate.components});
    }
  }
  throw py::key_error(unknown_name("field", name, field_names(simulation)));
}

/// A field, or a component of one: "stress.xy".
py::object field_or_component(const py::object& self, const std::string& name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos) {
    return field(self, name);
  }
  const py::object component_of = py::module_::import("lapilli.components").attr("component_of");
  return component_of(field(self, name.substr(0, dot)), name);
}

py::object by_id(const py::object& self, const std::string& name) {
  const Points& points = self.cast<PythonSimulation&>().get().points();
  const std::vector<Index> rows = points.rows_by_id();
  return field_or_component(
      self, name)[py::array_t<Index>(static_cast<py::ssize_t>(rows.size()), rows.data())];
}

std::string unit_of(PythonSimulation& simulation, const std::string& name) {
  if (name == "position") {
    return "m";
  }
  if (name == "volume") {
    const int dimension = simulation.get().points().dimension();
    return dimension == 1 ? "m" : "m^" + std::to_string(dimension);
  }
  if (name == "id" || name == "body") {
    return "";
  }
  for (const Field& field : simulation.get().fields()) {
    if (field.name == name) {
      return field.unit;
    }
  }
  throw py::key_error(unknown_name("field", name, field_names(simulation)));
}

/// Null where `__init__` has not run; runs no code of Python, which may not be done here.
PythonSimulation* collected(PyObject* self) {
  auto held = reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder();
  return held.holder_constructed() ? held.value_ptr<PythonSimulation>() : nullptr;
}

/// Let Python's collector see the functions that a simulation holds.
void collect_cycles(PyHeapTypeObject* heap_type) {
  PyTypeObject& type = heap_type->ht_type;
  type.tp_flags |= Py_TPFLAGS_HAVE_GC;
  type.tp_traverse = [](PyObject* self, visitproc visit, void* arg) {
    Py_VISIT(Py_TYPE(self));
    const PythonSimulation* simulation = collected(self);
    return simulation != nullptr ? simulation->visit_functions(visit, arg) : 0;
  };
  type.tp_clear = [](PyObject* self) {
    if (PythonSimulation* simulation = collected(self)) {
      simulation->let_go_of_functions();
    }
    return 0;
  };
}

const std::string self = "(self: lapilli._core.Simulation";
using Bound = py::class_<PythonSimulation>;

void bind_stepping(Bound& bound) {
  bound
      .def(py::init([](const py::object& given) {
             FunctionCollector collector;
             Scene scene = scene_of(given);
             const py::gil_scoped_release release;
             const Interruption interruption(raise_signals);
             auto built = build(scene);
             return std::make_unique<PythonSimulation>(std::move(built), std::move(scene),
                                                       std::move(collector.functions));
           }),
           py::arg("scene"), ("__init__" + self + ", scene: Scene) -> None").c_str())
      .def(
          "step", [](PythonSimulation& simulation) { return simulation.step(); },
          ("step" + self + ") -> StepReport\n\nTake one step.").c_str())
      .def(
          "run_until",
          [](const py::object& of, double time, const py::object& callback) {
            of.cast<PythonSimulation&>().run_until(of, time, callback);
          },
          py::arg("time"), py::arg("callback") = py::none(),
          ("run_until" + self +
           ", time: float, callback: collections.abc.Callable[[Simulation], typing.Any] | None = "
           "None) -> None\n\nStep until `time`, exactly. After each step `callback(simulation)` "
           "may "
           "return False to stop early.")
              .c_str());
}

void bind_fields(Bound& bound) {
  const std::string array = " -> numpy.typing.NDArray[typing.Any]";
  bound
      .def("__getitem__", &field_or_component, py::arg("name"),
           ("__getitem__" + self + ", name: str)" + array +
            "\n\nA field, or a component of one (stress.xy), as a read-only view without copy, "
            "brought "
            "up to date, one row per point in the present order. It keeps the simulation alive; "
            "later "
            "steps change it. In a scene with stages it is a copy.")
               .c_str())
      .def("by_id", &by_id, py::arg("name"),
           ("by_id" + self + ", name: str)" + array +
            "\n\nA copy of a field with its rows in the order of the points' ids.")
               .c_str())
      .def("unit", &unit_of, py::arg("name"),
           ("unit" + self + ", name: str) -> str\n\nThe unit of a field.").c_str())
      .def(
          "__len__", [](PythonSimulation& of) { return of.get().points().size(); },
          ("__len__" + self + ") -> int\n\nThe number of points.").c_str());
}

void bind_properties(Bound& bound) {
  const auto property = [&](const char* name, auto get, const std::string& type, const char* text) {
    bound.def_property_readonly(name, py::cpp_function(get, (name + self + ") -> " + type).c_str()),
                                text);
  };
  property(
      "time", [](PythonSimulation& of) { return of.get().time(); }, "float", "the clock, s");
  property(
      "end", [](PythonSimulation& of) { return of.get().end(); }, "float",
      "time at which the scene ends, s");
  property(
      "stage", [](PythonSimulation& of) { return of.get().stage_name(); }, "str",
      "name of the present stage; empty before the first of them");
  property(
      "step_index", [](PythonSimulation& of) { return of.get().step_index(); }, "int",
      "steps taken");
  property(
      "step_size", [](PythonSimulation& of) { return of.get().next_step_size(); }, "float",
      "size of the next step, s");
  property(
      "dimension", [](PythonSimulation& of) { return of.get().points().dimension(); }, "int",
      "1, 2 or 3");
  property("fields", &field_names, "list[str]", "names that can be asked for");
  property(
      "position", [](const py::object& of) { return field(of, "position"); },
      "numpy.typing.NDArray[numpy.float64]", "positions (points, dimension), a view, m");
}

}  // namespace

void bind_simulation(py::module_& module) {
  py::class_<PythonSimulation> bound(module, "Simulation", py::custom_type_setup(&collect_cycles),
                                     "A clock, the points and an ordered list of physics, built "
                                     "from a scene. Stepping releases the GIL.");
  forbid_copies(bound, "build another one from its scene");
  bind_stepping(bound);
  bind_fields(bound);
  bind_accounts(bound);
  bind_properties(bound);
}

}  // namespace lapilli::python
