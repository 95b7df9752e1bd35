#pragma once

#include "lapilli/mpm/heat/boundary_conditions.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"

namespace lapilli {

/// Volumetric sources of the bodies, lumped to the nodes: heat rate Q(x_I, T_I, t) sum V S.
template <int Dim>
class HeatSource {
 public:
  /// Whether any body has a source other than the constant zero.
  static bool is_present(const std::vector<HeatBody>& bodies);

  explicit HeatSource(const std::vector<HeatBody>& bodies) : bodies_(bodies) {}

  /// Whether a source is a function of the temperature.
  bool depends_on_state() const;

  /// Node volumes sum V S of every body at the points' present places.
  void assign(const Points& points, const HeatProblem<Dim>& problem,
              const std::vector<double>& half_width);
  /// Call nodes by other numbers. Those without one, below zero, have no capacity that heat could
  /// go into, and are left out.
  template <class Number>
  void renumber(const Number& number) {
    for (Nodes& body : nodes_) {
      std::size_t kept = 0;
      for (std::size_t k = 0; k < body.node.size(); ++k) {
        if (const Index place = number(body.node[k]); place >= 0) {
          body.node[kept] = place;
          body.volume[kept] = body.volume[k];
          body.position[kept] = body.position[k];
          ++kept;
        }
      }
      body.node.resize(kept);
      body.volume.resize(kept);
      body.position.resize(kept);
    }
  }

  /// Call body(node, rate) for every node with a source; rate in W, tables by their means over a
  /// span of time, functions at its middle.
  template <class Body>
  void for_each(std::span<const double> temperature, double begin, double end, const Body& body) {
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      Nodes& n = nodes_[b];
      n.value.resize(n.node.size());
      n.state.resize(n.node.size());
      for (std::size_t k = 0; k < n.node.size(); ++k) {
        n.state[k] = temperature[n.node[k]];
      }
      bodies_[b].source.evaluate_mean(n.position, n.state, begin, end, n.value);
      for (std::size_t k = 0; k < n.node.size(); ++k) {
        body(n.node[k], n.value[k] * n.volume[k]);
      }
    }
  }

  /// What a body's source gives its nodes in one explicit step: means of tables over it, functions
  /// at its middle. A source that falls with the temperature restores: it may be taken at the end
  /// of the step by its slope.
  struct Rates {
    std::vector<Index> node;
    std::vector<double> rate;   // W
    std::vector<double> slope;  // W/K, -d rate/dT, negative where the source heats itself
  };
  const std::vector<Rates>& evaluate_over(std::span<const double> temperature, double begin,
                                          double end);

  void book(double heat) { booked_ += heat; }
  double booked() const { return booked_; }
  void set_booked(double heat) { booked_ = heat; }

 private:
  struct Nodes {
    std::vector<Index> node;
    std::vector<double> volume;
    std::vector<Vec3> position;
    std::vector<double> state, value;
  };
  std::vector<HeatBody> bodies_;
  std::vector<Nodes> nodes_;
  std::vector<Rates> rates_;
  double booked_ = 0.0;  // J
};

}  // namespace lapilli
