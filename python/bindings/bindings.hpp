#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "lapilli/core/note.hpp"

namespace lapilli::python {

// One function per library folder, in the order in which the module calls them: a class is bound
// before those that hold it.
void bind_core(pybind11::module_& module);
void bind_geometry(pybind11::module_& module);
void bind_materials(pybind11::module_& module);
void bind_mpm(pybind11::module_& module);
void bind_points(pybind11::module_& module);
void bind_scene(pybind11::module_& module);
void bind_reports(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
void bind_run(pybind11::module_& module);
void bind_frames(pybind11::module_& module);
/// As a list of lapilli.note.Note.
pybind11::list notes_in_python(const std::vector<Note>& notes);
/// How objects of all classes above are copied and pickled, in every protocol: Python's own way for
/// the first two makes an object of another class and aborts.
void bind_pickling(pybind11::module_& module);

}  // namespace lapilli::python
