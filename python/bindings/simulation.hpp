#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "initialized.hpp"
#include "lapilli/core/simulation.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli::python {

namespace py = pybind11;

/// Lets Ctrl-C through while the GIL is released: asks Python for signals every twentieth of a
/// second. Throws what Python raises (KeyboardInterrupt), or what `held_back` does, a function of
/// Python or None.
class SignalCheck {
 public:
  explicit SignalCheck(py::object held_back = py::none()) : held_back_(std::move(held_back)) {}
  void operator()();

 private:
  py::object held_back_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Asks Python for signals without a pause of its own; see `Interruption`.
void raise_signals();

/// The functions of Python that a scene holds, each as the one reference that its C++ side has.
using HeldFunctions = std::vector<std::weak_ptr<py::object>>;

/// A simulation held by Python. One thread at a time may step it or look at it.
class PythonSimulation {
 public:
  PythonSimulation(std::unique_ptr<Simulation> simulation, Scene scene, HeldFunctions functions)
      : simulation_(std::move(simulation)),
        scene_(std::move(scene)),
        functions_(std::move(functions)) {
    for (Body& body : scene_.bodies) {
      body.points.reset();  // the simulation holds them
    }
  }

  /// What it was built from, without points given as arrays.
  const Scene& scene() const { return scene_; }

  /// Throws RuntimeError while another thread steps it.
  Simulation& get();

  StepReport step();
  void run_until(const py::object& self, double time, const py::object& callback);

  /// For Python's collector of cycles: a function may hold the simulation that calls it.
  int visit_functions(visitproc visit, void* argument) const;
  void let_go_of_functions();

  /// Marks the simulation as stepped by this thread for as long as it lives. Throws RuntimeError
  /// when it is being stepped already.
  class Stepping {
   public:
    explicit Stepping(PythonSimulation& simulation);
    ~Stepping();
    Stepping(const Stepping&) = delete;
    Stepping& operator=(const Stepping&) = delete;

   private:
    PythonSimulation& simulation_;
  };

 private:
  std::unique_ptr<Simulation> simulation_;
  Scene scene_;
  HeldFunctions functions_;
  std::thread::id stepped_by_;  // read and written with the GIL held
};

/// Its balances, diagnostics, warnings, volumes, surface and step limits.
void bind_accounts(py::class_<PythonSimulation>& bound);

}  // namespace lapilli::python

namespace pybind11::detail {

template <>
class type_caster<lapilli::python::PythonSimulation>
    : public lapilli::python::InitializedCaster<lapilli::python::PythonSimulation> {};

}  // namespace pybind11::detail
