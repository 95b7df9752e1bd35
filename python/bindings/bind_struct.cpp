#include "bind_struct.hpp"

#include <algorithm>

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

/// "inner : float, m, required" and what it means: one entry of a class's parameter list.
std::string parameter_text(const BoundMember& member) {
  const Key& key = member.key;
  std::string line = message(key.name, " : ", member.type);
  if (*key.of_unit != '\0') {
    line += message(", ", key.of_unit);
  }
  line += key.is_required ? std::string(", required")
                          : message(", default ", std::string(py::repr(member.default_value())));
  const std::string range = allowed_range(key);
  return message(line, "\n    ", key.meaning, range.empty() ? "" : "; ", range, "\n");
}

/// The type of an argument: an optional one may be given as a word.
std::string argument_type(const BoundMember& member) {
  return message(member.type, *member.key.absent_word == '\0' ? "" : " | str");
}

/// What inspect.signature shows of a class: keyword-only parameters.
py::object signature_of(const std::vector<BoundMember>& members) {
  const py::object parameter = py::module_::import("inspect").attr("Parameter");
  py::list parameters;
  for (const BoundMember& member : members) {
    const py::object value =
        member.key.is_required ? py::object(parameter.attr("empty")) : member.default_value();
    parameters.append(parameter(member.key.name, parameter.attr("KEYWORD_ONLY"),
                                py::arg("default") = value,
                                py::arg("annotation") = argument_type(member)));
  }
  return py::module_::import("inspect").attr("Signature")(parameters);
}

/// The attributes of a new object from keyword arguments and defaults.
py::dict attributes_from(const std::string& owner, const std::vector<BoundMember>& members,
                         const std::vector<std::string>& names, const py::args& positional,
                         const py::kwargs& given) {
  if (!positional.empty()) {
    throw py::type_error(
        message(owner, " takes keyword arguments only: ", owner, "(", names.front(), "=...)"));
  }
  for (const auto& [key, value] : given) {
    const std::string word = py::str(key);
    if (std::find(names.begin(), names.end(), word) == names.end()) {
      throw py::type_error(message(owner, ": ", unknown_name("key", word, names)));
    }
  }
  py::dict attributes;
  for (const BoundMember& member : members) {
    const Key& key = member.key;
    if (given.contains(key.name)) {
      attributes[key.name] = member.check(Where{key, owner}, given[key.name]);
    } else if (key.is_required) {
      throw py::type_error(message(owner, " needs ", key.name, ": ", key.meaning));
    } else {
      attributes[key.name] = member.default_value();
    }
  }
  return attributes;
}

void set_attributes(const py::detail::value_and_holder& holder, const py::dict& attributes) {
  py::handle(reinterpret_cast<PyObject*>(holder.inst)).attr("__dict__").attr("update")(attributes);
}

/// Defines methods of a class whose signatures are written out.
class MethodWriter {
 public:
  MethodWriter(py::object bound, const std::string& name)
      : bound_(std::move(bound)), self_("self: lapilli._core." + name) {}

  template <class Function, class... Extra>
  void define(const char* method, Function&& function, const std::string& signature,
              const Extra&... extra) {
    bound_.attr(method) =
        py::cpp_function(std::forward<Function>(function), py::name(method), py::is_method(bound_),
                         extra..., message(method, "(", self_, signature).c_str());
  }

  void define_property(const BoundMember& member, const std::string& owner) {
    const Key& key = member.key;
    const std::string type = argument_type(member);
    const py::cpp_function get(
        [key](const py::object& of) -> py::object { return of.attr("__dict__")[key.name]; },
        message(key.name, "(", self_, ") -> ", type).c_str());
    const py::cpp_function set(
        [key, owner, check = member.check](const py::object& of, const py::object& given) {
          of.attr("__dict__")[key.name] = check(Where{key, owner}, given);
        },
        message(key.name, "(", self_, ", value: ", type, ") -> None").c_str());
    const std::string text = message(key.meaning, *key.of_unit == '\0' ? "" : ", ", key.of_unit);
    bound_.attr(key.name) =
        py::handle(reinterpret_cast<PyObject*>(&PyProperty_Type))(get, set, py::none(), text);
  }

 private:
  py::object bound_;
  std::string self_;
};

/// An attribute must be a member; objects compare by their members and show them.
void define_protocol(MethodWriter& writer, const std::string& name,
                     const std::vector<std::string>& members, const py::dict& defaults) {
  writer.define(
      "__setattr__",
      [name, members, set = py::module_::import("builtins").attr("object").attr("__setattr__")](
          const py::object& of, const std::string& attribute, const py::object& value) {
        if (std::find(members.begin(), members.end(), attribute) == members.end()) {
          throw py::attribute_error(message(name, ": ", unknown_name("key", attribute, members)));
        }
        set(of, attribute, value);
      },
      ", name: str, value: typing.Any) -> None");
  writer.define(
      "__repr__",
      [name, members, defaults](const py::object& of) {
        return text_of(of, name, members, defaults);
      },
      ") -> str");
  writer.define(
      "__eq__",
      [members](const py::object& of, const py::object& other) {
        return equal(of, other, members);
      },
      ", other: object) -> bool");
}

/// How objects are made: from keyword arguments, or from their state when unpickled.
void define_making(MethodWriter& writer, const std::string& name,
                   const std::vector<BoundMember>& members, const std::vector<std::string>& names,
                   void (*make)(py::detail::value_and_holder& holder)) {
  std::string arguments = ", *";
  for (const BoundMember& member : members) {
    arguments += message(", ", member.key.name, ": ", argument_type(member),
                         member.key.is_required ? "" : " = ...");
  }
  writer.define(
      "__init__",
      [name, members, names, make](py::detail::value_and_holder& holder, const py::args& positional,
                                   const py::kwargs& given) {
        make(holder);
        set_attributes(holder, attributes_from(name, members, names, positional, given));
      },
      arguments + ") -> None", py::detail::is_new_style_constructor());
  writer.define(
      "__getstate__", [](const py::object& of) { return of.attr("__dict__"); },
      ") -> dict[str, typing.Any]");
  writer.define(
      "__setstate__",
      [make](py::detail::value_and_holder& holder, const py::dict& state) {
        make(holder);
        set_attributes(holder, state);
      },
      ", members: dict[str, typing.Any]) -> None", py::detail::is_new_style_constructor());
}

}  // namespace

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

void bind_members(py::object bound, const std::string& name, const std::string& summary,
                  const std::vector<BoundMember>& members,
                  void (*make)(py::detail::value_and_holder& holder)) {
  MethodWriter writer(bound, name);
  std::string text = summary + "\n\nParameters\n----------\n";
  std::vector<std::string> names;
  py::dict defaults;
  for (const BoundMember& member : members) {
    names.emplace_back(member.key.name);
    text += parameter_text(member);
    if (!member.key.is_required) {
      defaults[member.key.name] = member.default_value();
    }
    writer.define_property(member, name);
  }
  bound.attr("__doc__") = text;
  bound.attr("__signature__") = signature_of(members);
  define_making(writer, name, members, names, make);
  define_protocol(writer, name, names, defaults);
  bound.attr("__hash__") = py::none();
}

}  // namespace lapilli::python
