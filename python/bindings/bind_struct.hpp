#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "convert.hpp"

namespace lapilli::python {

/// The base class of a family of structs ("any shape"); specialised where there is one.
struct NoFamily {};
template <class T>
struct FamilyOf {
  using type = NoFamily;
};

/// The C++ side of a Python object that stands for a described struct. Its members live in the
/// object's `__dict__`, as Python values checked by `Convert`: lists can be appended to, nested
/// objects stay shared, and nothing dangles. `Convert<T>::load` makes the C++ struct when it is
/// needed.
template <class T>
struct Record : FamilyOf<T>::type {};

/// What every such class shares: an attribute must be a member, the repr shows what differs from
/// the defaults, objects compare by their members and can be copied and pickled.
void bind_object_protocol(const py::object& bound, const std::string& name,
                          const std::vector<std::string>& members, const py::dict& defaults);

/// Collects what inspect.signature shows of a class: keyword-only parameters.
class SignatureMaker {
 public:
  /// `default_value` is null where the argument is required.
  void add(const char* name, const std::string& type, const py::object& default_value);
  py::object signature() const;

 private:
  py::list parameters_;
};

/// Calls `visit(key, member)` for every member of a default T.
template <class T, class Visitor>
void each_member(Visitor&& visit) {
  T prototype{};
  T::describe(prototype, visit);
}

template <class T>
std::vector<std::string> key_names() {
  std::vector<std::string> names;
  each_member<T>([&](const Key& key, auto&) { names.emplace_back(key.name); });
  return names;
}

/// What an object carries besides its described members; most carry nothing.
template <class T>
struct Extras {
  static void load(const py::dict&, T&) {}
  static void show(const T&, py::dict&) {}
};

template <class T>
bool is_bound() {
  return py::detail::get_type_info(typeid(Record<T>)) != nullptr;
}

/// The module that classes are bound into.
py::module_& core_module();

/// "Annulus" for a struct of the library: without namespace, "Settings" and the like.
std::string plain_class_name(const std::type_info& type);

template <class T>
auto bind_struct(py::module_& module, const char* name, const std::string& summary);

/// The name of the Python class of T; one that no file binds is bound here, under its own name.
template <class T>
std::string class_name() {
  if (!is_bound<T>()) {
    const std::string name = plain_class_name(typeid(T));
    bind_struct<T>(core_module(), name.c_str(), name + ".");
  }
  return std::string(py::str(py::type::of<Record<T>>().attr("__name__")));
}

template <Described T>
struct Convert<T> {
  static constexpr bool keeps_object = true;
  static std::string type_name() { return class_name<T>(); }
  /// A subclass is refused: what it adds would be lost on the way to C++.
  static bool accepts(py::handle given) {
    return is_bound<T>() && py::type::handle_of(given).is(py::type::of<Record<T>>());
  }
  static void load(const Where& where, py::handle given, T& member) {
    if (!accepts(given)) {
      where.refuse("a " + type_name(), given);
    }
    if (!TrustObjects::on()) {
      read(where.path(), given, member);
    }
  }
  /// Every member from the object's attributes; `owner` names it in messages.
  static void read(const std::string& owner, py::handle given, T& member) {
    const auto attributes = py::cast<py::dict>(given.attr("__dict__"));
    Extras<T>::load(attributes, member);
    auto visit = [&]<class Member>(const Key& key, Member& target) {
      Convert<Member>::load(Where{key, owner}, attributes[key.name], target);
    };
    T::describe(member, visit);
  }
  static py::object show(const Key&, const T& member) {
    py::object object = py::cast(Record<T>());
    auto attributes = py::cast<py::dict>(object.attr("__dict__"));
    auto visit = [&]<class Member>(const Key& key, const Member& value) {
      attributes[key.name] = Convert<Member>::show(key, value);
    };
    T::describe(member, visit);
    Extras<T>::show(member, attributes);
    return object;
  }
};

/// What an attribute holds after the user gave `given`: checked, and copied unless it is an object
/// of its own.
template <class Member>
py::object checked(const Where& where, py::handle given) {
  Member value{};
  const TrustObjects trust;
  Convert<Member>::load(where, given, value);
  if constexpr (!Convert<Member>::keeps_object) {
    return Convert<Member>::show(where.key, value);
  } else {
    if (PyList_Check(given.ptr()) || PyTuple_Check(given.ptr())) {
      return py::reinterpret_steal<py::object>(PySequence_List(given.ptr()));
    }
    return py::reinterpret_borrow<py::object>(given);
  }
}

/// "inner : float, m, required" and what it means: one entry of a class's parameter list.
template <class Member>
std::string parameter_text(const Key& key, const Member& value) {
  std::string line = message(key.name, " : ", Convert<Member>::type_name());
  if (*key.of_unit != '\0') {
    line += message(", ", key.of_unit);
  }
  line += key.is_required
              ? std::string(", required")
              : message(", default ", std::string(py::repr(Convert<Member>::show(key, value))));
  const std::string range = allowed_range(key);
  return message(line, "\n    ", key.meaning, range.empty() ? "" : "; ", range, "\n");
}

/// Sets the attributes of a new object from keyword arguments and defaults.
template <class T>
py::dict members_from(const std::string& owner, const py::args& positional,
                      const py::kwargs& given) {
  const auto names = key_names<T>();
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
  py::dict members;
  each_member<T>([&]<class Member>(const Key& key, Member& value) {
    if (given.contains(key.name)) {
      members[key.name] = checked<Member>(Where{key, owner}, given[key.name]);
    } else if (key.is_required) {
      throw py::type_error(message(owner, " needs ", key.name, ": ", key.meaning));
    } else {
      members[key.name] = Convert<Member>::show(key, value);
    }
  });
  return members;
}

template <class T>
auto record_class(py::module_& module, const char* name) {
  if constexpr (std::is_base_of_v<NoFamily, Record<T>>) {
    return py::class_<Record<T>>(module, name, py::dynamic_attr());
  } else {
    return py::class_<Record<T>, typename FamilyOf<T>::type>(module, name, py::dynamic_attr());
  }
}

/// Bind T's members as keyword-only arguments and checked properties.
template <class T>
auto bind_struct(py::module_& module, const char* name, const std::string& summary) {
  auto bound = record_class<T>(module, name);
  const std::string owner = name;
  const std::string self = "self: lapilli._core." + owner;
  std::string signature = "__init__(" + self + ", *";
  std::string text = summary + "\n\nParameters\n----------\n";
  py::dict defaults;
  SignatureMaker made;

  each_member<T>([&]<class Member>(const Key& key, Member& value) {
    const std::string type =
        message(Convert<Member>::type_name(), *key.absent_word == '\0' ? "" : " | str");
    signature += message(", ", key.name, ": ", type, key.is_required ? "" : " = ...");
    text += parameter_text(key, value);
    if (!key.is_required) {
      defaults[key.name] = Convert<Member>::show(key, value);
    }
    made.add(key.name, type, key.is_required ? py::object() : defaults[key.name]);
    const std::string get_text = message(key.name, "(", self, ") -> ", type);
    const std::string set_text = message(key.name, "(", self, ", value: ", type, ") -> None");
    bound.def_property(
        key.name,
        py::cpp_function(
            [key](const py::object& of) -> py::object { return of.attr("__dict__")[key.name]; },
            get_text.c_str()),
        py::cpp_function(
            [key, owner](const py::object& of, const py::object& given) {
              of.attr("__dict__")[key.name] = checked<Member>(Where{key, owner}, given);
            },
            set_text.c_str()),
        message(key.meaning, *key.of_unit == '\0' ? "" : ", ", key.of_unit).c_str());
  });
  bound.doc() = text;
  bound.attr("__signature__") = made.signature();
  bound.def(
      "__init__",
      [owner](py::detail::value_and_holder& holder, const py::args& positional,
              const py::kwargs& given) {
        holder.value_ptr() = new Record<T>();
        py::handle(reinterpret_cast<PyObject*>(holder.inst))
            .attr("__dict__")
            .attr("update")(members_from<T>(owner, positional, given));
      },
      py::detail::is_new_style_constructor(), (signature + ") -> None").c_str());
  bound.def(
      "__getstate__", [](const py::object& of) { return of.attr("__dict__"); },
      ("__getstate__(" + self + ") -> dict[str, typing.Any]").c_str());
  bound.def(
      "__setstate__",
      [](py::detail::value_and_holder& holder, const py::dict& members) {
        holder.value_ptr() = new Record<T>();
        py::handle(reinterpret_cast<PyObject*>(holder.inst))
            .attr("__dict__")
            .attr("update")(members);
      },
      py::detail::is_new_style_constructor(),
      ("__setstate__(" + self + ", members: dict[str, typing.Any]) -> None").c_str());
  bind_object_protocol(bound, owner, key_names<T>(), defaults);
  return bound;
}

}  // namespace lapilli::python
