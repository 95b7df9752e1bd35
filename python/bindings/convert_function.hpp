#pragma once

#include "convert_core.hpp"
#include "lapilli/materials/function_solid.hpp"

namespace lapilli::python {

/// A callable over blocks of points: (strain_increment (n, 6), stress (n, 6), state (n, variables),
/// time_step) to the stress (n, 6), or to a pair of stress and state.
template <>
struct Convert<BlockFunction> {
  static constexpr bool keeps_object = false;
  static std::string type_name() { return "collections.abc.Callable[..., typing.Any]"; }
  static void load(const Where& where, py::handle given, BlockFunction& member);
  static py::object show(const Key& key, const BlockFunction& member);
};

}  // namespace lapilli::python
