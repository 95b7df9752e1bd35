#include "lapilli/mpm/dynamics/project_to_grid.hpp"

#include "lapilli/mpm/dynamics/cell_sums.hpp"
#include "lapilli/mpm/dynamics/mover.hpp"

#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {
namespace {

template <int Dim>
constexpr int stress_index(int i, int j) {
  constexpr int full[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  return full[i][j];
}

template <int Dim, class Shape, VelocityTransfer transfer>
void project_rows(DynamicsData<Dim>& data, const NodeField<Dim>& field, double step, Index begin,
                  Index end) {
  const Stencil<Dim, Shape> stencil(field.grid);
  constexpr bool fades = transfer == VelocityTransfer::blended_apic;
  constexpr int arrays = 1 + 2 * Dim + (fades ? 1 : 0),
                components = DynamicsData<Dim>::stress_components;
  constexpr int quads = Stencil<Dim, Shape>::quads;
  double* to[arrays] = {data.nodes.mass()};
  for (int axis = 0; axis < Dim; ++axis) {
    to[1 + axis] = data.nodes.velocity(axis);
    to[1 + Dim + axis] = data.nodes.increment(axis);
  }
  if constexpr (fades) {
    to[arrays - 1] = data.nodes.fade();
  }
  CellSums<Dim, Shape, arrays> sums(stencil, to);
  const ShapeOfBody<Shape> shape_of(data.half_widths);
  const Grid<Dim> grid = field.grid;
  const Index offset = field.offset;
  const double h = grid.cell_size();
  double* position = data.points.position().data();
  const double* volume = data.points.volume().data();
  const Index* body = data.points.body().data();
  const double *mass = data.mass.data(), *velocity = data.velocity.data();
  const double* stress = data.stress.data();
  const double* affine = data.affine ? data.affine->data() : nullptr;
  const double* carried = data.carried ? data.carried->data() : nullptr;
  const CellDilatation<Dim>* averaged = data.dilatation.get();
  const Mover<Dim> move(data, 0.5 * step);
  for (Index row = begin; row < end; ++row) {
    if constexpr (is_affine<transfer, Shape>) {
      move.drift(position + row * Dim, carried + row * Dim);
    }
    const AxisWeights<Dim, Shape> axes(grid, shape_of(body[row]), position + row * Dim, offset);
    const SimdWeights<Dim, Shape> w(axes.value, axes.slope);
    sums.move_to(axes.first);
    for (int q = 0; q < quads; ++q) {
      sums.sum[0][q] += w.value[q] * mass[row];
    }
    add_momentum<transfer>(sums, 1, w, axes, h, mass[row], velocity + row * Dim,
                           affine ? affine + row * Dim * Dim : nullptr);
    if constexpr (fades) {
      const double rate = mass[row] * (*data.strain_rate)[row];
      for (int q = 0; q < quads; ++q) {
        sums.sum[arrays - 1][q] += w.value[q] * rate;
      }
    }
    double load[components];
    for (int c = 0; c < components; ++c) {
      load[c] = -volume[row] * stress[row * components + c];
    }
    if (averaged && averaged->of_body(body[row])) {
      // The mean stress acts through the cells.
      const double mean = mean_stress<Dim>(load);
      for (int axis = 0; axis < Dim; ++axis) {
        load[axis] -= mean;
      }
    }
    for (int axis = 0; axis < Dim; ++axis) {
      for (int q = 0; q < quads; ++q) {
        Double4 force = w.slope[0][q] * load[stress_index<Dim>(axis, 0)];
        for (int along = 1; along < Dim; ++along) {
          force += w.slope[along][q] * load[stress_index<Dim>(axis, along)];
        }
        sums.sum[1 + Dim + axis][q] += force;
      }
    }
  }
}

}  // namespace

template <int Dim>
void project_to_grid(DynamicsData<Dim>& data, double step) {
  data.clear_nodes();
  with_transfer(data.shape, data.settings.transfer, [&]<class Shape, VelocityTransfer transfer>() {
    const auto project = [&](const NodeField<Dim>& field, Index begin, Index end) {
      project_rows<Dim, Shape, transfer>(data, field, step, begin, end);
    };
    data.order.for_each_strip([&](Index begin, Index end) {
      data.fields.for_each_run(data.points.body().data(), begin, end, project);
    });
  });
  if (data.dilatation) {
    add_mean_stress(data);
  }
}

template void project_to_grid<2>(DynamicsData<2>&, double);
template void project_to_grid<3>(DynamicsData<3>&, double);

}  // namespace lapilli
