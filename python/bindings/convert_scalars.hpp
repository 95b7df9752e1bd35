#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/allowed.hpp"
#include "lapilli/core/describe.hpp"
#include "lapilli/core/vector.hpp"
#include "lapilli/scene/member_types.hpp"

namespace lapilli::python {

namespace py = pybind11;

/// Any array of numbers, made contiguous.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// The path of a str or os.PathLike. Throws TypeError for anything else.
inline std::string file_name(const py::handle& path) {
  return std::string(py::str(py::module_::import("os").attr("fspath")(path)));
}

/// Where a value is being read, for messages: the key and the object that holds it.
struct Where {
  Key key;
  std::string owner;  // "Grid", or "bodies[0]"

  std::string path() const { return joined(*key.name == '\0' ? "" : "."); }
  [[noreturn]] void refuse(const std::string& expected, py::handle given) const {
    throw py::type_error(message(joined(*key.name == '\0' ? "" : ": "), " must be ", expected,
                                 ", got ", std::string(py::repr(given)).substr(0, 80)));
  }

 private:
  std::string joined(const char* between) const {
    return owner.empty() ? key.name : owner + between + key.name;
  }
};

/// While one lives, objects of bound classes inside of what is read on this thread are taken as
/// they are: they were checked when they were made. Else a nest of n shapes would be checked n^2 /
/// 2 times.
class TrustObjects {
 public:
  TrustObjects() : outer_(std::exchange(on(), true)) {}
  ~TrustObjects() { on() = outer_; }
  TrustObjects(const TrustObjects&) = delete;
  TrustObjects& operator=(const TrustObjects&) = delete;
  static bool& on() {
    static thread_local bool trusted = false;
    return trusted;
  }

 private:
  bool outer_;
};

/// How a member of a described struct is read from Python, shown to Python and named in signatures.
/// `keeps_object`: an attribute holds the object the user gave, so that it stays shared.
template <class Member>
struct Convert;

/// Whether a number of NumPy is complex or a truth value: read as a number it would lose what it
/// says.
inline bool is_other_kind(py::handle given) {
  if (PyFloat_CheckExact(given.ptr()) || PyLong_CheckExact(given.ptr())) {
    return false;  // the most usual, in lists of thousands
  }
  if (PyComplex_Check(given.ptr()) || PyBool_Check(given.ptr())) {
    return true;
  }
  if (!py::hasattr(given, "dtype") || !py::hasattr(given.attr("dtype"), "kind")) {
    return false;
  }
  const std::string kind = py::str(given.attr("dtype").attr("kind"));
  return kind == "b" || kind == "c";
}

template <>
struct Convert<double> {
  static constexpr bool keeps_object = false;
  static std::string type_name() { return "float"; }
  static void load(const Where& where, py::handle given, double& member) {
    if (is_other_kind(given) || PyUnicode_Check(given.ptr()) || !PyNumber_Check(given.ptr())) {
      where.refuse("a number", given);
    }
    member = PyFloat_AsDouble(given.ptr());
    if (PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      where.refuse("a number", given);
    }
    check_range(where.key, member, where.owner);
  }
  static py::object show(const Key&, double member) { return py::float_(member); }
};

template <class Integer>
requires(std::is_integral_v<Integer> && !std::is_same_v<Integer, bool>) struct Convert<Integer> {
  static constexpr bool keeps_object = false;
  static std::string type_name() { return "int"; }
  static void load(const Where& where, py::handle given, Integer& member) {
    const auto number = is_other_kind(given)
                            ? py::object()
                            : py::reinterpret_steal<py::object>(PyNumber_Index(given.ptr()));
    PyErr_Clear();
    if (!number) {
      where.refuse("an integer", given);
    }
    int overflow = 0;
    const long long value = PyLong_AsLongLongAndOverflow(number.ptr(), &overflow);
    member = static_cast<Integer>(value);
    if (overflow != 0 || member != value) {
      where.refuse("an integer of ordinary size", given);
    }
    check_range(where.key, static_cast<double>(value), where.owner);
  }
  static py::object show(const Key&, Integer member) { return py::int_(member); }
};

template <>
struct Convert<bool> {
  static constexpr bool keeps_object = false;
  static std::string type_name() { return "bool"; }
  static void load(const Where& where, py::handle given, bool& member) {
    if (!PyBool_Check(given.ptr())) {
      where.refuse("True or False", given);
    }
    member = given.ptr() == Py_True;
  }
  static py::object show(const Key&, bool member) { return py::bool_(member); }
};

template <>
struct Convert<std::string> {
  static constexpr bool keeps_object = false;
  static std::string type_name() { return "str"; }
  static void load(const Where& where, py::handle given, std::string& member) {
    const auto path = py::module_::import("os").attr("PathLike");
    if (PyUnicode_Check(given.ptr()) || py::isinstance(given, path)) {
      member = std::string(py::str(given));
    } else {
      where.refuse("a string", given);
    }
  }
  static py::object show(const Key&, const std::string& member) { return py::str(member); }
};

/// Enumerations are strings in Python, spelled as in a scene file.
template <class Enum>
requires std::is_enum_v<Enum>
struct Convert<Enum> {
  static constexpr bool keeps_object = false;
  static std::string type_name() {
    std::string names;
    for (const auto& [value, name] : Names<Enum>::values) {
      names += message(names.empty() ? "" : ", ", "'", name, "'");
    }
    return "typing.Literal[" + names + "]";
  }
  static void load(const Where& where, py::handle given, Enum& member) {
    if (!PyUnicode_Check(given.ptr())) {
      where.refuse("a string", given);
    }
    const std::string text = py::str(given);
    std::vector<std::string> names;
    for (const auto& [value, name] : Names<Enum>::values) {
      if (text == name) {
        member = value;
        return;
      }
      names.emplace_back(name);
    }
    throw py::value_error(unknown_name(where.path(), text, names));
  }
  static py::object show(const Key&, Enum member) { return py::str(name_of(member)); }
};

}  // namespace lapilli::python
