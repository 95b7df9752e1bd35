// Where and how the surfaces of two fields lie around the nodes that they share.
#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/mpm/dynamics/contacts/node_neighbours.hpp"
#include "lapilli/mpm/dynamics/contacts/shared_nodes.hpp"
#include "lapilli/mpm/dynamics/contacts/surface_columns.hpp"

#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {
namespace {

/// How strongly a corner yields to a flat face: power of the length of a sum of gradients over the
/// sum of their lengths, .76 around a corner, .97 on a disk of five cells.
constexpr int flatness_power = 8;

/// cells. Where a face cuts rows of points and what is left is joined, the measured gap of bodies
/// that touch is up to .063; ends of faces add some.
constexpr double body_touching_gap = 0.08;

}  // namespace

template <int Dim>
std::vector<Vec<Dim>> SharedNodes<Dim>::normals_of(const NodeNeighbours<Dim>& near,
                                                   std::span<const SharedNode<Dim>> nodes) const {
  using Both = Eigen::Matrix<double, 2 * Dim, 1>;
  using WithLength = Eigen::Matrix<double, 2 * Dim + 2, 1>;
  const auto count = static_cast<Index>(nodes.size());
  std::vector<WithLength> sums(nodes.size());
  std::vector<Both> gradients(nodes.size());
  parallel_for(count, [&](Index k) {
    const double *a = of_slot(nodes[k].first), *b = of_slot(nodes[k].second);
    const Eigen::Map<const Vec<Dim>> grad_a(a + 1 + Dim), grad_b(b + 1 + Dim);
    gradients[k] << b[0] * grad_a, -a[0] * grad_b;
    sums[k] << grad_a, grad_b, grad_a.norm(), grad_b.norm();
  });
  sums = near.smooth(near.smooth(sums));
  std::vector<Vec<2>> flat(nodes.size());
  const auto flatness = [](double sum, double lengths) {
    return lengths > 0.0 ? std::pow(sum / lengths, flatness_power) : 0.0;
  };
  parallel_for(count, [&](Index k) {
    flat[k] = {flatness(sums[k].template head<Dim>().norm(), sums[k][2 * Dim]),
               flatness(sums[k].template segment<Dim>(Dim).norm(), sums[k][2 * Dim + 1])};
    gradients[k].template head<Dim>() *= flat[k][0];
    gradients[k].template tail<Dim>() *= flat[k][1];
  });
  gradients = near.smooth(near.smooth(gradients));
  std::vector<Vec<Dim>> normals(nodes.size(), Vec<Dim>::Zero());
  parallel_for(count, [&](Index k) {
    const Vec<Dim> sum = flat[k][0] * gradients[k].template head<Dim>() +
                         flat[k][1] * gradients[k].template tail<Dim>();
    const double length = sum.norm();
    if (length > 0.0) {
      normals[k] = sum / length;
    }
  });
  return normals;
}

template <int Dim>
void SharedNodes<Dim>::measure(const DynamicsData<Dim>& data, std::pair<int, int> fields,
                               std::span<SharedNode<Dim>> nodes) {
  if (nodes.empty()) {
    return;
  }
  const auto count = static_cast<Index>(nodes.size());
  std::array<Index, Dim> stride;
  for (int axis = 0; axis < Dim; ++axis) {
    stride[axis] = data.grid.node_stride(axis);
  }
  std::vector<Index> number;
  for (const SharedNode<Dim>& node : nodes) {
    number.push_back(data.grid.node_index(node.at));
  }
  const NodeNeighbours<Dim> near(number, stride);
  const std::vector<Vec<Dim>> normals = normals_of(near, nodes);
  const SurfaceColumns<Dim> columns(number, stride, normals);
  const SurfaceDepth &depth_a = depth_[body_of_field_[fields.first]],
                     &depth_b = depth_[body_of_field_[fields.second]];
  const double h = data.grid.cell_size();
  std::vector<Vec<2>> weighed(nodes.size());
  parallel_for(count, [&](Index k) {
    SharedNode<Dim>& node = nodes[k];
    node.normal = normals[k];
    const double *a = of_slot(node.first), *b = of_slot(node.second);
    const Eigen::Map<const Vec<Dim>> moment_a(a + 1), moment_b(b + 1);
    const Eigen::Map<const Vec<Dim>> grad_a(a + 1 + Dim), grad_b(b + 1 + Dim);
    const double reach_a = depth_a(moment_a.dot(node.normal) / (a[0] * h));
    const double reach_b = depth_b(-moment_b.dot(node.normal) / (b[0] * h));
    node.weight = a[0] * b[0] / (a[0] + b[0]);
    // The one that has less of the node tells better where its surface is.
    node.beyond = h * (b[0] * reach_a - a[0] * reach_b) / (a[0] + b[0]);
    // Alike where faces lie on each other; beyond the end of one there is the other's alone.
    const double face_a = std::abs(grad_a.dot(node.normal)),
                 face_b = std::abs(grad_b.dot(node.normal));
    node.area = std::min(face_a, face_b);
    node.face = std::min(0.5 * (face_a + face_b), 2.0 * node.area);
    weighed[k] = node.weight * Vec<2>(-h * (reach_a + reach_b), 1.0);
  });
  find_faces(data.grid, columns, nodes);
  // Smooth, and add the smoothed rest: a mean alone lies off a curved surface. One gap for all
  // nodes behind each other: with gaps of their own, only one of two rows across a face would push.
  for (int pass = 0; pass < 2; ++pass) {
    const std::vector<Vec<2>> means = columns.add(near.smooth(weighed));
    parallel_for(count, [&](Index k) {
      const double mean = means[k][0] / means[k][1];
      nodes[k].gap += mean;
      nodes[k].touches = nodes[k].gap <= body_touching_gap * h;
      weighed[k][0] -= weighed[k][1] * mean;
    });
  }
  // Beyond a cell nothing meets in this step; the light node in the middle would still push.
  for (SharedNode<Dim>& node : nodes) {
    if (node.gap > h) {
      node.gap = std::numeric_limits<double>::infinity();
    }
  }
}

/// Where the common face lies is one thing too for all nodes behind each other.
template <int Dim>
void SharedNodes<Dim>::find_faces(const Grid<Dim>& grid, const SurfaceColumns<Dim>& columns,
                                  std::span<SharedNode<Dim>> nodes) {
  std::vector<Vec<Dim>> places;
  std::vector<Vec<1>> weights;
  for (const SharedNode<Dim>& node : nodes) {
    const Vec<Dim> here = grid.node_position(grid.node_index(node.at));
    places.push_back(node.weight * (here + node.beyond * node.normal));
    weights.push_back(Vec<1>(node.weight));
  }
  places = columns.add(places);
  weights = columns.add(weights);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Vec<Dim> here = grid.node_position(grid.node_index(nodes[k].at));
    nodes[k].beyond = nodes[k].normal.dot(places[k] / weights[k][0] - here);
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                                         \
  template std::vector<Vec<Dim>> SharedNodes<Dim>::normals_of(                           \
      const NodeNeighbours<Dim>&, std::span<const SharedNode<Dim>>) const;               \
  template void SharedNodes<Dim>::measure(const DynamicsData<Dim>&, std::pair<int, int>, \
                                          std::span<SharedNode<Dim>>);
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
