#include "simulation.hpp"

namespace lapilli::python {

void SignalCheck::operator()() {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < std::chrono::milliseconds(50)) {
    return;
  }
  last_ = now;
  raise_signals();
  if (!held_back_.is_none()) {
    const py::gil_scoped_acquire gil;
    held_back_();
  }
}

void raise_signals() {
  const py::gil_scoped_acquire gil;
  if (PyErr_CheckSignals() != 0) {
    throw py::error_already_set();
  }
}

int PythonSimulation::visit_functions(visitproc visit, void* argument) const {
  for (const std::weak_ptr<py::object>& function : functions_) {
    if (const std::shared_ptr<py::object> held = function.lock()) {
      if (const int stopped = visit(held->ptr(), argument)) {
        return stopped;
      }
    }
  }
  return 0;
}

void PythonSimulation::let_go_of_functions() {
  for (const std::weak_ptr<py::object>& function : functions_) {
    if (const std::shared_ptr<py::object> held = function.lock()) {
      *held = py::none();
    }
  }
}

PythonSimulation::Stepping::Stepping(PythonSimulation& simulation) : simulation_(simulation) {
  if (simulation_.stepped_by_ != std::thread::id()) {
    throw std::runtime_error("this simulation is being stepped already");
  }
  simulation_.stepped_by_ = std::this_thread::get_id();
}

PythonSimulation::Stepping::~Stepping() { simulation_.stepped_by_ = {}; }

Simulation& PythonSimulation::get() {
  if (stepped_by_ != std::thread::id() && stepped_by_ != std::this_thread::get_id()) {
    throw std::runtime_error("this simulation is being stepped by another thread");
  }
  return *simulation_;
}

StepReport PythonSimulation::step() {
  const Stepping stepping(*this);
  const py::gil_scoped_release release;
  return simulation_->step();
}

void PythonSimulation::run_until(const py::object& self, double time, const py::object& callback) {
  const Stepping stepping(*this);
  SignalCheck check_signals;
  const py::gil_scoped_release release;
  simulation_->run_until(time, [&](const Simulation&) {
    check_signals();
    if (callback.is_none()) {
      return true;
    }
    const py::gil_scoped_acquire gil;
    return !callback(self).is(py::bool_(false));
  });
}

}  // namespace lapilli::python
