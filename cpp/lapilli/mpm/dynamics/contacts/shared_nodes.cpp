#include "lapilli/mpm/dynamics/contacts/shared_nodes.hpp"

#include <algorithm>

#include "lapilli/mpm/dynamics/point_kernel.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {
template <int Dim>
SharedNodes<Dim>::SharedNodes(const DynamicsData<Dim>& data,
                              const std::vector<DynamicsBody>& bodies) {
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    depth_.emplace_back(data.shape, data.half_widths[body], 2.0 * bodies[body].half_width);
  }
}

template <int Dim>
void SharedNodes<Dim>::find(const DynamicsData<Dim>& data,
                            const std::vector<std::pair<int, int>>& pairs) {
  for (const Index node : touched_) {
    slot_[node] = -1;
  }
  touched_.clear();
  nodes_.clear();
  begin_.assign(1, 0);
  for (const auto& [a, b] : pairs) {
    scan(data, a, b);
    begin_.push_back(nodes_.size());
  }
  if (nodes_.empty()) {
    return;
  }
  number(data, pairs);
  project(data);
  body_of_field_.assign(static_cast<std::size_t>(data.fields.count()), 0);
  for (int body = static_cast<int>(depth_.size()) - 1; body >= 0; --body) {
    body_of_field_[data.fields.index_of(body)] = body;
  }
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    measure(data, pairs[pair], of(pair));
  }
}

/// Nodes in both windows that carry mass in both fields.
template <int Dim>
void SharedNodes<Dim>::scan(const DynamicsData<Dim>& data, int a, int b) {
  const NodeField<Dim>&one = data.fields[a], &two = data.fields[b];
  std::array<int, Dim> lower, upper;
  for (int axis = 0; axis < Dim; ++axis) {
    lower[axis] = std::max(one.corner[axis], two.corner[axis]);
    upper[axis] =
        std::min(one.corner[axis] + one.grid.nodes(axis), two.corner[axis] + two.grid.nodes(axis));
    if (lower[axis] >= upper[axis]) {
      return;
    }
  }
  const double* mass = data.nodes.mass();
  std::array<int, Dim> at = lower;
  const auto index = [&](const NodeField<Dim>& field) {
    auto local = at;
    for (int axis = 0; axis < Dim; ++axis) {
      local[axis] -= field.corner[axis];
    }
    return field.offset + field.grid.node_index(local);
  };
  for (;;) {
    const Index first = index(one), second = index(two);
    for (int k = 0; k < upper[0] - lower[0]; ++k) {
      if (mass[first + k] > data.empty_node && mass[second + k] > data.empty_node) {
        SharedNode<Dim> node{.first = first + k, .second = second + k, .at = at};
        node.at[0] += k;
        nodes_.push_back(node);
      }
    }
    int axis = 1;
    for (; axis < Dim && ++at[axis] == upper[axis]; ++axis) {
      at[axis] = lower[axis];
    }
    if (axis == Dim) {
      return;
    }
  }
}

/// Give a field's node a slot, and mark the stencils that meet it.
template <int Dim>
void SharedNodes<Dim>::mark(const DynamicsData<Dim>& data, Index node,
                            const NodeField<Dim>& field) {
  if (slot_[node] >= 0) {
    return;
  }
  slot_[node] = static_cast<int>(touched_.size());
  touched_.push_back(node);
  const int support = support_of(data.shape), layers = Dim == 3 ? support : 1;
  for (int k = 0; k < layers; ++k) {
    for (int j = 0; j < support; ++j) {
      for (int i = 0; i < support; ++i) {
        const Index across = Dim == 3 ? k * field.grid.node_stride(Dim - 1) : 0;
        const Index lowest = node - i - j * field.grid.node_stride(1) - across;
        if (lowest >= field.offset) {
          near_[lowest] = 1;
        }
      }
    }
  }
}

template <int Dim>
void SharedNodes<Dim>::number(const DynamicsData<Dim>& data,
                              const std::vector<std::pair<int, int>>& pairs) {
  const auto count = static_cast<std::size_t>(data.fields.node_count());
  slot_.resize(std::max(count, slot_.size()), -1);
  near_.assign(count, 0);
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    for (const SharedNode<Dim>& node : of(pair)) {
      mark(data, node.first, data.fields[pairs[pair].first]);
      mark(data, node.second, data.fields[pairs[pair].second]);
    }
  }
  sums_.assign(touched_.size() * moments, 0.0);
}

template <int Dim>
template <class Shape>
void SharedNodes<Dim>::project_rows(const DynamicsData<Dim>& data, const NodeField<Dim>& field,
                                    Index begin, Index end) {
  constexpr int support = Shape::support;
  const ShapeOfBody<Shape> shape_of(data.half_widths);
  const Grid<Dim> grid = field.grid;
  const double scale = grid.inverse_cell_size(), h = grid.cell_size();
  const double* position = data.points.position().data();
  for (Index row = begin; row < end; ++row) {
    Index lowest = field.offset;
    for (int axis = 0; axis < Dim; ++axis) {
      const double at = (position[row * Dim + axis] - grid.origin()[axis]) * scale;
      lowest += Shape::base(at) * grid.node_stride(axis);
    }
    if (!near_[lowest]) {
      continue;
    }
    const AxisWeights<Dim, Shape> w(grid, shape_of(data.points.body()[row]), position + row * Dim,
                                    field.offset);
    const double volume = data.points.volume()[row];
    for (int node = 0; node < (Dim == 2 ? 1 : support) * support * support; ++node) {
      const int at[3] = {node % support, node / support % support, node / (support * support)};
      Index index = w.first;
      double value = volume;
      for (int axis = 0; axis < Dim; ++axis) {
        index += at[axis] * grid.node_stride(axis);
        value *= w.value[axis][at[axis]];
      }
      if (slot_[index] < 0) {
        continue;
      }
      double* sum = sums_.data() + moments * slot_[index];
      sum[0] += value;
      for (int axis = 0; axis < Dim; ++axis) {
        sum[1 + axis] += value * h * (w.at[axis] - w.base[axis] - at[axis]);
        double slope = volume * w.slope[axis][at[axis]];
        for (int other = 0; other < Dim; ++other) {
          slope *= other == axis ? 1.0 : w.value[other][at[other]];
        }
        sum[1 + Dim + axis] += slope;
      }
    }
  }
}

template <int Dim>
void SharedNodes<Dim>::project(const DynamicsData<Dim>& data) {
  with_transfer(data.shape, VelocityTransfer::flip, [&]<class Shape, VelocityTransfer>() {
    const auto rows = [&](const NodeField<Dim>& field, Index begin, Index end) {
      project_rows<Shape>(data, field, begin, end);
    };
    data.order.for_each_strip([&](Index begin, Index end) {
      data.fields.for_each_run(data.points.body().data(), begin, end, rows);
    });
  });
}

template class SharedNodes<2>;
template class SharedNodes<3>;

}  // namespace lapilli
