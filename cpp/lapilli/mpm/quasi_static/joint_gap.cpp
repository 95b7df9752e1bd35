#include "lapilli/mpm/quasi_static/joint_gap.hpp"

#include <algorithm>

namespace lapilli {
namespace {

/// The smallest box that holds all the cells.
template <int Dim>
CellBox<Dim> box_of(std::span<const Facet<Dim>> facets, std::span<const std::size_t> members) {
  auto low = facets[members[0]].cell, high = low;
  for (const std::size_t f : members) {
    for (int axis = 0; axis < Dim; ++axis) {
      low[axis] = std::min(low[axis], facets[f].cell[axis]);
      high[axis] = std::max(high[axis], facets[f].cell[axis]);
    }
  }
  CellBox<Dim> box{low, {}};
  for (int axis = 0; axis < Dim; ++axis) {
    box.cells[axis] = high[axis] - low[axis] + 1;
  }
  return box;
}

}  // namespace

template <int Dim>
Vec<Dim> JointGap<Dim>::total(const Eigen::VectorXd& u) const {
  const Eigen::VectorXd on_nodes = force(u);
  Vec<Dim> sum = Vec<Dim>::Zero();
  for (int a = 0; a < box.node_count(); ++a) {
    sum += on_nodes.segment<Dim>(Dim * a);
  }
  return sum;
}

template <int Dim>
JointGap<Dim> joint_gap(const Grid<Dim>& grid, const CellState<Dim>& state,
                        std::span<const Facet<Dim>> facets, std::span<const std::size_t> members,
                        HeldMotion kind, std::span<const std::vector<Vec<Dim>>> motions,
                        const SupportScheme& scheme) {
  JointGap<Dim> joint;
  joint.box = box_of<Dim>(facets, members);
  joint.wall = facets[members[0]].surface;
  joint.mean = JointGap<Dim>::Means::Zero(Dim * joint.box.node_count(), Dim);
  joint.motion.setZero();
  joint.stiffness.setZero();
  double area = 0.0, modulus = 0.0;
  for (const std::size_t f : members) {
    const Facet<Dim>& facet = facets[f];
    const Index cell = grid.cell_index(facet.cell);
    modulus = std::max(modulus, state.lame[cell] + 2.0 * state.shear[cell]);
    for (std::size_t q = 0; q < facet.points.size(); ++q) {
      const SurfacePoint<Dim>& point = facet.points[q];
      Mat<Dim> held = Mat<Dim>::Identity();
      if (kind == HeldMotion::roller) {
        held.setZero();
        held.col(0) = point.normal;
      }
      double value[1 << Dim];
      Vec<Dim> gradient[1 << Dim];
      cell_shape<Dim>(grid, facet.cell, point.position, value, gradient);
      for (int a = 0; a < (1 << Dim); ++a) {
        const int node = joint.box.node(facet.cell, a);
        joint.mean.template middleRows<Dim>(Dim * node) += point.weight * value[a] * held;
      }
      joint.motion += point.weight * held.transpose() * motions[f][q];
      area += point.weight;
    }
  }
  const double stiffness = scheme.stiff * grid.inverse_cell_size() * modulus / area;
  joint.stiffness.head(kind == HeldMotion::roller ? 1 : Dim).setConstant(stiffness);
  return joint;
}

#define LAPILLI_INSTANTIATE(Dim)                                                              \
  template struct JointGap<Dim>;                                                              \
  template JointGap<Dim> joint_gap(const Grid<Dim>&, const CellState<Dim>&,                   \
                                   std::span<const Facet<Dim>>, std::span<const std::size_t>, \
                                   HeldMotion, std::span<const std::vector<Vec<Dim>>>,        \
                                   const SupportScheme&);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
