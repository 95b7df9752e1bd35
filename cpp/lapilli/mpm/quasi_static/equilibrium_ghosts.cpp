#include <algorithm>

#include "lapilli/mpm/quasi_static/equilibrium.hpp"

namespace lapilli {

template <int Dim>
void Equilibrium<Dim>::add_ghosts(const Eigen::VectorXd& held_back, Eigen::VectorXd& internal,
                                  Eigen::VectorXd& cancelled) const {
  if (loads_.ghost <= 0.0) {
    return;
  }
  using Columns = Eigen::Matrix<double, Dim, Eigen::Dynamic>;
  for (int axis = 0; axis < Dim; ++axis) {
    const Eigen::MatrixXd size = ghost_matrix_[axis].cwiseAbs();
    for (const CellBox<Dim>& pair : loads_.ghost_pairs[axis]) {
      const Eigen::VectorXd local = gather(pair, held_back);
      const Eigen::Map<const Columns> values(local.data(), Dim, pair.node_count());
      const double stiffness = ghost_stiffness(pair, axis);
      const Columns resisted = stiffness * values * ghost_matrix_[axis];
      const Columns parts = stiffness * values.cwiseAbs() * size;
      scatter(pair, Eigen::Map<const Eigen::VectorXd>(resisted.data(), resisted.size()), internal);
      scatter(pair, Eigen::Map<const Eigen::VectorXd>(parts.data(), parts.size()), cancelled);
    }
  }
}

/// Elastic stiffness would bear more and more of what flows: the ghosts of cells that yield have
/// what is left of theirs.
template <int Dim>
double Equilibrium<Dim>::ghost_stiffness(const CellBox<Dim>& pair, int axis) const {
  const Index cell = grid_.cell_index(pair.first), next = cell + grid_.cell_stride(axis);
  const double stiffness = loads_.ghost * 0.5 * (state_.youngs[cell] + state_.youngs[next]);
  return loads_.stiffness_left.empty()
             ? stiffness
             : stiffness * std::min(loads_.stiffness_left[cell], loads_.stiffness_left[next]);
}

#define LAPILLI_INSTANTIATE(Dim)                                                       \
  template void Equilibrium<Dim>::add_ghosts(const Eigen::VectorXd&, Eigen::VectorXd&, \
                                             Eigen::VectorXd&) const;                  \
  template double Equilibrium<Dim>::ghost_stiffness(const CellBox<Dim>& pair, int axis) const;
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
