#include "bind_struct.hpp"

namespace lapilli::python {
namespace {

std::string text_of(const py::object& of, const std::string& name, const py::dict& defaults) {
  std::string members;
  for (const auto& [key, value] : py::cast<py::dict>(of.attr("__dict__"))) {
    if (!defaults.contains(key) || !value.equal(defaults[key])) {
      members += message(members.empty() ? "" : ", ", std::string(py::str(key)), "=",
                         std::string(py::repr(value)));
    }
  }
  return name + "(" + members + ")";
}

}  // namespace

void bind_object_protocol(const py::object& bound, const std::string& name,
                          const std::vector<std::string>& members, const py::dict& defaults) {
  const std::string self = "(self: lapilli._core." + name;
  const auto define = [&](const char* method, auto&& function, const std::string& signature) {
    bound.attr(method) =
        py::cpp_function(std::forward<decltype(function)>(function), py::name(method),
                         py::is_method(bound), (method + self + signature).c_str());
  };
  define(
      "__setattr__",
      [name, members, set = py::module_::import("builtins").attr("object").attr("__setattr__")](
          const py::object& of, const std::string& attribute, const py::object& value) {
        if (std::find(members.begin(), members.end(), attribute) == members.end()) {
          throw py::attribute_error(message(name, ": ", unknown_name("key", attribute, members)));
        }
        set(of, attribute, value);
      },
      ", name: str, value: typing.Any) -> None");
  define(
      "__repr__", [name, defaults](const py::object& of) { return text_of(of, name, defaults); },
      ") -> str");
  define(
      "__eq__",
      [](const py::object& of, const py::object& other) {
        return py::type::of(of).is(py::type::of(other)) &&
               of.attr("__dict__").equal(other.attr("__dict__"));
      },
      ", other: object) -> bool");
  bound.attr("__hash__") = py::none();
}

}  // namespace lapilli::python
