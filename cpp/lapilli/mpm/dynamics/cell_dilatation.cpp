#include "lapilli/mpm/dynamics/cell_dilatation.hpp"

#include <algorithm>

#include "lapilli/mpm/dynamics/cell_parts.hpp"
#include "lapilli/mpm/dynamics/point_kernel.hpp"

#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {
namespace {

template <int Dim, class Shape>
void add_rows(DynamicsData<Dim>& data, const NodeField<Dim>& field, Index begin, Index end) {
  constexpr int quads = Stencil<Dim, LinearShape>::quads;
  constexpr int components = DynamicsData<Dim>::stress_components;
  using Cells = CellDilatation<Dim>;
  Cells& cells = *data.dilatation;
  double* to[Cells::sums] = {cells.volume()};
  for (int axis = 0; axis < Dim; ++axis) {
    to[1 + axis] = cells.middle(axis);
  }
  for (int axis = 0; axis < Cells::crossed; ++axis) {
    to[1 + Dim + axis] = cells.cross(axis);
  }
  to[Cells::sums - 1] = cells.stress();
  const Stencil<Dim, LinearShape> stencil(field.grid);
  CellSums<Dim, LinearShape, Cells::sums> sums(stencil, to);
  const ShapeOfBody<Shape> shape_of(data.half_widths);
  const double* position = data.points.position().data();
  const double* volumes = data.points.volume().data();
  const Index* body = data.points.body().data();
  for (Index row = begin; row < end; ++row) {
    if (!cells.of_body(body[row])) {
      continue;
    }
    const CellParts<Dim, Shape> parts(field.grid, shape_of(body[row]), position + row * Dim,
                                      field.offset);
    const SimdWeights<Dim, LinearShape> w(parts.share, parts.moment);
    sums.move_to(parts.first);
    const double volume = volumes[row];
    const double force = volume * mean_stress<Dim>(data.stress.data() + row * components);
    for (int q = 0; q < quads; ++q) {
      sums.sum[0][q] += w.value[q] * volume;
      sums.sum[Cells::sums - 1][q] += w.value[q] * force;
      for (int axis = 0; axis < Dim; ++axis) {
        sums.sum[1 + axis][q] += w.slope[axis][q] * volume;
      }
    }
    if constexpr (Dim == 3) {
      for (int axis = 0; axis < 3; ++axis) {
        double both[3][2];
        for (int k = 0; k < 3; ++k) {
          std::copy_n(k == axis ? parts.share[k] : parts.moment[k], 2, both[k]);
        }
        const SimdWeights<3, LinearShape> product(both, both);
        for (int q = 0; q < quads; ++q) {
          sums.sum[1 + Dim + axis][q] += product.value[q] * volume;
        }
      }
    }
  }
}

/// From a cell, which has the number of its lowest node, to the nodes at its corners.
template <int Dim>
struct Corners {
  static constexpr int count = 1 << Dim;

  explicit Corners(const Grid<Dim>& grid) {
    for (int corner = 0; corner < count; ++corner) {
      for (int axis = 0; axis < Dim; ++axis) {
        offset[corner] += ((corner >> axis) & 1) * grid.node_stride(axis);
      }
    }
  }

  Index offset[count] = {};
};

/// Call body(cell or node, corners) in parallel for those of every field that are in use.
template <int Dim, class Body>
void for_each_node(const DynamicsData<Dim>& data, const Body& body) {
  for (int field = 0; field < data.fields.count(); ++field) {
    const NodeField<Dim>& window = data.fields[field];
    const Corners<Dim> corners(window.grid);
    const Index first = std::max(window.offset, data.nodes.first());
    const Index last = std::min(window.end(), data.nodes.last());
    parallel_for(std::max<Index>(last - first, 0), [&](Index k) { body(first + k, corners); });
  }
}

/// Whether it yields at the same shear under any pressure, and so without change of volume.
bool keeps_volume(const auto& solid) {
  if constexpr (requires { solid.friction_angle.size(); }) {
    return std::ranges::all_of(solid.friction_angle, [](double angle) { return angle == 0.0; });
  } else if constexpr (requires { solid.friction_angle; }) {
    return solid.friction_angle == 0.0;
  } else {
    return requires { solid.yield_stress; };
  }
}

}  // namespace

bool averages_dilatation(const DynamicsSettings& settings, const Solid& solid) {
  constexpr double locking = 0.4;  // Poisson ratio
  return settings.b_bar.value_or(
      elastic_part(solid).poissons_ratio > locking ||
      std::visit([](const auto& one) { return keeps_volume(one); }, solid));
}

template <int Dim>
void CellDilatation<Dim>::clear(Index first, Index last, Index count) {
  if (count > size_) {
    size_ = count + count / 4;
    values_.assign(static_cast<std::size_t>(size_ * (sums + 1)), 0.0);
  }
  const Index from = first_ < last_ ? std::min(first_, first) : first, to = std::max(last_, last);
  parallel_ranges(to - from, [&](Index begin, Index end) {
    for (int which = 0; which < sums; ++which) {
      std::fill(array(which) + from + begin, array(which) + from + end, 0.0);
    }
  });
  first_ = first;
  last_ = last;
}

template <int Dim>
void CellDilatation<Dim>::divide() {
  parallel_for(last_ - first_, [&](Index k) {
    const Index cell = first_ + k;
    if (!(volume()[cell] > 0.0)) {
      return;
    }
    const double inverse = 1.0 / volume()[cell];
    for (int axis = 0; axis < Dim; ++axis) {
      middle(axis)[cell] *= inverse;
    }
    for (int axis = 0; axis < crossed; ++axis) {
      cross(axis)[cell] = cross(axis)[cell] * inverse -
                          middle((axis + 1) % Dim)[cell] * middle((axis + 2) % Dim)[cell];
    }
  });
}

template <int Dim>
void add_mean_stress(DynamicsData<Dim>& data) {
  CellDilatation<Dim>& cells = *data.dilatation;
  cells.clear(data.nodes.first(), data.nodes.last(),
              data.fields.is_single() ? data.grid.node_count() : data.fields.node_count());
  with_transfer(data.shape, data.settings.transfer, [&]<class Shape, VelocityTransfer>() {
    const auto add = [&](const NodeField<Dim>& field, Index begin, Index end) {
      add_rows<Dim, Shape>(data, field, begin, end);
    };
    data.order.for_each_strip([&](Index begin, Index end) {
      data.fields.for_each_run(data.points.body().data(), begin, end, add);
    });
  });
  cells.divide();
  const double* volume = cells.volume();
  const double* stress = cells.stress();
  const AxisArrays<Dim> force = data.nodes.increments();
  const Index first = data.nodes.first();
  const double scale = data.grid.inverse_cell_size();
  for_each_node(data, [&](Index node, const Corners<Dim>& corners) {
    double sum[Dim] = {};
#pragma GCC unroll 8
    for (int corner = 0; corner < Corners<Dim>::count; ++corner) {
      const Index cell = node - corners.offset[corner];
      if (cell < first || !(volume[cell] > 0.0)) {
        continue;
      }
      const typename CellDilatation<Dim>::Mean mean(cells, cell);
      for (int axis = 0; axis < Dim; ++axis) {
        sum[axis] += stress[cell] * mean.slope(corner, axis);
      }
    }
    for (int axis = 0; axis < Dim; ++axis) {
      force[axis][node] -= scale * sum[axis];
    }
  });
}

template <int Dim>
void find_mean_dilatation(DynamicsData<Dim>& data) {
  CellDilatation<Dim>& cells = *data.dilatation;
  const AxisArrays<Dim> velocity = data.settings.stress_update == StressUpdate::musl
                                       ? data.nodes.second_velocities()
                                       : data.nodes.strain_velocities();
  const double* volume = cells.volume();
  double* rate = cells.rate();
  const double scale = data.grid.inverse_cell_size();
  for_each_node(data, [&](Index cell, const Corners<Dim>& corners) {
    if (!(volume[cell] > 0.0)) {
      return;
    }
    const typename CellDilatation<Dim>::Mean mean(cells, cell);
    double sum = 0.0;
#pragma GCC unroll 8
    for (int corner = 0; corner < Corners<Dim>::count; ++corner) {
      for (int axis = 0; axis < Dim; ++axis) {
        sum += mean.slope(corner, axis) * velocity[axis][cell + corners.offset[corner]];
      }
    }
    rate[cell] = scale * sum;
  });
}

template class CellDilatation<2>;
template class CellDilatation<3>;
template void add_mean_stress<2>(DynamicsData<2>&);
template void add_mean_stress<3>(DynamicsData<3>&);
template void find_mean_dilatation<2>(DynamicsData<2>&);
template void find_mean_dilatation<3>(DynamicsData<3>&);

}  // namespace lapilli
