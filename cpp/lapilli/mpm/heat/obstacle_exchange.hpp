#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/physics.hpp"
#include "lapilli/mpm/heat/condition_account.hpp"
#include "lapilli/mpm/heat/point_grid_transfer.hpp"
#include "lapilli/mpm/heat/touching_surface.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"

namespace lapilli {

/// Heat between the material and obstacles, where material touches them: from those that have a
/// temperature, to it. Others insulate.
///
/// Nodes lie a fraction of a cell off the surface: what each exchanges is such that the steady flux
/// is right however good the contact (see TouchingPiece), and is taken at the end of the step, on
/// the diagonal: no conductance carries a node past the obstacle.
template <int Dim>
class ObstacleExchange {
 public:
  explicit ObstacleExchange(const std::vector<HeatObstacle>& obstacles);

  bool empty() const { return obstacles_.empty(); }
  /// Where material touches each of them; nothing is exchanged before.
  void follow(std::vector<FindFeet<Dim>> feet) { feet_ = std::move(feet); }

  /// Find the nodes that touch, where points and obstacles are; `nodal` was projected there.
  void find(const HeatProblem<Dim>& problem, const Points& points,
            const HeatCoefficients<Dim>& coefficients, const PointGridTransfer<Dim>& nodal);
  /// By obstacle.
  const std::vector<TouchingSurface<Dim>>& surfaces() const { return surfaces_; }
  /// Add to the increments of a step, which hold all else that it does to the nodes.
  void exchange(const Step& step, PointGridTransfer<Dim>& nodal);
  /// How fast nodes came to the temperature of an obstacle in the last step at the most, 1/s.
  double rate() const;

  std::vector<Balance::Entry> entries() const;
  std::vector<std::pair<std::string, double>> diagnostics() const;
  void save(Archive& archive) const;
  void load(const Archive& archive);
  /// Obstacles that were there keep the temperature that heat has brought them to.
  void go_on(const PointStart& start);

 private:
  double conductance_of(std::size_t k, const Step& step) const;
  std::vector<double> exchanged(std::size_t k, const Step& step,
                                const PointGridTransfer<Dim>& nodal) const;
  double rate_of(std::size_t k, const Step& step, const PointGridTransfer<Dim>& nodal) const;

  std::vector<HeatObstacle> obstacles_;
  std::vector<FindFeet<Dim>> feet_;
  std::vector<TouchingSurface<Dim>> surfaces_;
  double cell_ = 0.0;                // m
  std::vector<double> temperature_;  // K, of those that heat warms
  std::vector<double> rate_;         // 1/s
  ConditionAccount account_;
};

}  // namespace lapilli
