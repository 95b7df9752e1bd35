#include "lapilli/mpm/dynamics/dynamics.hpp"
#include "lapilli/mpm/dynamics/point_kernel.hpp"

namespace lapilli {

template <int Dim>
void Dynamics<Dim>::start_affine(const DynamicsProblem<Dim>& problem) {
  if (!data_.affine) {
    return;
  }
  const Grid<Dim>& grid = data_.grid;
  const double reach = 0.25 * grid.cell_size();
  with_transfer(data_.shape, data_.settings.transfer,
                [&]<class Shape, VelocityTransfer transfer>() {
                  const ShapeOfBody<Shape> shape_of(data_.half_widths);
                  for (Index row = 0; row < data_.points.size(); ++row) {
                    const Index body = data_.points.body()[row];
                    const auto& velocity = problem.bodies[body].velocity;
                    if (!velocity) {
                      continue;
                    }
                    const AxisWeights<Dim, Shape> axes(grid, shape_of(body),
                                                       data_.points.position().data() + row * Dim);
                    Vec3 place = Vec3::Zero();
                    place.head<Dim>() = data_.points.template position<Dim>(row);
                    for (int along = 0; along < Dim; ++along) {
                      const Vec3 to_side = reach * Vec3::Unit(along);
                      const Vec3 slope =
                          (velocity(place + to_side) - velocity(place - to_side)) / (2.0 * reach);
                      const double scale = transfer == VelocityTransfer::apic
                                               ? second_moment(axes, grid.cell_size(), along)
                                               : 1.0;
                      for (int axis = 0; axis < Dim; ++axis) {
                        (*data_.affine)[row * Dim * Dim + axis * Dim + along] = scale * slope[axis];
                      }
                    }
                  }
                });
}

template void Dynamics<2>::start_affine(const DynamicsProblem<2>&);
template void Dynamics<3>::start_affine(const DynamicsProblem<3>&);

}  // namespace lapilli
