#include "lapilli/peridynamics/peridynamic_flow.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/geometry/checks.hpp"
#include "lapilli/peridynamics/flow_places.hpp"
#include "lapilli/peridynamics/heat.hpp"
#include "lapilli/peridynamics/sound_speed.hpp"

namespace lapilli {
namespace {

constexpr Index piece = flow_piece;
constexpr double largest_shift = 0.05;  // spacings a step
constexpr int sort_every = 8;           // searches

template <class Body>
void over_pieces(Index rows, const Body& body) {
  parallel_runs((rows + piece - 1) / piece,
                [&](Index task) { body(task, task * piece, std::min(rows, (task + 1) * piece)); });
}

std::vector<FamilyRole> roles_of(const WallSurface& walls) {
  std::vector<FamilyRole> roles;
  for (Index body = 0; body < walls.bodies(); ++body) {
    roles.push_back({Member::owner, walls.wall_of_body(body) >= 0});
  }
  return roles;
}

template <int Dim>
Vec<Dim> vector_of(const std::vector<double>& values) {
  return place(values).template head<Dim>();
}

}  // namespace

template <int Dim>
PeridynamicFlow<Dim>::PeridynamicFlow(Points& points, std::shared_ptr<WallSurface> walls,
                                      const PeridynamicFlowSettings& settings, const Fluid& fluid,
                                      const PeridynamicHeat* heat, bool with_dissipation,
                                      PrintedEquations printed)
    : points_(points),
      walls_(std::move(walls)),
      settings_(settings),
      fluid_(fluid.newtonian),
      heat_(heat),
      printed_(printed),
      weight_{settings.influence, settings.horizon * walls_->spacing(), walls_->spacing(), true},
      lattice_constant_(2.0 / lattice_moment(Dim, weight_)),
      gravity_(vector_of<Dim>(settings.gravity)),
      sound_speed_(choose_sound_speed(points, *walls_, settings, fluid, heat)),
      pressure_{fluid.newtonian.density, sound_speed_, settings.stiffness_exponent},
      two_field_(settings.laplacian == Laplacian::literal ||
                 settings.laplacian == Laplacian::zero_energy),
      velocity_(points, Dim),
      acceleration_(points, Dim),
      density_(points, 1, fluid.newtonian.density),
      mass_(points, 1),
      shift_(points, Dim),
      shifted_(points, Dim),
      pressure_field_(points, 1),
      force_(points.size()),
      families_(points, weight_.horizon, settings.skin * walls_->spacing(), roles_of(*walls_)),
      least_density_(fluid.newtonian.density),
      most_density_(fluid.newtonian.density),
      smallest_spacing_(walls_->spacing()) {
  const auto rows = static_cast<std::size_t>(points.size());
  rows_.assign(rows * row_size, 0.0);
  if (heat_ != nullptr && !gravity_.isZero(0.0)) {
    borne_.emplace(*walls_, families_, gravity_);
  }
  gradient_.assign(two_field_ ? rows : 0, Mat<Dim>::Zero());
  inverse_shape_.assign(two_field_ ? rows : 0, Mat<Dim>::Zero());
  if (with_dissipation) {
    dissipation_ = std::make_unique<PointArray>(points, 1);
  }
  for (Index i = 0; i < points.size(); ++i) {
    mass_[i] = fluid.newtonian.density * points.volume()[i];
    if (const int wall = walls_->wall(i); wall >= 0) {
      const Vec<Dim> v = vector_of<Dim>(walls_->walls()[wall].settings.velocity);
      walls_slide_ |= !v.isZero(0.0);
      std::copy(v.data(), v.data() + Dim, velocity_.data() + i * Dim);
    }
  }
  for (const FluidBody& body : fluid.bodies) {
    const Vec<Dim> v = vector_of<Dim>(body.velocity);
    for (Index i = 0; i < points.size(); ++i) {
      if (points.body()[i] == body.body) {
        std::copy(v.data(), v.data() + Dim, velocity_.data() + i * Dim);
      }
    }
  }
  const auto tasks = (rows + piece - 1) / piece;
  piece_least_.assign(tasks, fluid.newtonian.density);
  piece_most_.assign(tasks, fluid.newtonian.density);
  piece_spacing_.assign(tasks, 1e100);
  piece_fastest_.assign(tasks, 0.0);
  piece_farthest_.assign(tasks, 0.0);
}

template <int Dim>
StepLimit PeridynamicFlow<Dim>::step_limit() const {
  const double dx = walls_->spacing();
  const double acoustic = dx / sound_speed_;
  const double viscous = fluid_.viscosity > 0.0
                             ? dx * dx * fluid_.density / (Dim * fluid_.viscosity)
                             : std::numeric_limits<double>::infinity();
  StepLimit limit;
  limit.hard = std::min(acoustic, viscous);
  limit.automatic = std::min(settings_.courant * acoustic, settings_.viscous_step * viscous);
  limit.reason =
      message("explicit flow: dx / sound speed ", acoustic, " s, dx^2 / (dim nu) ", viscous, " s");
  return limit;
}

template <int Dim>
StepReport PeridynamicFlow<Dim>::advance(const Step& step) {
  find_reference();
  if (!started_) {
    start();
  }
  find_fastest();
  kick_and_drift(step);
  find_families();
  update_density_and_kick(step.size);
  check_density();
  age_ += step.size;
  return {step.size, 0, 0.0};
}

template <int Dim>
void PeridynamicFlow<Dim>::start() {
  find_families();
  part_coincident_points<Dim>(points_, *walls_, families_);
  gather_rows();
  balance_density();
  update_density_and_kick(0.0);
  started_ = true;
}

template <int Dim>
void PeridynamicFlow<Dim>::find_reference() {
  if (heat_ != nullptr && gravity_ != Vec<Dim>::Zero()) {
    const double given = fluid_.reference_temperature;
    reference_ = given != 0.0 ? given : heat_->mean_temperature();
  }
}

template <int Dim>
void PeridynamicFlow<Dim>::find_fastest() {
  if (fastest_known_) {
    return;
  }
  over_pieces(points_.size(), [&](Index task, Index begin, Index end) {
    piece_fastest_[task] = fastest_squared(begin, end);
  });
  fastest_known_ = true;
}

template <int Dim>
double PeridynamicFlow<Dim>::fastest_squared(Index begin, Index end) const {
  double most = 0.0;
  for (Index i = begin; i < end; ++i) {
    if (fluid(i)) {
      most = std::max(most, Eigen::Map<const Vec<Dim>>(velocity_.data() + i * Dim).squaredNorm());
    }
  }
  return most;
}

template <int Dim>
void PeridynamicFlow<Dim>::kick_and_drift(const Step& step) {
  const double dt = step.size;
  const double speed = std::sqrt(*std::max_element(piece_fastest_.begin(), piece_fastest_.end()));
  // Eq. 38 with the sign that spreads points.
  const double sign = printed_.towards_neighbours ? 1.0 : -1.0;
  const double shifting = sign * settings_.shifting * speed * dt;
  const double most = largest_shift * walls_->spacing();
  const auto position = points_.position();
  over_pieces(points_.size(), [&](Index task, Index begin, Index end) {
    double farthest = 0.0;
    for (Index i = begin; i < end; ++i) {
      Eigen::Map<Vec<Dim>> x(position.data() + i * Dim), v(velocity_.data() + i * Dim);
      Vec<Dim> by = Vec<Dim>::Zero();
      if (fluid(i)) {
        v += 0.5 * dt * Eigen::Map<const Vec<Dim>>(acceleration_.data() + i * Dim);
        const Vec<Dim> away = shifting * Eigen::Map<const Vec<Dim>>(shift_.data() + i * Dim);
        const double squared = away.squaredNorm();
        const Vec<Dim> shifted = (squared > most * most ? most / std::sqrt(squared) : 1.0) * away;
        by = dt * v + shifted;
        Eigen::Map<Vec<Dim>>(shifted_.data() + i * Dim) = shifted;
      } else if (walls_->walls()[walls_->wall(i)].settings.moves) {
        by = dt * v;
      }
      x += by;
      const double moved = by.squaredNorm();
      farthest = moved <= farthest ? farthest : std::min(1e300, moved);  // also of no number
      gather_row(i);
    }
    piece_farthest_[task] = farthest;
  });
  points_.moved_at_most(
      std::sqrt(*std::max_element(piece_farthest_.begin(), piece_farthest_.end())));
}

template <int Dim>
void PeridynamicFlow<Dim>::find_families() {
  if (families_.stale() && families_.searches() % sort_every == 0) {
    points_.permute(cell_order(points_, weight_.horizon + settings_.skin * walls_->spacing()));
    gather_rows();
  }
  if (families_.update()) {
    reach_ = families_.reach(piece);
    check_places<Dim>(points_, *walls_, families_, velocity_);
  }
}

template <int Dim>
void PeridynamicFlow<Dim>::gather_rows() {
  over_pieces(points_.size(), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      gather_row(i);
    }
  });
}

template <int Dim>
void PeridynamicFlow<Dim>::gather_row(Index point) {
  double* row = rows_.data() + point * row_size;
  for (int d = 0; d < Dim; ++d) {
    row[d] = points_.position()[point * Dim + d];
    row[4 + d] = velocity_[point * Dim + d];
  }
  row[3] = mass_[point] / density_[point];
  row[7] = density_[point];
  if (borne_) {
    const bool known =
        fluid(point) || walls_->walls()[walls_->wall(point)].settings.heat == WallHeat::temperature;
    borne_->set(point, known ? share_of_gravity(point) : std::nan(""));
  }
}

template <int Dim>
void PeridynamicFlow<Dim>::update_density_and_kick(double step_size) {
  bond_weights_.prepare(static_cast<Index>(reach_.size()), thread_count());
  parallel_wave(
      reach_, [&](Index task) { update_density(task, step_size); },
      [&](Index task) { accelerate_and_kick(task, 0.5 * step_size); });
  fastest_known_ = true;
}

template <int Dim>
void PeridynamicFlow<Dim>::check_density() {
  for (std::size_t task = 0; task < piece_least_.size(); ++task) {
    least_density_ = std::min(least_density_, piece_least_[task]);
    most_density_ = std::max(most_density_, piece_most_[task]);
    smallest_spacing_ = std::min(smallest_spacing_, piece_spacing_[task]);
  }
  const double allowed = settings_.largest_density_variation;
  const auto [low, high] = density_variation();
  if (low >= -allowed && high <= allowed) {
    return;
  }
  for (Index i = 0; i < points_.size(); ++i) {
    const double variation = density_[i] / fluid_.density - 1.0;
    if (fluid(i) && !(std::abs(variation) <= allowed)) {
      throw RunError(
          message("density of point ", points_.id()[i], " is ", 100.0 * variation,
                  " % off its reference, more than the allowed ", 100.0 * allowed,
                  " %: the flow outruns its sound speed of ", sound_speed_,
                  " m/s; raise sound_speed_factor or give sound_speed, or the step is too long"));
    }
  }
}

template class PeridynamicFlow<1>;
template class PeridynamicFlow<2>;
template class PeridynamicFlow<3>;

}  // namespace lapilli
