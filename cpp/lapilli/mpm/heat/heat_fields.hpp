#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/mpm/heat/point_grid_transfer.hpp"
#include "lapilli/mpm/transfer/body_touch.hpp"

namespace lapilli {

/// Bodies whose motion can part, each with temperatures of its own at the nodes, and heat between
/// them where they touch: none through a gap, through the contact conductance of heat.contacts
/// where there is one, else as if they were one.
///
/// Sources and boundary conditions act on what all fields together are at a node of the grid.
template <int Dim>
class HeatFields {
 public:
  /// `fields` are those of the motion, which moves their windows. Throws std::invalid_argument for
  /// contacts between bodies that are bonded.
  HeatFields(const HeatProblem<Dim>& problem, const HeatCoefficients<Dim>& coefficients,
             bool with_surface, const NodeFields<Dim>& fields, FindTouches touches);

  /// As PointGridTransfer::project; `whole` becomes that of all fields together.
  void project(const Points& points, const CellOrder<Dim>& order, const double* capacity,
               const double* carried, const double* gradient, PointGridTransfer<Dim>& whole);
  void conduct(const Points& points, const CellOrder<Dim>& order, PointGridTransfer<Dim>& whole);
  /// The increments by conduction and contact, and what others gave the whole in this step.
  void solve(const Step& step, const PointGridTransfer<Dim>& whole);

  /// What points take from and see.
  PointGridTransfer<Dim>& nodes() { return nodes_; }
  /// By field.
  std::vector<std::vector<std::size_t>> bodies() const;

  std::vector<std::pair<std::string, double>> diagnostics() const;
  void save(Archive& archive) const;
  void load(const Archive& archive);

 private:
  struct Pair {
    int first, second;  // fields
    std::optional<Value> conductance;
    std::string name;
    double heat = 0.0;  // J, from the first to the second since the start
  };

  void find_pairs(const HeatProblem<Dim>& problem);
  template <class Body>
  void for_each_node(int field, const Body& body) const;
  void share_out(const PointGridTransfer<Dim>& whole);
  void hold_outer_nodes(const std::vector<BodyTouch>& touches);
  void exchange(const Step& step);

  Grid<Dim> grid_;
  const NodeFields<Dim>& fields_;
  bool with_surface_;
  PointGridTransfer<Dim> nodes_;
  FindTouches touches_;
  std::size_t body_count_;
  std::vector<Pair> pairs_;
  std::vector<unsigned char> count_;  // by node of the grid: fields that have material there
};

}  // namespace lapilli
