#include "bindings.hpp"
#include "initialized.hpp"

namespace lapilli::python {
namespace {

bool is_bound_class(py::handle given) {
  const auto* base = reinterpret_cast<PyTypeObject*>(py::detail::get_internals().instance_base);
  return PyType_Check(given.ptr()) && PyType_IsSubtype(reinterpret_cast<PyTypeObject*>(given.ptr()),
                                                       const_cast<PyTypeObject*>(base));
}

/// Whether the class, or one of lapilli it derives from, says itself what its state is.
bool has_own(py::handle type, const char* method) {
  for (const py::handle base : type.attr("__mro__")) {
    if (is_bound_class(base) && base.attr("__dict__").contains(method)) {
      return true;
    }
  }
  return false;
}

py::object reduced(const py::object& object) {
  const std::string name = py::str(py::type::of(object).attr("__name__"));
  if (!is_initialized(object)) {
    throw py::type_error("a " + name + " whose __init__ has not run cannot be copied or pickled");
  }
  const py::object make = py::module_::import("copyreg").attr("__newobj__");
  return py::make_tuple(make, py::make_tuple(py::type::of(object)), object.attr("__getstate__")());
}

py::object refused(const py::object& object) {
  const std::string name = py::str(py::type::of(object).attr("__name__"));
  throw py::type_error("a " + name + " cannot be copied or pickled");
}

}  // namespace

void bind_pickling(py::module_& module) {
  for (const auto& [name, type] : module.attr("__dict__").cast<py::dict>()) {
    if (!is_bound_class(type) || type.attr("__dict__").contains("__reduce__")) {
      continue;
    }
    const std::string signature =
        "__reduce__(self: lapilli._core." + std::string(py::str(name)) + ") -> typing.Any";
    const auto held = py::reinterpret_borrow<py::object>(type);
    held.attr("__reduce__") =
        py::cpp_function(has_own(type, "__getstate__") ? &reduced : &refused,
                         py::name("__reduce__"), py::is_method(held), signature.c_str());
  }
}

}  // namespace lapilli::python
