#include <algorithm>
#include <ranges>

#include "bindings.hpp"
#include "initialized.hpp"
#include "lapilli/core/balance.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/physics.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli::python {
namespace {

void bind_step(py::module_& module) {
  py::class_<StepReport> bound(module, "StepReport", "What one step did.");
  forbid_new(bound);
  bound
      .def_property_readonly(
          "accepted",
          py::cpp_function([](const StepReport& report) { return report.accepted; },
                           "accepted(self: lapilli._core.StepReport) -> float"),
          "size of the step taken, s")
      .def_property_readonly(
          "iterations",
          py::cpp_function([](const StepReport& report) { return report.iterations; },
                           "iterations(self: lapilli._core.StepReport) -> int"),
          "iterations of implicit solves")
      .def_property_readonly(
          "residual",
          py::cpp_function([](const StepReport& report) { return report.residual; },
                           "residual(self: lapilli._core.StepReport) -> float"),
          "relative residual of implicit solves")
      .def(
          "__repr__",
          [](const StepReport& report) {
            return message("<step of ", report.accepted, " s, ", report.iterations,
                           " iterations, residual ", report.residual, ">");
          },
          "__repr__(self: lapilli._core.StepReport) -> str");
}

bool same_balance(const Balance& a, const py::object& other) {
  if (!py::isinstance<Balance>(other)) {
    return false;
  }
  const auto& b = other.cast<const Balance&>();
  const auto same = [](const Balance::Entry& left, const Balance::Entry& right) {
    return left.name == right.name && left.in == right.in;
  };
  return a.quantity == b.quantity && a.unit == b.unit && a.initial == b.initial &&
         a.stored == b.stored && std::ranges::equal(a.entries, b.entries, same);
}

void bind_balance(py::module_& module) {
  const std::string self = "(self: lapilli._core.Balance)";
  py::class_<Balance> bound(module, "Balance",
                            "The account of one conserved quantity: what was there, what was "
                            "supplied, what is there now.");
  forbid_new(bound);
  const auto number = [&](const char* name, auto get, const char* text) {
    bound.def_property_readonly(name, py::cpp_function(get, (name + self + " -> float").c_str()),
                                text);
  };
  const auto text = [&](const char* name, auto get, const char* says) {
    bound.def_property_readonly(name, py::cpp_function(get, (name + self + " -> str").c_str()),
                                says);
  };
  text(
      "quantity", [](const Balance& balance) { return balance.quantity; }, "what is conserved");
  text(
      "unit", [](const Balance& balance) { return balance.unit; }, "unit of every amount");
  number(
      "initial", [](const Balance& balance) { return balance.initial; }, "stored at the start");
  number(
      "stored", [](const Balance& balance) { return balance.stored; }, "stored now");
  number(
      "supplied", [](const Balance& balance) { return balance.supplied(); },
      "sum of the entries, counted inwards");
  number(
      "turnover", [](const Balance& balance) { return balance.turnover(); },
      "sum of the entries' sizes");
  number(
      "residual", [](const Balance& balance) { return balance.residual(); },
      "(stored - initial - taken in) over the largest turnover or span of the store so far");
  bound.def_property_readonly("entries",
                              py::cpp_function(
                                  [](const Balance& balance) {
                                    py::dict all;
                                    for (const auto& entry : balance.entries) {
                                      all[py::str(entry.name)] = entry.in;
                                    }
                                    return all;
                                  },
                                  ("entries" + self + " -> dict[str, float]").c_str()),
                              "what came in by each way since the start; negative: went out");
  bound.def("__eq__", &same_balance, "__eq__(self: lapilli._core.Balance, other: object) -> bool");
  bound.def(
      "__repr__",
      [](const Balance& balance) {
        return message("<", balance.quantity, ": ", balance.supplied(), " ", balance.unit, " in, ",
                       balance.stored, " stored, residual ", balance.residual(), ">");
      },
      ("__repr__" + self + " -> str").c_str());
}

py::list note_kinds_in_python() {
  py::list all;
  for (const NoteKind& kind : note_kinds) {
    all.append(py::make_tuple(kind.code, kind.when, kind.advice));
  }
  return all;
}

}  // namespace

py::list notes_in_python(const std::vector<Note>& notes) {
  const py::object made = py::module_::import("lapilli.note").attr("Note");
  py::list all;
  for (const Note& one : notes) {
    all.append(made(one.text, one.code.text()));
  }
  return all;
}

void bind_reports(py::module_& module) {
  bind_step(module);
  bind_balance(module);
  module.def("note_kinds", &note_kinds_in_python,
             "note_kinds() -> list[tuple[str, str, str]]\n\nEvery kind of note: its code, when it "
             "is said, what to do.");
}

}  // namespace lapilli::python
