#pragma once

#include <optional>
#include <vector>

#include "lapilli/mpm/heat/heat_problem.hpp"
#include "lapilli/mpm/heat/plane_stiffness.hpp"
#include "lapilli/mpm/heat/point_fields.hpp"
#include "lapilli/mpm/transfer/cell_order.hpp"
#include "lapilli/mpm/transfer/node_fields.hpp"

namespace lapilli {

/// The sums over points that a step of heat needs, and the nodal arrays they fill. The loops hold
/// the nodes of consecutive points in registers for as long as they stay the same. Nodes are those
/// of the grid, or, where there are several `fields`, those by their numbers there.
template <int Dim>
class PointGridTransfer {
 public:
  PointGridTransfer(const Grid<Dim>& grid, ShapeFunction shape,
                    const HeatCoefficients<Dim>& coefficients, bool with_surface,
                    const NodeFields<Dim>* fields = nullptr);
  PointGridTransfer(const PointGridTransfer&) = delete;

  /// Capacity C_I = sum m S and, as `temperature`, sum m S (T_p + G_p . (x_I - x_p)) / C_I; with a
  /// surface also sum V S / h^dim and sum V grad S. `gradient` may be null. Clears the rate.
  void project(const Points& points, const CellOrder<Dim>& order, const double* capacity,
               const double* carried, const double* gradient);
  /// rate_I -= sum V grad S . k grad T.
  void conduct(const Points& points, const CellOrder<Dim>& order);
  /// carried <- (1 - beta) carried + S . nodal, the gradient likewise (null: none).
  void update(const Points& points, const std::vector<double>& nodal, double beta, double* carried,
              double* gradient);
  /// value = S . nodal and flux = -k grad S . nodal at every point.
  void interpolate(const Points& points, const std::vector<double>& nodal, double* value,
                   double* flux);

  /// Zero all but the increments that were blended, on the nodes that points may touch now.
  void clear(const CellOrder<Dim>& order);

  /// Give the heat of the increment at one node to another.
  void hand_on(Index from, Index to) {
    increment[to] += capacity[from] * increment[from] / capacity[to];
    increment[from] = 0.0;
  }
  /// Whether the sums for the surface are taken.
  bool has_surface() const { return with_surface_; }

  /// Run body(begin, end) over ranges of nodes that points can touch.
  template <class Body>
  void for_active_nodes(const Body& body) const {
    parallel_ranges(
        last_ - first_, [&](Index begin, Index end) { body(first_ + begin, first_ + end); },
        Work::light);
  }

  // By node of the grid, four more at the end for loads of whole rows; zero where inactive.
  std::vector<double> capacity, temperature, rate, increment;
  std::vector<double> blended;  // dT + beta T
  NodalSums<Dim> sums;          // with a surface

 private:
  template <class Body>
  void with_shapes(const Body& body) const;
  void resize();
  void conduct_by_points(const Points& points, const CellOrder<Dim>& order);

  Grid<Dim> grid_;
  NodeFields<Dim> whole_;  // all nodes of the grid
  const NodeFields<Dim>& fields_;
  ShapeFunction shape_;
  const HeatCoefficients<Dim>& coefficients_;
  bool with_surface_;
  std::vector<GimpShape> gimp_;              // by body
  std::vector<double> area_[Dim];            // sum V grad S by axis, while it is summed
  std::optional<PlaneStiffness> stiffness_;  // where it serves: linear, isotropic, in the plane
  Index first_ = 0, last_ = 0;               // nodes that points can touch
};

}  // namespace lapilli
