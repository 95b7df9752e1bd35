#pragma once

#include <pybind11/pybind11.h>

namespace lapilli::python {

namespace py = pybind11;

/// Whether `__init__` of an object of a bound class has run. Where it has not (`T.__new__(T)`),
/// pybind11 would hand out memory that nobody has filled.
inline bool is_initialized(py::handle object) {
  auto* instance = reinterpret_cast<py::detail::instance*>(object.ptr());
  return instance->get_value_and_holder().holder_constructed();
}

/// A caster that takes objects without `__init__` for none of T.
template <class T>
class InitializedCaster : public py::detail::type_caster_base<T> {
 public:
  bool load(py::handle source, bool convert) {
    return py::isinstance<T>(source) && is_initialized(source) &&
           py::detail::type_caster_base<T>::load(source, convert);
  }
};

/// A class whose objects only lapilli makes: `T.__new__(T)` is a TypeError.
inline void forbid_new(py::handle type) {
  reinterpret_cast<PyTypeObject*>(type.ptr())->tp_new = nullptr;
}

/// A class whose objects cannot be pickled or copied: they hold files or the state of a run.
inline void forbid_copies(const py::object& type, const std::string& way_out) {
  const std::string name = py::str(type.attr("__name__"));
  for (const char* method : {"__reduce__", "__copy__"}) {
    type.attr(method) = py::cpp_function(
        [name, way_out](const py::object&) -> py::object {
          throw py::type_error("a " + name + " cannot be copied or pickled: " + way_out);
        },
        py::name(method), py::is_method(type),
        (std::string(method) + "(self: lapilli._core." + name + ") -> typing.Any").c_str());
  }
}

}  // namespace lapilli::python
