#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lapilli/core/balance.hpp"
#include "lapilli/mpm/heat/condition_account.hpp"
#include "lapilli/mpm/heat/heat_settings.hpp"
#include "lapilli/mpm/heat/touching_surface.hpp"
#include "lapilli/mpm/surface/area_ratios.hpp"
#include "lapilli/mpm/surface/nodal_surface.hpp"
#include "lapilli/mpm/surface/surface_regions.hpp"
#include "lapilli/mpm/surface/surface_view.hpp"

namespace lapilli {

/// Heat that `node` takes in for every kelvin of `source`, W/K.
struct NodeCoupling {
  Index node, source;
  double rate;
};

/// The laws on the surface, each on the nodes its region selects. A law gives every node a rate of
/// heat (W) and its slope -d rate/dT (W/K) for the implicit diagonal; what really came in is
/// booked.
template <int Dim>
class BoundaryConditions {
 public:
  /// The nodes of one law.
  struct Nodes {
    std::vector<Index> node;
    std::vector<double> area;  // m^(dim-1); signed for a prescribed flux, else non-negative
    std::vector<Vec<Dim>> normal;
    std::vector<Vec3> position;  // on the surface, m
    std::vector<double> state;   // K, at the node, or at the probe of a held temperature
    std::vector<double> rate;    // W
    std::vector<double> slope;   // W/K, not negative
    // Held temperatures only:
    std::vector<double> conductance;              // conductivity / probe depth, W/(m^2 K)
    std::vector<std::pair<Index, double>> probe;  // 2^dim nodes and weights an entry
  };

  /// `absolute_zero` in the unit of the temperatures: 0 in K, -273.15 in degrees Celsius.
  explicit BoundaryConditions(const std::vector<HeatBoundary>& laws, double absolute_zero = 0.0);

  bool empty() const { return laws_.empty(); }
  bool has_held_temperature() const;
  bool is_linear() const { return are_linear(laws_); }
  const std::vector<Nodes>& nodes() const { return nodes_; }

  /// Give each law the part of the surface that its region has; `places` is asked only where there
  /// are regions.
  void assign(const Grid<Dim>& grid, const NodalAreas<Dim>& areas,
              const std::function<std::vector<SurfacePlace<Dim>>()>& places);
  /// The area that each law would have of these, m^(dim-1), scaled by nothing.
  std::vector<double> areas_of(const Grid<Dim>& grid, const NodalAreas<Dim>& areas,
                               const std::function<std::vector<SurfacePlace<Dim>>()>& places) const;
  /// Scale the areas that are assigned from here on.
  void compare_areas(AreaRatios ratios) { ratios_ = std::move(ratios); }
  const AreaRatios& area_ratios() const { return ratios_; }
  /// Take from the laws what of their areas touches an obstacle, unless their regions end before
  /// it.
  void leave_to_obstacle(std::span<const TouchingNode<Dim>> touching, double cell);
  /// Place the probes of held temperatures, one cell below the surface, among the nodes that are
  /// active: a thin plate has fewer there. `conductivity` is the nodal n.k.n (W/(m K)).
  void place_probes(const Grid<Dim>& grid, const std::function<bool(Index)>& is_active,
                    const std::function<double(Index, const Vec<Dim>&)>& conductivity);

  /// Replace every node number by number(node), for temperatures stored in another order.
  template <class Number>
  void renumber(const Number& number) {
    for (Nodes& nodes : nodes_) {
      for (Index& node : nodes.node) {
        node = number(node);
      }
      for (auto& [node, weight] : nodes.probe) {
        node = number(node);
      }
    }
  }

  /// Throws std::invalid_argument when a law's region selects no surface.
  void require_all_used() const;

  /// Rates and their tangents at the nodal temperatures (indexed by node), for Newton's method;
  /// what varies in time as below.
  void evaluate(std::span<const double> temperature, double begin, double end);
  /// Rates and slopes for one explicit step, tables by their means over it and functions at its
  /// middle. The slopes are the coefficients of exchange, by which no step passes a target.
  void evaluate_over(std::span<const double> temperature, double begin, double end);
  /// Add to a law's account. `heat` was supplied (J).
  void book(std::size_t law, double heat) { account_.book(law, heat); }

  /// How held temperatures tie nodes to the corners of their probes; the node itself, which a step
  /// takes implicitly, is left out.
  std::vector<NodeCoupling> couplings() const;

  SurfaceView surface() const;
  std::vector<Balance::Entry> entries() const { return account_.entries(laws_); }
  void save(Archive& archive, const std::string& name) const;
  void load(const Archive& archive, const std::string& name);

 private:
  enum class Slope { secant, tangent };
  void evaluate_between(std::span<const double> temperature, double begin, double end,
                        Slope wanted);
  void read_states(Nodes& nodes, std::span<const double> temperature) const;
  void find_own_slopes(Nodes& nodes, std::span<const double> coefficient) const;
  const std::vector<double>& used_by(std::size_t law, const NodalAreas<Dim>& areas) const;
  void require_absolute(std::size_t law, std::span<const double> values) const;

  std::vector<HeatBoundary> laws_;
  std::vector<Nodes> nodes_;
  ConditionAccount account_;
  AreaRatios ratios_;
  double zero_ = 0.0;                         // absolute zero in the scene's unit
  std::vector<double> coefficient_, target_;  // scratch of evaluate
};

}  // namespace lapilli
