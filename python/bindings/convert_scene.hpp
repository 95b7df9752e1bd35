#pragma once

#include "convert_core.hpp"
#include "convert_function.hpp"
#include "convert_geometry.hpp"
#include "lapilli/scene/scene_file.hpp"

namespace lapilli::python {

/// A pair (positions (n, dim), volumes (n,)) or a lapilli.Points.
template <>
struct Convert<GivenPoints> {
  static constexpr bool keeps_object = false;
  static std::string type_name() { return "Points"; }
  static void load(const Where& where, py::handle given, GivenPoints& member);
  static py::object show(const Key& key, const GivenPoints& member);
};

/// A dict of what keys take, by their paths: numbers, words, lists, tables in time, and dicts as
/// the tables of a file.
template <>
struct Convert<Overrides> {
  static constexpr bool keeps_object = true;
  static std::string type_name() { return "dict[str, typing.Any]"; }
  static void load(const Where& where, py::handle given, Overrides& member);
  static py::object show(const Key& key, const Overrides& member);
};

/// A scene that was read from a file remembers where its keys stand there.
template <>
struct Extras<Scene> {
  static void load(const py::dict& attributes, Scene& scene);
  static void show(const Scene& scene, py::dict& attributes);
};

/// The C++ scene of a Python one.
Scene scene_of(const py::object& scene);

}  // namespace lapilli::python

namespace pybind11::detail {

template <>
class type_caster<lapilli::GivenPoints>
    : public lapilli::python::InitializedCaster<lapilli::GivenPoints> {};

}  // namespace pybind11::detail
