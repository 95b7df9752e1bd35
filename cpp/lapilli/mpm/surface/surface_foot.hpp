#pragma once

#include <functional>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Where a point of the material touches a surface.
template <int Dim>
struct SurfaceFoot {
  Index row = 0;      // of the point
  Vec<Dim> place;     // m, on the surface
  Vec<Dim> normal;    // of the surface, into the material
  double area = 0.0;  // m^(dim-1), what the point stands for: right in the mean alone
};

template <int Dim>
using FindFeet = std::function<std::vector<SurfaceFoot<Dim>>()>;

}  // namespace lapilli
