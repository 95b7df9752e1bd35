#pragma once

#include <array>
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
/// The temperature of a body at a node beyond the face follows from those on both sides of it, with
/// the flux through what lies between in series,
///   q = (T_across - T_inner) / (inner / k + beyond / k_other + 1 / conductance),
///   T = T_inner + q (inner + beyond) / k,
/// exact for steady heat wherever the face lies in its cell, whatever both conduct; what the node
/// holds goes to those by the same weights, so that nothing is lost and conduction stays symmetric.
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
  void conduct(const Points& points, const CellOrder<Dim>& order, const Step& step,
               PointGridTransfer<Dim>& whole);
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

  /// A node of a body beyond the face that it shares with another.
  struct BeyondNode {
    static constexpr int most_inner = Dim == 3 ? 4 : Dim;
    Index node = 0, across = 0;  // its number, and that of the node of the other body at its place
    double share = 1.0;          // of the other's temperature
    int inner_count = 0;
    std::array<Index, most_inner> inner{};  // nodes of the body itself, which have the rest
    std::array<double, most_inner> weight{};
    std::size_t pair = 0;
    bool of_first = true;  // of the pair's fields
    double apart = 0.0;    // K, what it carries above what follows
  };

  void find_pairs(const HeatProblem<Dim>& problem);
  void find_conductivities(const HeatProblem<Dim>& problem,
                           const HeatCoefficients<Dim>& coefficients);
  template <class Body>
  void for_each_node(int field, const Body& body) const;
  void share_out(const PointGridTransfer<Dim>& whole);
  void hold_outer_nodes(const std::vector<BodyTouch>& touches);
  void exchange(const Step& step);
  void exchange_level(const BodyTouch& touch, const Step& step);
  std::size_t pair_of(const BodyTouch& touch) const;
  // Nodes beyond faces.
  std::pair<double, double> conductivities(const BodyTouch& touch) const;
  bool slopes_differ(const BodyTouch& touch, const Step& step) const;
  void find_beyond(const Step& step);
  bool find_inner(const BodyTouch& touch, BeyondNode& beyond, double& reach) const;
  double following(const BeyondNode& beyond, const std::vector<double>& values) const;
  void keep_capacities_positive();
  void hand_to_leaders(const Step& step);

  Grid<Dim> grid_;
  const NodeFields<Dim>& fields_;
  bool with_surface_;
  PointGridTransfer<Dim> nodes_;
  FindTouches touches_;
  std::size_t body_count_;
  std::vector<Pair> pairs_;
  std::vector<std::optional<Mat<Dim>>> conductivity_;  // by field, where its bodies conduct alike
  std::vector<BeyondNode> beyond_;
  std::vector<const BodyTouch*> level_;   // the others: one temperature, but for a conductance
  std::vector<unsigned char> is_beyond_;  // by number of a node
  std::vector<double> led_capacity_,
      led_heat_;                      // by number of a node, with what follows it; J/K, J
  std::vector<unsigned char> count_;  // by node of the grid: fields that have material there
};

}  // namespace lapilli
