#pragma once

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// A place with zeros for the axes it has not.
template <int Dim>
Vec3 in_space(const Vec<Dim>& place) {
  Vec3 at = Vec3::Zero();
  at.template head<Dim>() = place;
  return at;
}

}  // namespace lapilli
