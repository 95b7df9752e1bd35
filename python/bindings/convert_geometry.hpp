#pragma once

#include "bind_struct.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli::python {

template <class T, class Variant>
inline constexpr bool is_alternative = false;
template <class T, class... Alternatives>
inline constexpr bool is_alternative<T, std::variant<Alternatives...>> =
    (std::is_same_v<T, Alternatives> || ...);

/// The base of every shape class: isinstance(x, lapilli.Shape).
struct AnyShape {};
template <class T>
concept ShapeKind = is_alternative<T, Shape::variant>;
template <ShapeKind T>
struct FamilyOf<T> {
  using type = AnyShape;
};

template <>
struct Convert<Shape> {
  static constexpr bool keeps_object = true;
  static std::string type_name() { return "Shape"; }
  static void load(const Where& where, py::handle given, Shape& member);
  static py::object show(const Key& key, const Shape& member);
};

template <>
struct Convert<Nested> {
  static constexpr bool keeps_object = true;
  static std::string type_name() { return "Shape"; }
  static void load(const Where& where, py::handle given, Nested& member);
  static py::object show(const Key& key, const Nested& member);
};

}  // namespace lapilli::python
