#pragma once

#include <algorithm>

#include "lapilli/mpm/heat/point_grid_transfer.hpp"
#include "lapilli/mpm/transfer/patch_weights.hpp"

namespace lapilli {

/// Calls body(shape_of), where shape_of(b) is the shape function of body b.
template <int Dim>
template <class Body>
void PointGridTransfer<Dim>::with_shapes(const Body& body) const {
  if (shape_ == ShapeFunction::linear) {
    body(OneShape<LinearShape>{});
  } else if (std::all_of(gimp_.begin(), gimp_.end(), [this](const GimpShape& shape) {
               return shape.half_width == gimp_.front().half_width;
             })) {
    body(OneShape<GimpShape>{gimp_.front()});
  } else {
    body([shapes = gimp_.data()](Index b) { return shapes[b]; });
  }
}

}  // namespace lapilli
