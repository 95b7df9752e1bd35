#include "lapilli/mpm/quasi_static/quasi_static.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/quasi_static/supports.hpp"

namespace lapilli {
namespace {

/// A load step that may succeed when it is made smaller.
class LoadStepFailed : public RunError {
 public:
  using RunError::RunError;
};

template <int Dim>
Vec3 in_space(const Vec<Dim>& place) {
  Vec3 at = Vec3::Zero();
  at.head<Dim>() = place;
  return at;
}

/// A vector law at some places and a time.
template <int Dim>
std::vector<Vec<Dim>> values_at(const std::vector<Value>& law, const std::vector<Vec3>& places,
                                double time) {
  std::vector<Vec<Dim>> vectors(places.size(), Vec<Dim>::Zero());
  std::vector<double> values(places.size());
  for (std::size_t axis = 0; axis < law.size(); ++axis) {
    law[axis].evaluate(places, {}, time, values);
    for (std::size_t k = 0; k < places.size(); ++k) {
      vectors[k][static_cast<int>(axis)] = values[k];
    }
  }
  return vectors;
}

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
      stress_(points, 6),
      displacement_(points, Dim),
      reference_(points) {
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
  settings_.rebalance = settings_.rebalance && !literal;
  reset_ = settings_.reset.value_or(literal ? 0.0 : 0.1) * grid_.cell_size();
  require(reset_ >= 0.0, "quasi_static: reset must not be negative, got ", *settings_.reset);
  require(ghost_ >= 0.0, "quasi_static: ghost must not be negative, got ", ghost_);
  require(settings_.body_force.size() <= Dim, "quasi_static: body_force has ",
          settings_.body_force.size(), " values, the scene has ", Dim, " axes");

  for (const WallSettings& wall : settings_.walls) {
    names_.push_back(wall.name.empty() ? message(names_.size() + 1) : wall.name);
    kinds_.push_back(wall.kind);
    walls_.emplace_back(wall.surface, wall.displacement, "wall '" + names_.back() + "'");
  }
  for (const TractionSettings& traction : settings_.tractions) {
    require(traction.traction.size() <= Dim, "traction '", traction.name, "' has ",
            traction.traction.size(), " values, the scene has ", Dim, " axes");
    tractions_.emplace_back(traction.surface, std::vector<Value>{},
                            "traction '" + traction.name + "'");
  }
  wall_forces_.assign(walls_.size(), Vec<Dim>::Zero());

  if (shape_function == ShapeFunction::gimp) {
    half_width_ = std::make_unique<PointArray>(points, Dim);
    reference_.half_width = std::make_unique<PointArray>(points, Dim);
    const double h = grid_.cell_size();
    for (Index p = 0; p < points.size(); ++p) {
      const double width = 0.5 * std::pow(points.volume()[p], 1.0 / Dim);
      std::fill_n(half_width_->data() + Dim * p, Dim,
                  std::clamp(width, least_half_width * h, largest_half_width * h));
    }
  }
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
      break;
    } catch (const LoadStepFailed& error) {
      if (halvings == settings_.largest_halvings) {
        throw RunError(message("load step failed after ", halvings, " halvings: ", error.what(),
                               "; the last converged state is kept"));
      }
    }
  }
  if (settings_.rebalance && is_reset_due()) {
    rebalance(step.time + size);
  }
  return {size, report_.newton.iterations, report_.newton.residual};
}

/// Balance on the new grid. The step itself has converged; what goes wrong here the next step says.
template <int Dim>
void QuasiStatic<Dim>::rebalance(double time) {
  try {
    Report report = attempt(time, time);
    report.halvings = report_.halvings;
    report.newton.iterations += report_.newton.iterations;
    report.penetration = std::max(report.penetration, report_.penetration);
    report_ = report;
  } catch (const RunError&) {
    return;
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
  std::unique_ptr<Equilibrium<Dim>> equilibrium =
      std::make_unique<Equilibrium<Dim>>(grid_, points_, reference_.weights, *reference_.state,
                                         materials_, stress_.values(), loads, system_, solver_);
  if (!reference_.factorised) {
    report.pivots = factorise_tightening(equilibrium, loads, to);
    report.condition = solver_.condition(system_.lower());
    reference_.factorised = true;
  }
  report.gap_bandwidth = 4.0 / (3.0 * reference_.scheme.pointwise);

  Eigen::VectorXd u = Eigen::VectorXd::Zero(system_.unknowns());
  report.newton = solve_newton(
      u, [&](const Eigen::VectorXd& at) { return equilibrium->residual(at); },
      [&](const Eigen::VectorXd& force) { return equilibrium->correction(force); },
      settings_.tolerance, settings_.largest_iterations);
  if (!report.newton.converged) {
    throw LoadStepFailed(message("Newton's method stalled at a relative residual of ",
                                 report.newton.residual, " after ", report.newton.iterations,
                                 " iterations, tolerance ", settings_.tolerance));
  }
  std::vector<Vec<Dim>> moves(points_.size());
  parallel_for(points_.size(), [&](Index p) { moves[p] = equilibrium->displacement(p, u); });
  report.penetration = deepest_penetration(moves, from, to);
  wall_forces_ = equilibrium->wall_forces(u, static_cast<int>(walls_.size()));
  update_points(*equilibrium, u, moves);
  reference_.moved = loads.since_reset.size() > 0 ? Eigen::VectorXd(loads.since_reset + u) : u;
  return report;
}

/// Factorise. Mean gaps on cells with next to no material may leave the matrix indefinite; then the
/// moderate constraint is made stiffer, which only adds to it, until the grid is reset.
template <int Dim>
PivotReport QuasiStatic<Dim>::factorise_tightening(std::unique_ptr<Equilibrium<Dim>>& equilibrium,
                                                   Loads<Dim>& loads, double to) {
  constexpr int most_tightenings = 4;
  constexpr double tighter = 4.0;
  for (int tightenings = 0;; ++tightenings) {
    const PivotReport pivots = equilibrium->factorise();
    if (pivots.not_positive == 0 || settings_.wall_form != WallForm::mean_gap ||
        tightenings == most_tightenings) {
      require_positive(pivots);
      return pivots;
    }
    reference_.scheme.pointwise *= tighter;
    loads = collect_loads(to);
    equilibrium =
        std::make_unique<Equilibrium<Dim>>(grid_, points_, reference_.weights, *reference_.state,
                                           materials_, stress_.values(), loads, system_, solver_);
  }
}

/// The grid is reset, as ever in the material point method, but not before a point has moved: moved
/// points no longer integrate cut cells exactly, and small displacements need not pay for that.
template <int Dim>
bool QuasiStatic<Dim>::is_reset_due() const {
  const std::span<const double> now = std::as_const(points_).position();
  const std::span<const double> then = reference_.position.values();
  double farthest = 0.0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    farthest = std::max(farthest, std::abs(now[k] - then[k]));
  }
  return !reference_.located || (farthest > 0.0 && farthest >= reset_);
}

template <int Dim>
void QuasiStatic<Dim>::reset_grid(double time) {
  std::copy_n(points_.position().data(), points_.position().size(), reference_.position.data());
  if (half_width_) {
    std::copy_n(half_width_->data(), half_width_->values().size(), reference_.half_width->data());
  }
  reference_.time = time;
  reference_.scheme = scheme_;
  reference_.moved.resize(0);
  locate_points();
}

template <int Dim>
void QuasiStatic<Dim>::locate_points() {
  reference_.located = reference_.factorised = false;
  reference_.weights.build(grid_, reference_.position.values(),
                           half_width_ ? std::span<const double>(reference_.half_width->values())
                                       : std::span<const double>());
  reference_.state =
      std::make_unique<CellState<Dim>>(grid_, points_, reference_.weights, materials_);
  reference_.facets = cut_walls(reference_.time);
  reference_.located = true;
}

template <int Dim>
std::vector<Facet<Dim>> QuasiStatic<Dim>::cut_walls(double time) const {
  CellState<Dim>& state = *reference_.state;
  const std::vector<char> near = cells_near_material(grid_, state);
  std::vector<const MovingSurface<Dim>*> solids;
  for (const auto& wall : walls_) {
    solids.push_back(&wall);
  }
  std::vector<Facet<Dim>> all;
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    std::vector<Facet<Dim>> facets = facets_at_material(
        grid_, state, walls_[w].cut(grid_, near, static_cast<int>(w), time, solids),
        settings_.hold_empty_cells);
    if (facets.empty()) {
      throw RunError(message(walls_[w].what(), " cuts no material",
                             settings_.hold_empty_cells ? "" : " (hold_empty_cells is off)",
                             ": move it to the body's surface, or check on which side of it the "
                             "material is"));
    }
    all.insert(all.end(), facets.begin(), facets.end());
  }
  return all;
}

template <int Dim>
Loads<Dim> QuasiStatic<Dim>::collect_loads(double to) const {
  Loads<Dim> loads;
  loads.since_reset = reference_.moved;
  std::vector<std::vector<Vec<Dim>>> motions;
  for (const Facet<Dim>& facet : reference_.facets) {
    motions.push_back(walls_[facet.surface].increments(facet, reference_.time, to));
    loads.walls.push_back(wall_term<Dim>(grid_, *reference_.state, facet, kinds_[facet.surface],
                                         motions.back(), reference_.scheme));
  }
  require_agreeing<Dim>(grid_, reference_.facets, motions, kinds_, names_);
  require_held<Dim>(grid_, points_, reference_.weights, reference_.facets, kinds_);
  loads.ghost = ghost_;
  if (ghost_ > 0.0) {
    loads.ghost_pairs = ghost_pairs<Dim>(grid_, *reference_.state, reference_.facets);
  }
  if (!settings_.body_force.empty()) {
    std::vector<Vec3> places(points_.size());
    for (Index p = 0; p < points_.size(); ++p) {
      places[p] = in_space<Dim>(points_.position<Dim>(p));
    }
    loads.body_force = values_at<Dim>(settings_.body_force, places, to);
  }
  add_tractions(loads, to);
  return loads;
}

template <int Dim>
void QuasiStatic<Dim>::add_tractions(Loads<Dim>& loads, double time) const {
  for (std::size_t t = 0; t < tractions_.size(); ++t) {
    std::vector<Facet<Dim>> facets =
        tractions_[t].cut(grid_, reference_.state->occupied, static_cast<int>(t), time, {});
    if (facets.empty()) {
      throw RunError(message(tractions_[t].what(), " meets no material"));
    }
    for (Facet<Dim>& facet : facets) {
      std::vector<Vec3> places;
      for (const auto& point : facet.points) {
        places.push_back(in_space<Dim>(point.position));
      }
      loads.tractions.push_back(values_at<Dim>(settings_.tractions[t].traction, places, time));
      loads.traction_faces.push_back(std::move(facet));
    }
  }
}

/// An indefinite matrix has no equilibrium worth the name: say where.
template <int Dim>
void QuasiStatic<Dim>::require_positive(const PivotReport& pivots) const {
  if (pivots.not_positive == 0) {
    return;
  }
  const Index node = system_.nodes()[pivots.smallest_unknown / Dim];
  const Vec<Dim> place = grid_.node_position(node);
  std::string near = "no wall";
  double least = std::numeric_limits<double>::infinity();
  for (const auto& wall : walls_) {
    const auto gap = wall.gap(in_space<Dim>(place), 0.0);
    if (gap && std::abs(*gap) < least) {
      least = std::abs(*gap);
      near = wall.what();
    }
  }
  throw RunError(
      message("the stiffness matrix is not positive definite: ", pivots.not_positive, " of ",
              system_.unknowns(), " pivots, the smallest ", pivots.smallest, " at the node near ",
              place.transpose(), " m, next to ", near,
              ": cells cut to slivers need ghost stabilisation (ghost = 0.01), nitsche a smaller "
              "gap_bandwidth"));
}

template <int Dim>
double QuasiStatic<Dim>::deepest_penetration(const std::vector<Vec<Dim>>& moves, double from,
                                             double to) const {
  const double limit = settings_.largest_penetration * grid_.cell_size();
  double deepest = 0.0;
  for (Index p = 0; p < points_.size(); ++p) {
    const Vec<Dim> before = points_.position<Dim>(p), after = before + moves[p];
    if (!grid_.contains(after)) {
      throw LoadStepFailed(message("point ", points_.id()[p], " leaves the grid at ",
                                   after.transpose(), " m: enlarge the grid or lower the load"));
    }
    for (std::size_t w = 0; w < walls_.size(); ++w) {
      const MovingSurface<Dim>& wall = walls_[w];
      if (kinds_[w] == HeldMotion::tangent) {
        continue;  // free across its face
      }
      const auto start = wall.gap(in_space<Dim>(before), from);
      if (!start || *start < -limit) {
        continue;
      }
      const auto end = wall.gap(in_space<Dim>(after), to);
      if (!end || -*end <= deepest) {
        continue;
      }
      deepest = -*end;
      if (deepest > limit) {
        throw LoadStepFailed(message(
            "point ", points_.id()[p], " is pushed ", deepest, " m through ", wall.what(), " at ",
            after.transpose(), " m, more than largest_penetration of ",
            settings_.largest_penetration,
            " cells: take smaller load steps, more points per cell or gimp shape functions"));
      }
    }
  }
  return deepest;
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

template <int Dim>
std::vector<Field> QuasiStatic<Dim>::fields() {
  return {{"displacement", "m", Dim, displacement_.values()},
          {"stress", "Pa", 6, stress_.values()}};
}

template <int Dim>
void QuasiStatic<Dim>::save(Archive& archive) const {
  archive.write("quasi_static/stress", stress_.values());
  archive.write("quasi_static/displacement", displacement_.values());
  archive.write("quasi_static/reference/time", reference_.time);
  archive.write("quasi_static/reference/pointwise", reference_.scheme.pointwise);
  archive.write("quasi_static/reference/moved",
                std::span<const double>(reference_.moved.data(),
                                        static_cast<std::size_t>(reference_.moved.size())));
  archive.write("quasi_static/reference/position", reference_.position.values());
  if (half_width_) {
    archive.write("quasi_static/half_width", std::as_const(*half_width_).values());
    archive.write("quasi_static/reference/half_width",
                  std::as_const(*reference_.half_width).values());
  }
}

template <int Dim>
void QuasiStatic<Dim>::load(const Archive& archive) {
  archive.read("quasi_static/stress", stress_.values());
  archive.read("quasi_static/displacement", displacement_.values());
  reference_.time = archive.read_number("quasi_static/reference/time");
  reference_.scheme = scheme_;
  reference_.scheme.pointwise = archive.read_number("quasi_static/reference/pointwise");
  const std::vector<double> moved = archive.read_numbers("quasi_static/reference/moved");
  reference_.moved =
      Eigen::Map<const Eigen::VectorXd>(moved.data(), static_cast<Index>(moved.size()));
  archive.read("quasi_static/reference/position", reference_.position.values());
  if (half_width_) {
    archive.read("quasi_static/half_width", half_width_->values());
    archive.read("quasi_static/reference/half_width", reference_.half_width->values());
  }
  locate_points();
}

template <int Dim>
std::vector<std::pair<std::string, double>> QuasiStatic<Dim>::diagnostics() const {
  std::vector<std::pair<std::string, double>> numbers{
      {"iterations", report_.newton.iterations},    {"residual", report_.newton.residual},
      {"smallest pivot", report_.pivots.smallest},  {"largest pivot", report_.pivots.largest},
      {"condition estimate", report_.condition},    {"halvings", report_.halvings},
      {"deepest penetration", report_.penetration},
  };
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t w = 0; w < walls_.size(); ++w) {
    for (int axis = 0; axis < Dim; ++axis) {
      numbers.emplace_back("force of " + walls_[w].what() + " along " + axes[axis],
                           wall_forces_[w][axis]);
    }
  }
  return numbers;
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
