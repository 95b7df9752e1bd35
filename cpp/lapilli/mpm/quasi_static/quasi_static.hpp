#pragma once

#include <memory>
#include <span>
#include <vector>

#include "lapilli/core/interruption.hpp"
#include "lapilli/core/physics.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/core/warnings.hpp"
#include "lapilli/core/whole_steps.hpp"
#include "lapilli/mpm/quasi_static/equilibrium.hpp"
#include "lapilli/mpm/quasi_static/load_steps.hpp"
#include "lapilli/mpm/quasi_static/reference.hpp"
#include "lapilli/mpm/quasi_static/settings.hpp"
#include "lapilli/mpm/quasi_static/stiffness_left.hpp"
#include "lapilli/mpm/transfer/shape_function.hpp"

namespace lapilli {

// GIMP domains stay within these half-widths, in cells.
inline constexpr double least_half_width = 1e-6, largest_half_width = 0.499;

/// Quasi-static equilibrium of solid bodies by the implicit material point method, with walls
/// that do not fit the grid (Cortis et al. 2018, corrected). One step of the clock is one load
/// step, which ends earlier at entries of tables; a step that fails is halved, and the points keep
/// the last state that converged. Not modelled: inertia, large strains (volumes stay), friction,
/// walls that let go.
template <int Dim>
class QuasiStatic final : public Physics, public WholeSteps, public Warnings {
 public:
  /// `materials` by body; `shapes` of all bodies at time 0, empty when they are not known:
  /// walls and tractions on the surface of a shape end where it leaves them. `in_cells` by body:
  /// whether its points stand for parts of single cells (`fill_cells`); empty: of none. `points`
  /// must outlive the physics, which moves them. Throws std::invalid_argument for settings that
  /// cannot be used and for walls and tractions that meet no material.
  QuasiStatic(Points& points, const Grid<Dim>& grid, ShapeFunction shape_function,
              const std::vector<Solid>& materials, QuasiStaticSettings settings,
              std::vector<Shape> shapes = {}, const std::vector<char>& in_cells = {});

  std::string name() const override { return "quasi_static"; }
  StepLimit step_limit() const override;
  StepReport advance(const Step& step) override;
  std::vector<Field> fields() override;
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;
  /// Of the last load step: residual, iterations, pivots, condition estimate, halvings,
  /// penetration, force of each wall on the material.
  std::vector<std::pair<std::string, double>> diagnostics() const override;

  /// Strains beyond what the law for small strains carries, cells too coarse for the stresses,
  /// points that have crossed cells with linear shape functions, forces left out of balance, walls
  /// off the bodies, gaps that are bridged.
  std::vector<Note> warnings() const override;

  /// Force of each wall on the material in the last load step, N (per metre thickness in 2D).
  std::span<const Vec<Dim>> support_forces() const { return support_forces_; }
  std::span<const double> stress() const { return solids_.stress(); }              // rows x 6, Pa
  std::span<const double> displacement() const { return displacement_.values(); }  // rows x Dim, m

 private:
  struct Report {
    NewtonReport newton;
    PivotReport pivots;
    double condition = 0.0;
    double penetration = 0.0;    // m, deepest point behind a wall it was in front of
    double gap_bandwidth = 0.0;  // cells, after tightening
    int halvings = 0;
  };

  void choose_schemes();
  void start_half_widths(const std::vector<char>& in_cells);
  bool is_reset_due() const;
  void reset_grid(double time);
  Loads<Dim> collect_loads(double to) const;
  /// Of walls, softly; `motions` of each facet.
  void hold_ends(const std::vector<std::vector<Vec<Dim>>>& motions, Loads<Dim>& loads) const;
  /// By cell; empty where nothing yields.
  std::vector<double> stiffness_left_after(
      const std::function<SymmetricTensor(Index)>& increment) const;
  /// Of places whose material has these densities (kg/m^3), N/m^3.
  std::vector<Vec<Dim>> weight_at(const std::vector<Vec3>& places,
                                  const std::vector<double>& densities, double time) const;
  void split_body_force(Loads<Dim>& loads) const;
  double cell_mean_share(const Facet<Dim>& facet, Index& cell) const;
  std::vector<double> cell_densities() const;
  void add_hydrostatic(double to, Loads<Dim>& loads) const;
  void find_skin();
  void note_geometry();
  Equilibrium<Dim> equilibrium_under(const Loads<Dim>& loads);
  Report attempt(double from, double to);
  Report try_step(double from, double to, std::unique_ptr<Interruption> stoppable);
  void undo_reset(const Archive& before);
  /// Energy of what smoothing over the nodes changes in the stress, over its own.
  double roughness() const;
  double farthest_moved() const;
  double size_of_moves() const;  // m, root mean square of the displacements
  void choose_stiffness(bool moved_far);
  Eigen::VectorXd solve(Equilibrium<Dim>& equilibrium, Report& report);
  Eigen::VectorXd solve_flowing(Equilibrium<Dim>& equilibrium, Loads<Dim>& loads, Report& report);
  void follow_tangent(Equilibrium<Dim>& equilibrium, const Eigen::VectorXd& u,
                      double& elastic_share, Report& report);
  std::vector<Vec<Dim>> moves_of(const Equilibrium<Dim>& equilibrium,
                                 const Eigen::VectorXd& u) const;
  void settle_imbalance(double time);
  void factorise(Loads<Dim>& loads, double to, Report& report);
  void require_positive(const PivotReport& pivots) const;
  void require_loads_arrive(const Equilibrium<Dim>& equilibrium) const;
  void update_points(const Equilibrium<Dim>& equilibrium, const Eigen::VectorXd& u,
                     const std::vector<Vec<Dim>>& moves);

  Points& points_;
  Grid<Dim> grid_;
  QuasiStaticSettings settings_;
  LoadSteps steps_;
  Boundary<Dim> boundary_;
  SupportScheme scheme_;
  double ghost_ = 0.0;
  bool moved_far_ = false;  // whether a point had moved by half a cell at the last reset
  bool update_volumes_ = true;
  std::vector<char> averaged_;  // by body: whether its dilatation is that of the cell

  SolidState solids_;
  PointArray start_volume_;                 // m^Dim, at the start: carries the body force
  PointArray displacement_;                 // m, rows x Dim
  PointArray guarded_;                      // rows x walls: 1 where a wall must keep the point
  std::unique_ptr<PointArray> half_width_;  // m, rows x Dim, of GIMP
  std::vector<Vec<Dim>> support_forces_;
  double largest_force_ = 0.0;  // N, size of the forces in play in any load step so far
  Report report_;
  double largest_left_ = 0.0;  // relative residual above the tolerance that was accepted
  std::vector<Note> notes_;    // of where walls and bodies are at the start

  Reference<Dim> reference_;
  double reset_ = 0.0;       // m
  double relaxation_ = 0.0;  // m
  NodeSystem<Dim> system_;
  DirectSolver solver_;
};

/// Quasi-static physics for points of two or three dimensions on a grid with the given corners.
/// Throws std::invalid_argument as `QuasiStatic` and `Grid` do.
std::unique_ptr<Physics> make_quasi_static(Points& points, const Vec3& lower, const Vec3& upper,
                                           double cell, ShapeFunction shape_function,
                                           const std::vector<Solid>& materials,
                                           QuasiStaticSettings settings,
                                           std::vector<Shape> shapes = {},
                                           const std::vector<char>& in_cells = {});

}  // namespace lapilli
