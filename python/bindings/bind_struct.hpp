#pragma once

#include <functional>
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

/// One member of a described struct, as its Python class knows it.
struct BoundMember {
  Key key;
  std::string type;                                     // Python's name of it
  std::function<py::object()> default_value;            // a new object every time
  py::object (*check)(const Where&, py::handle given);  // what the attribute holds when set
};

/// Bind members as keyword-only arguments and checked properties of a class that shows what differs
/// from the defaults, compares by its members, and can be copied and pickled. `make` fills the C++
/// side of a new object.
void bind_members(py::object bound, const std::string& name, const std::string& summary,
                  const std::vector<BoundMember>& members,
                  void (*make)(py::detail::value_and_holder& holder));

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

/// Reads members from the attributes of an object.
struct MemberLoader {
  const py::dict& attributes;
  const std::string& owner;  // in messages

  template <class Member>
  void operator()(const Key& key, Member& member) {
    Convert<Member>::load(Where{key, owner}, attributes[key.name], member);
  }
};

/// Sets the attributes of an object from members.
struct MemberShower {
  py::dict& attributes;

  template <class Member>
  void operator()(const Key& key, const Member& member) {
    attributes[key.name] = Convert<Member>::show(key, member);
  }
};

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
    MemberLoader load{attributes, owner};
    T::describe(member, load);
  }
  static py::object show(const Key&, const T& member) {
    py::object object = py::cast(Record<T>());
    auto attributes = py::cast<py::dict>(object.attr("__dict__"));
    MemberShower show{attributes};
    T::describe(member, show);
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

/// Collects the members of a default struct.
struct MemberCollector {
  std::vector<BoundMember> members;

  template <class Member>
  void operator()(const Key& key, const Member& value) {
    members.push_back({key, Convert<Member>::type_name(),
                       [key, value] { return Convert<Member>::show(key, value); },
                       &checked<Member>});
  }
};

template <class T>
auto record_class(py::module_& module, const char* name) {
  if constexpr (std::is_base_of_v<NoFamily, Record<T>>) {
    return py::class_<Record<T>>(module, name, py::dynamic_attr());
  } else {
    return py::class_<Record<T>, typename FamilyOf<T>::type>(module, name, py::dynamic_attr());
  }
}

/// Bind T and its members.
template <class T>
auto bind_struct(py::module_& module, const char* name, const std::string& summary) {
  auto bound = record_class<T>(module, name);
  MemberCollector collector;
  const T defaults{};
  T::describe(defaults, collector);
  bind_members(bound, name, summary, collector.members,
               [](py::detail::value_and_holder& holder) { holder.value_ptr() = new Record<T>(); });
  return bound;
}

}  // namespace lapilli::python
