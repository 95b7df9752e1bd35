#include "bind_struct.hpp"

namespace lapilli::python {
namespace {

py::object attribute(const py::handle& of, const std::string& name) {
  return of.attr("__dict__")[py::str(name)];
}

// As Python writes it, but of lists that fill a screen only the beginning.
std::string short_text_of(const py::object& value) {
  constexpr std::size_t most = 500, beginning = 60;
  const std::string text = py::repr(value);
  return text.size() <= most || !py::isinstance<py::sequence>(value)
             ? text
             : message(text.substr(0, beginning), " ... ", py::len(value), " entries in all]");
}

std::string text_of(const py::object& of, const std::string& name,
                    const std::vector<std::string>& members, const py::dict& defaults) {
  std::string text;
  for (const std::string& member : members) {
    const py::object value = attribute(of, member);
    if (!defaults.contains(member) || !value.equal(defaults[py::str(member)])) {
      text += message(text.empty() ? "" : ", ", member, "=", short_text_of(value));
    }
  }
  return name + "(" + text + ")";
}

bool equal(const py::object& of, const py::object& other, const std::vector<std::string>& members) {
  return py::type::of(of).is(py::type::of(other)) &&
         std::all_of(members.begin(), members.end(), [&](const std::string& member) {
           return attribute(of, member).equal(attribute(other, member));
         });
}

}  // namespace

void SignatureMaker::add(const char* name, const std::string& type,
                         const py::object& default_value) {
  const py::object parameter = py::module_::import("inspect").attr("Parameter");
  const py::object value = default_value ? default_value : parameter.attr("empty");
  parameters_.append(parameter(name, parameter.attr("KEYWORD_ONLY"), py::arg("default") = value,
                               py::arg("annotation") = type));
}

py::object SignatureMaker::signature() const {
  return py::module_::import("inspect").attr("Signature")(parameters_);
}

std::string plain_class_name(const std::type_info& type) {
  std::string name = type.name();
  py::detail::clean_type_id(name);
  name = name.substr(name.rfind(':') + 1);
  for (const std::string ending : {"Settings", "Motion"}) {
    if (name.size() > ending.size() && name.ends_with(ending)) {
      name.resize(name.size() - ending.size());
    }
  }
  return name;
}

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
      "__repr__",
      [name, members, defaults](const py::object& of) {
        return text_of(of, name, members, defaults);
      },
      ") -> str");
  define(
      "__eq__",
      [members](const py::object& of, const py::object& other) {
        return equal(of, other, members);
      },
      ", other: object) -> bool");
  bound.attr("__hash__") = py::none();
}

}  // namespace lapilli::python
