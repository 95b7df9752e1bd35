#include "lapilli/peridynamics/two_field_conduction.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

std::vector<FamilyRole> thermal_roles_of(const WallSurface& walls) {
  std::vector<FamilyRole> roles;
  for (Index body = 0; body < walls.bodies(); ++body) {
    const int wall = walls.wall_of_body(body);
    const bool adiabatic = wall >= 0 && walls.walls()[wall].settings.heat == WallHeat::adiabatic;
    roles.push_back({adiabatic ? Member::absent : Member::owner, wall >= 0});
  }
  return roles;
}

}  // namespace

template <int Dim>
TwoFieldConduction<Dim>::TwoFieldConduction(Points& points, const WallSurface& walls,
                                            const PeridynamicHeatSettings& settings,
                                            double conductivity)
    : points_(points),
      walls_(walls),
      settings_(settings),
      conductivity_(conductivity),
      weight_{settings.influence, settings.widest_horizon() * walls.spacing(), walls.spacing(),
              true},
      families_(points, weight_.horizon, settings.skin * walls.spacing(), thermal_roles_of(walls)) {
  for (const FluidWall& wall : walls.walls()) {
    require(wall.settings.heat != WallHeat::convection, "wall '", wall.settings.name, "' has ",
            name_of(wall.settings.heat), ", which the laplacian '", name_of(settings.laplacian),
            "' does not know; take compact or corrected");
  }
}

template <int Dim>
void TwoFieldConduction<Dim>::update() {
  if (version_ == points_.version() && ordering_ == points_.ordering()) {
    return;
  }
  families_.update();
  volume_.assign(static_cast<std::size_t>(points_.size()), 0.0);
  for (Index i = 0; i < points_.size(); ++i) {
    const int wall = walls_.wall(i);
    const bool takes_part =
        wall < 0 || (walls_.walls()[wall].settings.heat == WallHeat::temperature &&
                     (holds_on_face() || first_layer(i)));
    volume_[i] = takes_part ? points_.volume()[i] : 0.0;
  }
  // Next to walls a point that moves, or sees others move, may have few neighbours left.
  operators_.emplace(points_, families_, weight_, volume_, [](Index) { return true; });
  share_fluxes();
  version_ = points_.version();
  ordering_ = points_.ordering();
}

/// How much warmer point i sees its neighbour j, K.
template <int Dim>
double TwoFieldConduction<Dim>::rise_to(Index i, Index j, std::span<const double> temperature,
                                        const std::vector<WallState>& surface) const {
  const int wall = walls_.wall(j);
  return holds_on_face() && wall >= 0 ? rise_beyond(i, j, temperature, surface[wall].temperature)
                                      : temperature[j] - temperature[i];
}

/// Eq. 29, as k grad T = -q.
template <int Dim>
std::vector<Vec<Dim>> TwoFieldConduction<Dim>::inward_fluxes(
    std::span<const double> temperature, const std::vector<WallState>& surface) const {
  std::vector<Vec<Dim>> flux(temperature.size(), Vec<Dim>::Zero());
  for (Index i = 0; i < points_.size(); ++i) {
    if (volume_[i] == 0.0 || (holds_on_face() && walls_.wall(i) >= 0)) {
      continue;
    }
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (Index bond = families_.begin(i); bond < families_.end(i); ++bond) {
      if (operators_->weight(bond) != 0.0) {
        const Index j = families_.neighbour(bond);
        sum += operators_->weight(bond) * rise_to(i, j, temperature, surface) *
               (points_.position<Dim>(j) - points_.position<Dim>(i));
      }
    }
    flux[i] = conductivity_ * operators_->inverse_shape(i) * sum;
  }
  return flux;
}

template <int Dim>
void TwoFieldConduction<Dim>::rates(const double* temperature,
                                    const std::vector<WallState>& surface, double* rate,
                                    std::vector<double>& from_walls) const {
  const std::span<const double> values(temperature, static_cast<std::size_t>(points_.size()));
  const std::vector<Vec<Dim>> flux = inward_fluxes(values, surface);
  from_walls.assign(surface.size(), 0.0);
  const double zero_energy =
      settings_.laplacian == Laplacian::zero_energy ? settings_.zero_energy : 0.0;
  for (Index i = 0; i < points_.size(); ++i) {
    rate[i] = 0.0;
    if (walls_.wall(i) >= 0) {
      continue;
    }
    const Vec<Dim> own = operators_->inverse_shape(i) * flux[i];
    for (Index bond = families_.begin(i); bond < families_.end(i); ++bond) {
      if (operators_->weight(bond) == 0.0) {
        continue;
      }
      // What lies beyond a face that holds its temperature is as the point before it.
      const Index j = families_.neighbour(bond);
      const Index like = holds_on_face() && walls_.wall(j) >= 0 ? in_front(j, i) : j;
      const Vec<Dim> y = points_.position<Dim>(j) - points_.position<Dim>(i);
      double heat = (own + operators_->inverse_shape(like) * flux[like]).dot(y);
      if (zero_energy > 0.0) {
        const double scale =
            0.5 * (operators_->inverse_shape(i).trace() + operators_->inverse_shape(like).trace());
        heat +=
            zero_energy * scale *
            (conductivity_ * rise_to(i, j, values, surface) - 0.5 * (flux[i] + flux[like]).dot(y));
      }
      heat *= volume_[i] * operators_->weight(bond);
      rate[i] += heat;
      if (const int wall = walls_.wall(j); wall >= 0) {
        from_walls[wall] += heat;
      }
    }
  }
  for (const FluxShare& one : flux_shares_) {
    const double heat = one.area * surface[one.wall].flux;
    rate[one.point] += heat;
    from_walls[one.wall] += heat;
  }
}

template <int Dim>
double TwoFieldConduction<Dim>::imbalance() const {
  double largest = 0.0;
  for (Index i = 0; i < points_.size(); ++i) {
    if (walls_.wall(i) >= 0 || families_.wall_begin(i) < families_.end(i)) {
      continue;
    }
    Vec<Dim> out = Vec<Dim>::Zero();
    double scale = 0.0;
    for (Index bond = families_.begin(i); bond < families_.end(i); ++bond) {
      const Index j = families_.neighbour(bond);
      const Vec<Dim> y = points_.position<Dim>(j) - points_.position<Dim>(i);
      const Vec<Dim> part = operators_->weight(bond) *
                            (operators_->inverse_shape(i) + operators_->inverse_shape(j)) * y;
      out += part;
      scale += part.norm();
    }
    if (scale > 0.0) {
      largest = std::max(largest, out.norm() / scale);
    }
  }
  return largest;
}

template <int Dim>
void TwoFieldConduction<Dim>::save(Archive& archive) const {
  families_.save(archive, "heat/families");
  archive.write("heat/flux_area", flux_area_);
}

template <int Dim>
void TwoFieldConduction<Dim>::load(const Archive& archive) {
  families_.load(archive, "heat/families");
  flux_area_.resize(walls_.walls().size());
  archive.read("heat/flux_area", flux_area_);
  version_ = -1;
}

template class TwoFieldConduction<1>;
template class TwoFieldConduction<2>;
template class TwoFieldConduction<3>;

}  // namespace lapilli
