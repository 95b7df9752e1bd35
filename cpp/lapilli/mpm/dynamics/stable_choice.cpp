#include "lapilli/mpm/dynamics/stable_choice.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

/// How many different places within their cells points have along one axis.
template <int Dim>
Index places_in_cell(const DynamicsData<Dim>& data, const std::vector<Index>& rows, int axis) {
  std::vector<Index> places;
  places.reserve(rows.size());
  for (const Index row : rows) {
    const double at = (data.points.position()[row * Dim + axis] - data.grid.lower()[axis]) *
                      data.grid.inverse_cell_size();
    places.push_back(std::llround(1e6 * (at - std::floor(at))) % 1000000);
  }
  std::sort(places.begin(), places.end());
  return std::unique(places.begin(), places.end()) - places.begin();
}

/// Whether the points of a body are no lattice along the axes of the grid.
template <int Dim>
bool is_scattered(const DynamicsData<Dim>& data, Index body) {
  std::vector<Index> rows;
  for (Index row = 0; row < data.points.size(); ++row) {
    if (data.points.body()[row] == body) {
      rows.push_back(row);
    }
  }
  constexpr std::size_t few = 16;
  if (rows.size() < few) {
    return false;
  }
  Index fewest = static_cast<Index>(rows.size());
  for (int axis = 0; axis < Dim; ++axis) {
    fewest = std::min(fewest, places_in_cell(data, rows, axis));
  }
  return 2 * fewest > static_cast<Index>(rows.size());
}

}  // namespace

template <int Dim>
void require_stable_choice(const DynamicsData<Dim>& data) {
  if (data.shape != ShapeFunction::linear) {
    return;
  }
  const VelocityTransfer transfer = data.settings.transfer;
  require(transfer != VelocityTransfer::apic && transfer != VelocityTransfer::tpic,
          "dynamics.transfer ", name_of(transfer),
          " needs the shape function gimp or bspline: with a linear one ",
          transfer == VelocityTransfer::apic
              ? "the moment it divides by vanishes where a point meets a node"
              : "its energy grows without end",
          "; blended_apic and flip would do");
  if (data.settings.stress_update == StressUpdate::usl) {
    for (Index body = 0; body < static_cast<Index>(data.materials.size()); ++body) {
      require(!is_scattered(data, body),
              "dynamics.stress_update usl with linear shape functions "
              "needs points on a lattice along the grid, or its energy grows without end: those of "
              "body ",
              body, " lie anywhere in their cells; musl, gimp or bspline would do");
    }
  }
}

template void require_stable_choice<2>(const DynamicsData<2>&);
template void require_stable_choice<3>(const DynamicsData<3>&);

}  // namespace lapilli
