#pragma once

#include <memory>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/peridynamics/heat_settings.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// What a wall prescribes at one time.
struct WallState {
  double temperature = 0.0;  // K, of the surface or the surroundings
  double flux = 0.0;         // W/m^2 into the fluid
};

/// Heat that points exchange with one another and with walls; bond by bond what one loses the other
/// gains.
class HeatExchange {
 public:
  virtual ~HeatExchange() = default;

  /// Bring families and weights up to date with the points; costs nothing while they are at rest.
  virtual void update() = 0;
  /// Bring what the functions below report up to date without changing what the next `update`
  /// finds.
  virtual void refresh() = 0;
  /// Rate of heat into every fluid point, W (rows of other points: 0), and from every wall, W.
  virtual void rates(const double* temperature, const std::vector<WallState>& surface, double* rate,
                     std::vector<double>& from_walls) const = 0;
  /// Add to each fluid point V shift . grad T, m^dim K: what it lacks for standing where its shift
  /// (m, rows x dimension) has brought it without having flowed there. Nothing where points rest.
  virtual void add_missed(const double* /*temperature*/, const std::vector<WallState>& /*surface*/,
                          const double* /*shift*/, double* /*missed*/) const {}
  /// Sum of the conductances of each fluid point, W/K, which limits an explicit step; 0 where it is
  /// not known. Of what `update` or `refresh` last saw.
  virtual void diagonal(double* sum) const = 0;
  /// What walls do to each point: the area that its bonds to them stand for, m^(dimension - 1), and
  /// the mean heat flux into it through that area, W/m^2; 0 where no wall is near.
  virtual void wall_rows(const double* temperature, const std::vector<WallState>& surface,
                         double* flux, double* area) const = 0;
  /// Wetted area of `wall`, m^(dimension - 1).
  virtual double wall_area(int wall) const = 0;
  /// Largest |sum of G Y| / sum of G |Y| over points that no wall touches: the rate that a linear
  /// field is wrongly given.
  virtual double imbalance() const = 0;
  /// About what share of the heat of `wall` is lost where it ends within a side (see
  /// held_edges.hpp); 0 where it is not known.
  virtual double lost_at_ends(int /*wall*/) const { return 0.0; }

  virtual void save(Archive& archive) const = 0;
  virtual void load(const Archive& archive) = 0;
};

/// The exchange that `settings.laplacian` asks for; `conductivity` in W/(m K). Points that never
/// move are told to.
std::unique_ptr<HeatExchange> make_heat_exchange(Points& points, const WallSurface& walls,
                                                 const PeridynamicHeatSettings& settings,
                                                 double conductivity, bool points_move);

}  // namespace lapilli
