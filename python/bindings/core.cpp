#include <pybind11/stl.h>

#include "bindings.hpp"
#include "convert_core.hpp"
#include "lapilli/core/allowed.hpp"
#include "lapilli/core/parallel.hpp"

namespace lapilli::python {
namespace {

void bind_table(py::module_& module) {
  py::class_<Table>(
      module, "Table",
      "A number tabulated in time: linear between the times, constant outside them; two equal "
      "times are a jump.")
      .def(py::init([](std::vector<double> times, std::vector<double> values) {
             Table table{std::move(times), std::move(values)};
             check_table(Where{Key("values"), "Table"}, table);
             return table;
           }),
           py::arg("times"), py::arg("values"),
           "__init__(self: lapilli._core.Table, times: collections.abc.Sequence[float], values: "
           "collections.abc.Sequence[float]) -> None")
      .def_property_readonly(
          "times",
          py::cpp_function([](const Table& table) { return py::tuple(py::cast(table.times)); },
                           "times(self: lapilli._core.Table) -> tuple[float, ...]"),
          "times in s, increasing but for jumps")
      .def_property_readonly(
          "values",
          py::cpp_function([](const Table& table) { return py::tuple(py::cast(table.values)); },
                           "values(self: lapilli._core.Table) -> tuple[float, ...]"),
          "the values at these times")
      .def(
          "at", [](const Table& table, double time) { return table.at(time); }, py::arg("time"),
          "at(self: lapilli._core.Table, time: float) -> float\n\nThe value at one time; at a jump "
          "the "
          "one after it.")
      .def(
          "mean",
          [](const Table& table, double begin, double end) { return table.mean(begin, end); },
          py::arg("begin"), py::arg("end"),
          "mean(self: lapilli._core.Table, begin: float, end: float) -> float\n\nThe mean over a "
          "span of time, exact.")
      .def(
          "__eq__",
          [](const Table& table, const py::object& other) {
            if (!py::isinstance<Table>(other)) {
              return false;
            }
            const auto& same = other.cast<const Table&>();
            return table.times == same.times && table.values == same.values;
          },
          "__eq__(self: lapilli._core.Table, other: object) -> bool")
      .def(
          "__repr__",
          [](const Table& table) {
            return message("Table(times=", std::string(py::repr(py::cast(table.times))),
                           ", values=", std::string(py::repr(py::cast(table.values))), ")");
          },
          "__repr__(self: lapilli._core.Table) -> str")
      .def(py::pickle([](const Table& table) { return py::make_tuple(table.times, table.values); },
                      [](const py::tuple& state) {
                        return Table{state[0].cast<std::vector<double>>(),
                                     state[1].cast<std::vector<double>>()};
                      }));
}

}  // namespace

void bind_core(py::module_& module) {
  py::register_exception<RunError>(module, "RunError", PyExc_RuntimeError).doc() =
      "A run that went wrong; the message names step, time, point, field and likely cause.";
  bind_table(module);
  module.def(
      "unknown_name",
      [](const std::string& what, const std::string& given, const std::vector<std::string>& names) {
        return unknown_name(what, given, names);
      },
      py::arg("what"), py::arg("given"), py::arg("names"),
      "unknown_name(what: str, given: str, names: list[str]) -> str\n\nWhat to say of a name that "
      "is none of these: what it is called now, what was meant, or what there is.");
  module.def("thread_count", &thread_count,
             "thread_count() -> int\n\nThreads that every loop may use.");
  module.def("set_thread_count", &set_thread_count, py::arg("threads"),
             "set_thread_count(threads: int) -> None\n\nSet the threads of every following run; 0 "
             "means all processors. Other libraries are not touched.");
}

}  // namespace lapilli::python
