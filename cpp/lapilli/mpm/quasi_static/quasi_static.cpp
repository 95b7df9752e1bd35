#include "lapilli/mpm/quasi_static/quasi_static.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/step_stop.hpp"
#include "lapilli/mpm/quasi_static/secants.hpp"

namespace lapilli {
namespace {

/// The next larger share of the elastic stiffness in a tangent.
double stiffer(double elastic_share) {
  return elastic_share < 0.1 ? 0.1 : elastic_share < 0.5 ? 0.5 : 1.0;
}

}  // namespace

template <int Dim>
typename QuasiStatic<Dim>::Report QuasiStatic<Dim>::try_step(
    double from, double to, std::unique_ptr<Interruption> stoppable) {
  Report report = report_;
  Loads<Dim> loads = collect_loads(to);
  if (!reference_.factorised) {
    factorise(loads, to, report);
  }
  if (reference_.imbalance_due) {
    settle_imbalance(from);
  }
  loads.carried = reference_.imbalance;
  Equilibrium<Dim> equilibrium = equilibrium_under(loads);
  require_loads_arrive(equilibrium);
  Eigen::VectorXd u = solve_flowing(equilibrium, loads, report);
  std::vector<Vec<Dim>> moves = moves_of(equilibrium, u);
  double carried = 0.0;
  if (loads.carried.size() > 0) {
    carried = std::max(0.0, 1.0 - reference_.farthest(points_, moves) / relaxation_);
    loads.carried *= carried;
    u = solve_flowing(equilibrium, loads, report);
    moves = moves_of(equilibrium, u);
  }
  report.penetration =
      boundary_.deepest_penetration(grid_, points_, moves, to, std::as_const(guarded_).values());
  stoppable.reset();  // from here on the step changes the state
  support_forces_ = equilibrium.support_forces(u, static_cast<int>(boundary_.walls()));
  for (std::size_t w = 0; w < support_forces_.size(); ++w) {
    support_forces_[w] += carried * reference_.support_forces[w];
  }
  largest_force_ = std::max(largest_force_, report.newton.reference);
  if (!report.newton.converged) {
    largest_left_ = std::max(largest_left_, report.newton.residual);
  }
  update_points(equilibrium, u, moves);
  boundary_.guard(grid_, points_, to, guarded_.values());
  reference_.moved = loads.since_reset.size() > 0 ? Eigen::VectorXd(loads.since_reset + u) : u;
  for (LoadedSurface<Dim>& surface : reference_.loaded) {
    surface.follow(grid_, system_, reference_.moved);
  }
  if (reference_.skin) {
    reference_.skin->follow(grid_, system_, reference_.moved);
  }
  return report;
}

template <int Dim>
Equilibrium<Dim> QuasiStatic<Dim>::equilibrium_under(const Loads<Dim>& loads) {
  return Equilibrium<Dim>(grid_, std::as_const(reference_.volume).values(), points_.body(),
                          reference_.weights, *reference_.state, solids_, loads, system_, solver_);
}

/// With ghosts as soft as the step leaves what it lets flow.
template <int Dim>
Eigen::VectorXd QuasiStatic<Dim>::solve_flowing(Equilibrium<Dim>& equilibrium, Loads<Dim>& loads,
                                                Report& report) {
  constexpr int most_repeats = 4;
  constexpr double noticed = 0.5;
  for (int k = 0;; ++k) {
    Eigen::VectorXd u = solve(equilibrium, report);
    if (loads.stiffness_left.empty() || k == most_repeats) {
      return u;
    }
    std::vector<double> left =
        stiffness_left_after([&](Index p) { return equilibrium.strain(p, u); });
    bool softer = false;
    for (std::size_t cell = 0; cell < left.size(); ++cell) {
      softer = softer || left[cell] < noticed * loads.stiffness_left[cell];
    }
    if (!softer) {
      return u;
    }
    loads.stiffness_left = std::move(left);
    reference_.factorised = false;
  }
}

/// Newton's method from no displacement at all.
template <int Dim>
Eigen::VectorXd QuasiStatic<Dim>::solve(Equilibrium<Dim>& equilibrium, Report& report) {
  constexpr int longer_where_it_yields = 8;  // flow without dilatancy converges linearly
  constexpr double stuck = 0.9, slow = 0.05;
  const bool may_yield = solids_.can_yield();
  Eigen::VectorXd u = Eigen::VectorXd::Zero(system_.unknowns());
  double elastic_share = 1e-6, before = 0.0;
  int corrections = 0;
  Secants secants;
  report.newton = solve_newton(
      u, [&](const Eigen::VectorXd& at) { return equilibrium.residual(at); },
      [&](const Eigen::VectorXd& force) {
        const auto by_tangent = [&](const Eigen::VectorXd& what) {
          return equilibrium.correction(what);
        };
        if (!may_yield) {
          follow_tangent(equilibrium, u, elastic_share, report);
          return by_tangent(force);
        }
        const double now = force.norm();
        const bool is_slow = corrections > 1 && now > slow * before;
        elastic_share =
            corrections++ > 1 && now > stuck * before ? stiffer(elastic_share) : elastic_share;
        before = now;
        follow_tangent(equilibrium, u, elastic_share, report);
        return secants.correction(u, force, is_slow, by_tangent);
      },
      settings_.tolerance, settings_.max_iterations * (may_yield ? longer_where_it_yields : 1),
      may_yield);
  const double accepted = may_yield ? 1e-6 : 0.0;  // with a warning: what is left falls slowly
  if (!report.newton.converged && report.newton.residual > accepted) {
    throw LoadStepFailed(message("Newton's method stalled at a relative residual of ",
                                 report.newton.residual, " after ", report.newton.iterations,
                                 " iterations, tolerance ", settings_.tolerance));
  }
  constexpr double least_digits = 1e-4;
  if (report.newton.floor > least_digits) {
    throw RunError(message("forces cancel to a relative ", report.newton.floor,
                           ": stiff and soft bodies are too far apart for double precision; bring "
                           "their youngs_modulus within a factor of 1e8"));
  }
  return u;
}

/// The tangent at `u` where points yield, as near to the consistent one as stays positive and
/// brings the solution nearer; the elastic stiffness, factorised once, where none does.
template <int Dim>
void QuasiStatic<Dim>::follow_tangent(Equilibrium<Dim>& equilibrium, const Eigen::VectorXd& u,
                                      double& elastic_share, Report& report) {
  if (!equilibrium.yields_at(u)) {
    if (!reference_.factorised) {
      equilibrium.factorise();
      reference_.factorised = true;
    }
    return;
  }
  reference_.factorised = false;
  for (;; elastic_share = stiffer(elastic_share)) {
    report.pivots = equilibrium.factorise_at(u, elastic_share);
    if (report.pivots.not_positive == 0) {
      return;
    }
    if (elastic_share == 1.0) {
      require_positive(report.pivots);
    }
  }
}

template <int Dim>
std::vector<Vec<Dim>> QuasiStatic<Dim>::moves_of(const Equilibrium<Dim>& equilibrium,
                                                 const Eigen::VectorXd& u) const {
  std::vector<Vec<Dim>> moves(points_.size());
  parallel_for(points_.size(), [&](Index p) { moves[p] = equilibrium.displacement(p, u); });
  return moves;
}

/// Factorise the tangent. Mean gaps on cells with next to no material may leave it indefinite; then
/// both constraints are made stiffer, which only adds to it, until the grid is reset.
template <int Dim>
void QuasiStatic<Dim>::factorise(Loads<Dim>& loads, double to, Report& report) {
  constexpr int most_tightenings = 4;
  constexpr double tighter = 4.0;
  report.pivots = equilibrium_under(loads).factorise();
  for (int k = 0; k < most_tightenings && report.pivots.not_positive > 0 &&
                  settings_.enforcement == Enforcement::mean_gap;
       ++k) {
    reference_.scheme.pointwise *= tighter;
    reference_.scheme.stiff *= 2.0 * tighter;
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
  constexpr double largest_contrast = 1e8;
  const auto [soft, stiff] = std::minmax_element(
      solids_.elastic().begin(), solids_.elastic().end(),
      [](const auto& a, const auto& b) { return a.youngs_modulus < b.youngs_modulus; });
  if (stiff->youngs_modulus > largest_contrast * soft->youngs_modulus) {
    throw RunError(
        message("the stiffness matrix is not positive definite: bodies of youngs_modulus ",
                soft->youngs_modulus, " and ", stiff->youngs_modulus,
                " Pa are too far apart for double precision; bring them within a factor "
                "of 1e8"));
  }
  const Vec<Dim> place = grid_.node_position(system_.nodes()[pivots.smallest_unknown / Dim]);
  throw RunError(message(
      "the stiffness matrix is not positive definite: ", pivots.not_positive, " of ",
      system_.unknowns(), " pivots, the smallest ", pivots.smallest, " at the node near ",
      place.transpose(), " m, next to ", boundary_.nearest_wall(place),
      ": cells cut to slivers need ghost stabilisation (ghost_penalty = 0.01), nitsche a smaller "
      "gap_bandwidth"));
}

template <int Dim>
void QuasiStatic<Dim>::update_points(const Equilibrium<Dim>& equilibrium, const Eigen::VectorXd& u,
                                     const std::vector<Vec<Dim>>& moves) {
  const double h = grid_.cell_size();
  parallel_for(points_.size(), [&](Index p) {
    const SymmetricTensor strain = equilibrium.strain(p, u);
    solids_.strain(p, points_.body()[p], strain);
    if (update_volumes_) {
      points_.volume()[p] *= std::exp(strain.trace());
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

template class QuasiStatic<2>;
template class QuasiStatic<3>;

}  // namespace lapilli
