#include "lapilli/geometry/shape_volume.hpp"

#include "lapilli/geometry/clipped.hpp"

namespace lapilli {

double volume_of(const Shape& shape, const Lattice& lattice, const FillOptions& options,
                 int dimension) {
  const Shape body = ready_to_fill(shape, lattice, options, dimension);
  return volume_of(parts_of(body, Sites(body, lattice, options, dimension)));
}

}  // namespace lapilli
