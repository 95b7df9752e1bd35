#include "lapilli/mpm/dynamics/mean_free_strain.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/mpm/dynamics/cell_parts.hpp"

#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {
namespace {

/// By cell: volume, and times volume the free strain, the number of the body and its square.
constexpr int kept = 4;

double* of_cells(LargeArray<double>& values, int which) {
  return values.data() + which * (static_cast<Index>(values.size()) / kept);
}

/// Zero the sums of the cells in use; those of others are never weighed.
template <int Dim>
void clear_free_strain(DynamicsData<Dim>& data) {
  constexpr Index quad = 4;  // past the last node
  const Index cells = data.fields.is_single() ? data.grid.node_count() : data.fields.node_count();
  if (const auto room = static_cast<std::size_t>(kept * (cells + quad));
      data.cell_strain.size() < room) {
    data.cell_strain.assign(room, 0.0);
  }
  const Index first = data.nodes.first();
  parallel_ranges(data.nodes.last() + quad - first, [&](Index begin, Index end) {
    for (int k = 0; k < kept; ++k) {
      double* sum = of_cells(data.cell_strain, k) + first;
      std::fill(sum + begin, sum + end, 0.0);
    }
  });
}

template <int Dim, class Shape>
void add_free_strain(DynamicsData<Dim>& data, const NodeField<Dim>& field, Index begin, Index end) {
  const Stencil<Dim, LinearShape> stencil(field.grid);
  double* to[kept];
  for (int k = 0; k < kept; ++k) {
    to[k] = of_cells(data.cell_strain, k);
  }
  CellSums<Dim, LinearShape, kept> sums(stencil, to);
  const ShapeOfBody<Shape> shape_of(data.half_widths);
  for (Index row = begin; row < end; ++row) {
    const Index body = data.points.body()[row];
    const CellParts<Dim, Shape> parts(field.grid, shape_of(body),
                                      data.points.position().data() + row * Dim, field.offset);
    const SimdWeights<Dim, LinearShape> w(parts.share, parts.moment);
    sums.move_to(parts.first);
    const double volume = data.points.volume()[row], number = static_cast<double>(body);
    const double of_point[kept] = {volume, volume * (*data.free_strain)[row], volume * number,
                                   volume * number * number};
    for (int q = 0; q < sums.quads; ++q) {
      for (int k = 0; k < kept; ++k) {
        sums.sum[k][q] += w.value[q] * of_point[k];
      }
    }
  }
}

/// Means of the cells that hold one body: their strain and one, of others zero and zero.
template <int Dim>
void divide_free_strain(DynamicsData<Dim>& data) {
  double* volume = of_cells(data.cell_strain, 0);
  double* strain = of_cells(data.cell_strain, 1);
  const double* body = of_cells(data.cell_strain, 2);
  const double* square = of_cells(data.cell_strain, 3);
  const Index first = data.nodes.first();
  parallel_for(data.nodes.last() - first, [&](Index k) {
    const Index cell = first + k;
    if (!(volume[cell] > 0.0)) {
      return;
    }
    const double inverse = 1.0 / volume[cell], mean = inverse * body[cell];
    constexpr double several = 1e-6;  // variance of the numbers of bodies, over their square
    const bool one =
        std::abs(inverse * square[cell] - mean * mean) <= several * (1.0 + mean * mean);
    strain[cell] = one ? inverse * strain[cell] : 0.0;
    volume[cell] = one ? 1.0 : 0.0;
  });
}

template <int Dim, class Shape>
void take_mean_strain(DynamicsData<Dim>& data, const NodeField<Dim>& field, Index begin,
                      Index end) {
  const Stencil<Dim, LinearShape> stencil(field.grid);
  CellNodes<Dim, LinearShape, 2> means(
      stencil, {of_cells(data.cell_strain, 0), of_cells(data.cell_strain, 1)});
  const ShapeOfBody<Shape> shape_of(data.half_widths);
  for (Index row = begin; row < end; ++row) {
    const CellParts<Dim, Shape> parts(field.grid, shape_of(data.points.body()[row]),
                                      data.points.position().data() + row * Dim, field.offset);
    const SimdWeights<Dim, LinearShape> w(parts.share, parts.moment);
    means.move_to(parts.first);
    const Double4 share = means.weigh(0, w.value), mean = means.weigh(1, w.value);
    const double averaged = (share[0] + share[1]) + (share[2] + share[3]);
    double& own = (*data.free_strain)[row];
    own = (mean[0] + mean[1]) + (mean[2] + mean[3]) + (1.0 - averaged) * own;
  }
}

}  // namespace

template <int Dim>
void average_free_strain(DynamicsData<Dim>& data) {
  clear_free_strain(data);
  const Index* body = data.points.body().data();
  with_transfer(data.shape, data.settings.transfer, [&]<class Shape, VelocityTransfer>() {
    data.order.for_each_strip([&](Index begin, Index end) {
      data.fields.for_each_run(body, begin, end, [&](const auto& field, Index from, Index to) {
        add_free_strain<Dim, Shape>(data, field, from, to);
      });
    });
    divide_free_strain(data);
    parallel_ranges(data.points.size(), [&](Index begin, Index end) {
      data.fields.for_each_run(body, begin, end, [&](const auto& field, Index from, Index to) {
        take_mean_strain<Dim, Shape>(data, field, from, to);
      });
    });
  });
}

template void average_free_strain<2>(DynamicsData<2>&);
template void average_free_strain<3>(DynamicsData<3>&);

}  // namespace lapilli
