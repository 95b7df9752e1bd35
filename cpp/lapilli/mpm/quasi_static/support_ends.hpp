#pragma once

#include <vector>

#include "lapilli/mpm/quasi_static/boundary.hpp"

namespace lapilli {

/// The end of a wall beside which the material goes on, free: where a footing ends, or the foot of
/// a dome. Held as firmly as the rest, the last node of the wall would carry half a cell of what is
/// free along, up to one and a half cells where the wall ends just behind a node.
struct SupportEnd {
  std::vector<std::size_t> facets;  // within a cell of the end
  std::size_t next = 0;             // the facet further in
};

/// Of all walls; none where the shapes of the bodies are not known.
template <int Dim>
std::vector<SupportEnd> support_ends(const Grid<Dim>& grid, const Boundary<Dim>& boundary,
                                     std::span<const Facet<Dim>> facets, double time);

}  // namespace lapilli
