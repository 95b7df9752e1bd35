#pragma once

#include <array>
#include <vector>

#include "lapilli/mpm/dynamics/contacts/node_neighbours.hpp"
#include "lapilli/mpm/dynamics/contacts/surface_columns.hpp"
#include "lapilli/mpm/dynamics/contacts/surface_depth.hpp"
#include "lapilli/mpm/dynamics/dynamics_data.hpp"

namespace lapilli {

/// A node that carries mass of two fields.
template <int Dim>
struct SharedNode {
  Index first = 0, second = 0;         // its numbers in the nodal arrays
  std::array<int, Dim> at{};           // in the whole grid
  Vec<Dim> normal = Vec<Dim>::Zero();  // from the first to the second
  double gap = 0.0;                    // m, between their surfaces; below 0: overlap
  double beyond = 0.0;                 // m, along the normal, of the face they have in common
  double area = 0.0;                   // m^(Dim-1) of the surface, its share
  double face = 0.0;                   // m^(Dim-1), the mean of both, but for ends of one
  bool touches = false;                // whether the gap is nothing: nodes beside one that presses
  double weight = 0.0;                 // reduced volume, m^Dim
};

/// Finds the nodes that two fields share, and where and how their surfaces lie around each.
///
/// Normals: V_b grad V_a - V_a grad V_b of the nodal volumes, smoothed over the shared nodes, so
/// that of each surface only what faces the other counts, and a face more than a corner. (Error in
/// degrees on planes at any angle, disks of radius 5 and 10 cells, corners of a block on a face:
/// .1, 1.2, .8, .4; gradients alone .2, 1.8, 1.0, 10; logistic regression as in Nairn et al. 2020,
/// CMAME 362:112859, 1.1, 2.2, 1.4, 6.) Gap: SurfaceDepth of both along the normal, smoothed.
template <int Dim>
class SharedNodes {
 public:
  SharedNodes(const DynamicsData<Dim>& data, const std::vector<DynamicsBody>& bodies);

  /// The nodes that the fields of each pair share; nodal masses must be there.
  void find(const DynamicsData<Dim>& data, const std::vector<std::pair<int, int>>& pairs);

  /// Shared nodes of one pair.
  std::span<SharedNode<Dim>> of(std::size_t pair) {
    return {nodes_.data() + begin_[pair], nodes_.data() + begin_[pair + 1]};
  }
  std::span<SharedNode<Dim>> all() { return nodes_; }
  /// Numbers in the nodal arrays, each once.
  const std::vector<Index>& touched() const { return touched_; }
  /// Place of a shared node in `touched`.
  int slot(Index node) const { return slot_[node]; }

 private:
  static constexpr int moments = 1 + 2 * Dim;  // V, sum V (x - x_I), sum V grad S

  void scan(const DynamicsData<Dim>& data, int a, int b);
  void number(const DynamicsData<Dim>& data, const std::vector<std::pair<int, int>>& pairs);
  void mark(const DynamicsData<Dim>& data, Index node, const NodeField<Dim>& field);
  void project(const DynamicsData<Dim>& data);
  template <class Shape>
  void project_rows(const DynamicsData<Dim>& data, const NodeField<Dim>& field, Index begin,
                    Index end);
  std::vector<Vec<Dim>> normals_of(const NodeNeighbours<Dim>& near,
                                   std::span<const SharedNode<Dim>> nodes) const;
  void measure(const DynamicsData<Dim>& data, std::pair<int, int> fields,
               std::span<SharedNode<Dim>> nodes);
  void find_faces(const Grid<Dim>& grid, const SurfaceColumns<Dim>& columns,
                  std::span<SharedNode<Dim>> nodes);

  const double* of_slot(Index node) const { return sums_.data() + moments * slot_[node]; }

  std::vector<SurfaceDepth> depth_;  // by body
  std::vector<int> body_of_field_;   // one of each
  std::vector<SharedNode<Dim>> nodes_;
  std::vector<std::size_t> begin_;  // of each pair, and one past the last
  std::vector<Index> touched_;
  std::vector<int> slot_;            // by node: its place in touched_, or -1
  std::vector<unsigned char> near_;  // by lowest node of a stencil: whether it meets a shared one
  std::vector<double> sums_;         // moments by slot
};

}  // namespace lapilli
