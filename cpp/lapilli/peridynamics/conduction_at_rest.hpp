#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "lapilli/peridynamics/bond_balance.hpp"
#include "lapilli/peridynamics/boundary_pieces.hpp"
#include "lapilli/peridynamics/heat_exchange.hpp"

namespace lapilli {

/// Heat exchange between points at rest: rate into i = sum of k g_ij (T_j - T_i), W, where the
/// bonds of each point and its share of the body's surface close (see BondBalance), however the
/// surface lies between the points.
///
/// The surface is that of the region, in flat pieces; each belongs to the point whose box it cuts
/// and to the wall it meets there. A wall acts on the area it shares with the body: with the
/// temperature T_s on it k A (T_s - T_i)/d, d the distance of the point from the piece; a
/// prescribed flux q brings q A. What meets no wall, or an adiabatic one, is insulated.
template <int Dim>
class ConductionAtRest final : public HeatExchange {
 public:
  /// `conductivity` in W/(m K). Points must not move.
  ConductionAtRest(const Points& points, const WallSurface& walls,
                   const PeridynamicHeatSettings& settings, double conductivity);

  void update() override {}
  void refresh() override {}
  void rates(const double* temperature, const std::vector<WallState>& surface, double* rate,
             std::vector<double>& from_walls) const override;
  void diagonal(double* sum) const override;
  void wall_rows(const double* temperature, const std::vector<WallState>& surface, double* flux,
                 double* area) const override;
  double wall_area(int wall) const override { return wall_area_[static_cast<std::size_t>(wall)]; }
  double imbalance() const override { return imbalance_; }
  double lost_at_ends(int wall) const override {
    return lost_at_ends_[static_cast<std::size_t>(wall)];
  }
  /// All of it follows from where the points are.
  void save(Archive&) const override {}
  void load(const Archive&) override {}

 private:
  /// Where a point meets a wall.
  struct Contact {
    std::int32_t point;
    int wall;
    double area;      // m^(Dim-1)
    double distance;  // m
  };

  void find_bonds(const PeridynamicHeatSettings& settings, double horizon);
  bool follows_lattice() const;
  void take_surface();
  void add_contact(Index point, const BoundaryPiece& piece, double ahead);
  void close_bonds();
  double flux_through(const Contact& contact, const WallState& state, double temperature) const;
  bool fluid(Index point) const { return walls_.wall(point) < 0; }

  const Points& points_;
  const WallSurface& walls_;
  double conductivity_;
  BondGraph<Dim> graph_;
  PointSurface<Dim> surface_;
  std::vector<Contact> contacts_;     // by points
  std::vector<Index> contact_begin_;  // points + 1
  std::vector<double> conductance_;   // of a bond, W/K
  std::vector<double> wall_area_, lost_at_ends_;
  bool tilted_ = false;  // some surface does not follow the axes
  double imbalance_ = 0.0;
};

}  // namespace lapilli
