#include "lapilli/mpm/quasi_static/quasi_static.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/step_refused.hpp"
#include "lapilli/mpm/quasi_static/supports.hpp"

namespace lapilli {
namespace {

// GIMP domains stay within these half-widths, in cells.
constexpr double least_half_width = 0.02, largest_half_width = 0.499;

}  // namespace

template <int Dim>
QuasiStatic<Dim>::QuasiStatic(Points& points, const Grid<Dim>& grid, ShapeFunction shape_function,
                              std::vector<LinearElastic> materials, QuasiStaticSettings settings)
    : points_(points),
      grid_(grid),
      materials_(std::move(materials)),
      settings_(std::move(settings)),
      boundary_(settings_),
      stress_(points, 6),
      displacement_(points, Dim),
      guarded_(points, static_cast<int>(std::max<std::size_t>(1, boundary_.walls()))),
      wall_forces_(boundary_.walls(), Vec<Dim>::Zero()),
      reference_(points, shape_function == ShapeFunction::gimp) {
  require(points.dimension() == Dim && points.size() > 0, "quasi_static needs points of dimension ",
          Dim);
  require(shape_function != ShapeFunction::bspline,
          "quasi_static takes grid.shape_function linear or gimp, not bspline");
  for (const LinearElastic& material : materials_) {
    check(material);
  }
  for (Index p = 0; p < points.size(); ++p) {
    require(points.body()[p] >= 0 && points.body()[p] < static_cast<Index>(materials_.size()),
            "body ", points.body()[p], " has no elastic material for quasi_static");
  }
  const bool literal = settings_.wall_form == WallForm::literal;
  const double bandwidth = settings_.bandwidth.value_or(literal ? 1e-6 : 1e-3);
  require(bandwidth > 0.0 && settings_.gap_bandwidth > 0.0,
          "quasi_static: bandwidth and gap_bandwidth must be positive, got ", bandwidth, " and ",
          settings_.gap_bandwidth, " cells");
  scheme_ = WallScheme::of(settings_.wall_form, bandwidth, settings_.gap_bandwidth);
  ghost_ = settings_.ghost.value_or(literal ? 0.0 : 0.01);
  relaxation_ = settings_.relaxation.value_or(literal ? 0.0 : 0.5) * grid_.cell_size();
  reset_ = settings_.reset.value_or(literal ? 0.0 : 0.1) * grid_.cell_size();
  require(reset_ >= 0.0, "quasi_static: reset must not be negative, got ", *settings_.reset);
  require(ghost_ >= 0.0, "quasi_static: ghost must not be negative, got ", ghost_);
  require(settings_.body_force.size() <= Dim, "quasi_static: body_force has ",
          settings_.body_force.size(), " values, the scene has ", Dim, " axes");

  if (shape_function == ShapeFunction::gimp) {
    half_width_ = std::make_unique<PointArray>(points, Dim);
    const double h = grid_.cell_size();
    for (Index p = 0; p < points.size(); ++p) {
      const double width = 0.5 * std::pow(points.volume()[p], 1.0 / Dim);
      std::fill_n(half_width_->data() + Dim * p, Dim,
                  std::clamp(width, least_half_width * h, largest_half_width * h));
    }
  }
  boundary_.guard(grid_, points_, 0.0, guarded_.values());
  try {
    reset_grid(0.0);
  } catch (const RunError& error) {
    throw std::invalid_argument(error.what());
  }
}

template <int Dim>
StepLimit QuasiStatic<Dim>::step_limit() const {
  StepLimit limit;
  limit.reason = "load steps have no stable size: give time.steps";
  return limit;
}

template <int Dim>
StepReport QuasiStatic<Dim>::advance(const Step& step) {
  double size = step.size;
  for (int halvings = 0;; ++halvings, size *= 0.5) {
    try {
      report_ = attempt(step.time, step.time + size);
      report_.halvings = halvings;
      return {size, report_.newton.iterations, report_.newton.residual};
    } catch (const LoadStepFailed& error) {
      if (halvings == settings_.largest_halvings) {
        throw StepRefused(message("load step failed after ", halvings, " halvings: ", error.what(),
                                  "; the last converged state is kept"));
      }
    } catch (const RunError& error) {
      throw StepRefused(message(error.what(), "; the last converged state is kept"));
    }
  }
}

/// One load step; changes nothing unless it converges.
template <int Dim>
typename QuasiStatic<Dim>::Report QuasiStatic<Dim>::attempt(double from, double to) {
  if (is_reset_due()) {
    reset_grid(from);
  }
  Report report = report_;
  Loads<Dim> loads = collect_loads(to);
  if (!reference_.factorised) {
    factorise(loads, to, report);
  }
  if (reference_.imbalance_due) {
    reference_.imbalance = imbalance_at(from);
    reference_.imbalance_due = false;
  }
  loads.carried = reference_.imbalance;
  const Equilibrium<Dim> equilibrium = equilibrium_under(loads);
  Eigen::VectorXd u = solve(equilibrium, report);
  std::vector<Vec<Dim>> moves = moves_of(equilibrium, u);
  double carried = 0.0;
  if (loads.carried.size() > 0) {
    carried = std::max(0.0, 1.0 - reference_.farthest(points_, moves) / relaxation_);
    loads.carried *= carried;
    u = solve(equilibrium, report);
    moves = moves_of(equilibrium, u);
  }
  report.penetration =
      boundary_.deepest_penetration(grid_, points_, moves, to, std::as_const(guarded_).values());
  wall_forces_ = equilibrium.wall_forces(u, static_cast<int>(boundary_.walls()));
  for (std::size_t w = 0; w < wall_forces_.size(); ++w) {
    wall_forces_[w] += carried * reference_.wall_forces[w];
  }
  update_points(equilibrium, u, moves);
  boundary_.guard(grid_, points_, to, guarded_.values());
  reference_.moved = loads.since_reset.size() > 0 ? Eigen::VectorXd(loads.since_reset + u) : u;
  return report;
}

template <int Dim>
Equilibrium<Dim> QuasiStatic<Dim>::equilibrium_under(const Loads<Dim>& loads) {
  return Equilibrium<Dim>(grid_, points_, reference_.weights, *reference_.state, materials_,
                          stress_.values(), loads, system_, solver_);
}

/// Newton's method from no displacement at all.
template <int Dim>
Eigen::VectorXd QuasiStatic<Dim>::solve(const Equilibrium<Dim>& equilibrium, Report& report) const {
  Eigen::VectorXd u = Eigen::VectorXd::Zero(system_.unknowns());
  report.newton = solve_newton(
      u, [&](const Eigen::VectorXd& at) { return equilibrium.residual(at); },
      [&](const Eigen::VectorXd& force) { return equilibrium.correction(force); },
      settings_.tolerance, settings_.largest_iterations);
  if (!report.newton.converged) {
    throw LoadStepFailed(message("Newton's method stalled at a relative residual of ",
                                 report.newton.residual, " after ", report.newton.iterations,
                                 " iterations, tolerance ", settings_.tolerance));
  }
  return u;
}

template <int Dim>
std::vector<Vec<Dim>> QuasiStatic<Dim>::moves_of(const Equilibrium<Dim>& equilibrium,
                                                 const Eigen::VectorXd& u) const {
  std::vector<Vec<Dim>> moves(points_.size());
  parallel_for(points_.size(), [&](Index p) { moves[p] = equilibrium.displacement(p, u); });
  return moves;
}

/// What a reset leaves out of balance: moved points integrate differently, and the walls of the new
/// grid hold nothing yet. It is taken up as the points move on; where nothing moves, nothing
/// changes.
template <int Dim>
Eigen::VectorXd QuasiStatic<Dim>::imbalance_at(double time) {
  const Loads<Dim> loads = collect_loads(time);
  return equilibrium_under(loads).residual(Eigen::VectorXd::Zero(system_.unknowns())).force;
}

/// Factorise the tangent. Mean gaps on cells with next to no material may leave it indefinite; then
/// the moderate constraint is made stiffer, which only adds to it, until the grid is reset.
template <int Dim>
void QuasiStatic<Dim>::factorise(Loads<Dim>& loads, double to, Report& report) {
  constexpr int most_tightenings = 4;
  constexpr double tighter = 4.0;
  report.pivots = equilibrium_under(loads).factorise();
  for (int k = 0; k < most_tightenings && report.pivots.not_positive > 0 &&
                  settings_.wall_form == WallForm::mean_gap;
       ++k) {
    reference_.scheme.pointwise *= tighter;
    loads = collect_loads(to);
    report.pivots = equilibrium_under(loads).factorise();
  }
  require_positive(report.pivots);
  report.condition = solver_.condition(system_.lower());
  report.gap_bandwidth = 4.0 / (3.0 * reference_.scheme.pointwise);
  reference_.factorised = true;
}

/// An indefinite matrix has no equilibrium worth the name: say where.
template <int Dim>
void QuasiStatic<Dim>::require_positive(const PivotReport& pivots) const {
  if (pivots.not_positive == 0) {
    return;
  }
  const Vec<Dim> place = grid_.node_position(system_.nodes()[pivots.smallest_unknown / Dim]);
  throw RunError(
      message("the stiffness matrix is not positive definite: ", pivots.not_positive, " of ",
              system_.unknowns(), " pivots, the smallest ", pivots.smallest, " at the node near ",
              place.transpose(), " m, next to ", boundary_.nearest_wall(place),
              ": cells cut to slivers need ghost stabilisation (ghost = 0.01), nitsche a smaller "
              "gap_bandwidth"));
}

template <int Dim>
bool QuasiStatic<Dim>::is_reset_due() const {
  const double farthest = reference_.farthest(points_);
  return !reference_.located || (farthest > 0.0 && farthest >= reset_);
}

template <int Dim>
void QuasiStatic<Dim>::reset_grid(double time) {
  reference_.imbalance_due = relaxation_ > 0.0 && reference_.moved.size() > 0;
  reference_.start(points_, half_width_.get(), time);
  reference_.scheme = scheme_;
  reference_.wall_forces = wall_forces_;
  reference_.locate(grid_, points_, materials_, boundary_);
}

template <int Dim>
Loads<Dim> QuasiStatic<Dim>::collect_loads(double to) const {
  Loads<Dim> loads;
  loads.since_reset = reference_.moved;
  std::vector<std::vector<Vec<Dim>>> motions;
  for (const Facet<Dim>& facet : reference_.facets) {
    motions.push_back(boundary_.wall(facet.surface).increments(facet, reference_.time, to));
    loads.walls.push_back(wall_term<Dim>(grid_, *reference_.state, facet,
                                         boundary_.kinds()[facet.surface], motions.back(),
                                         reference_.scheme));
  }
  require_agreeing<Dim>(grid_, reference_.facets, motions, boundary_.kinds(), boundary_.names());
  require_held<Dim>(grid_, points_, reference_.weights, reference_.facets, boundary_.kinds());
  loads.ghost = ghost_;
  if (ghost_ > 0.0) {
    loads.ghost_pairs = ghost_pairs<Dim>(grid_, *reference_.state, reference_.facets);
  }
  if (!settings_.body_force.empty()) {
    std::vector<Vec3> places(points_.size(), Vec3::Zero());
    for (Index p = 0; p < points_.size(); ++p) {
      places[p].template head<Dim>() = points_.position<Dim>(p);
    }
    loads.body_force = values_at<Dim>(settings_.body_force, places, to);
  }
  boundary_.add_tractions(grid_, *reference_.state, to, loads);
  return loads;
}

template <int Dim>
void QuasiStatic<Dim>::update_points(const Equilibrium<Dim>& equilibrium, const Eigen::VectorXd& u,
                                     const std::vector<Vec<Dim>>& moves) {
  const double h = grid_.cell_size();
  parallel_for(points_.size(), [&](Index p) {
    const SymmetricTensor strain = equilibrium.strain(p, u);
    const SymmetricTensor stress = stress_of(materials_[points_.body()[p]], strain);
    for (int k = 0; k < 6; ++k) {
      stress_[6 * p + k] += stress[k];
    }
    for (int axis = 0; axis < Dim; ++axis) {
      points_.position()[Dim * p + axis] += moves[p][axis];
      displacement_[Dim * p + axis] += moves[p][axis];
      if (half_width_) {
        double& width = (*half_width_)[Dim * p + axis];
        width =
            std::clamp(width * (1.0 + strain[axis]), least_half_width * h, largest_half_width * h);
      }
    }
  });
  points_.moved();
}

std::unique_ptr<Physics> make_quasi_static(Points& points, const Vec3& lower, const Vec3& upper,
                                           double cell, ShapeFunction shape_function,
                                           std::vector<LinearElastic> materials,
                                           QuasiStaticSettings settings) {
  if (points.dimension() == 3) {
    return std::make_unique<QuasiStatic<3>>(points, Grid<3>(lower, upper, cell), shape_function,
                                            std::move(materials), std::move(settings));
  }
  require(points.dimension() == 2, "quasi_static needs two or three dimensions, got ",
          points.dimension());
  return std::make_unique<QuasiStatic<2>>(points, Grid<2>(lower.head<2>(), upper.head<2>(), cell),
                                          shape_function, std::move(materials),
                                          std::move(settings));
}

template class QuasiStatic<2>;
template class QuasiStatic<3>;

}  // namespace lapilli
