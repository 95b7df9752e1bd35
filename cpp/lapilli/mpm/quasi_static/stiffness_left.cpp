#include "lapilli/mpm/quasi_static/stiffness_left.hpp"

namespace lapilli {

template <int Dim>
std::vector<double> stiffness_left(const Grid<Dim>& grid, const PointWeights<Dim>& weights,
                                   std::span<const double> volume, std::span<const Index> body,
                                   const SolidState& solids,
                                   const std::function<SymmetricTensor(Index)>& increment) {
  std::vector<double> around(static_cast<std::size_t>(grid.cell_count()), 0.0), left(around);
  for (const Index p : weights.order()) {
    const double share = solids.stiffness_left(p, body[p], increment(p));
    for_each_cell(grid, weights.box(p), [&](Index cell) {
      around[cell] += volume[p];
      left[cell] += volume[p] * share;
    });
  }
  for (std::size_t cell = 0; cell < left.size(); ++cell) {
    left[cell] = around[cell] > 0.0 ? left[cell] / around[cell] : 1.0;
  }
  return left;
}

#define LAPILLI_INSTANTIATE(Dim)                                                                   \
  template std::vector<double> stiffness_left(                                                     \
      const Grid<Dim>&, const PointWeights<Dim>&, std::span<const double>, std::span<const Index>, \
      const SolidState&, const std::function<SymmetricTensor(Index)>&);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
