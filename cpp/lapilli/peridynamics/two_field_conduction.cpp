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
        wall < 0 || (walls_.walls()[wall].settings.heat == WallHeat::temperature && first_layer(i));
    volume_[i] = takes_part ? points_.volume()[i] : 0.0;
  }
  // Next to walls a point that moves, or sees others move, may have few neighbours left.
  operators_.emplace(points_, families_, weight_, volume_, [](Index) { return true; });
  share_fluxes();
  version_ = points_.version();
  ordering_ = points_.ordering();
}

template <int Dim>
void TwoFieldConduction<Dim>::share_fluxes() {
  const double spacing = walls_.spacing();
  const auto each_in_front = [&](const auto& visit) {
    for (Index i = 0; i < points_.size(); ++i) {
      for (Index bond = families_.wall_begin(i); walls_.wall(i) < 0 && bond < families_.end(i);
           ++bond) {
        const Index j = families_.neighbour(bond);
        if (!prescribes_flux(j) || !first_layer(j)) {
          continue;
        }
        const Vec<Dim> y = points_.position<Dim>(i) - points_.position<Dim>(j);
        const double ahead = Eigen::Map<const Vec<Dim>>(walls_.normal(j)).dot(y);
        const double aside = std::sqrt(std::max(0.0, y.squaredNorm() - ahead * ahead)) / spacing;
        // Points of a wall's corners have fluid across a diagonal alone, and no surface.
        const bool faces = y.squaredNorm() < 1.69 * spacing * spacing;
        if (faces && aside < 0.75 && ahead > 0.0 && ahead - walls_.depth(j) < spacing) {
          visit(i, j, 1.0 - aside / 0.75);
        }
      }
    }
  };
  std::vector<double> all(static_cast<std::size_t>(points_.size()), 0.0);
  each_in_front([&](Index, Index j, double weight) { all[j] += weight; });
  std::vector<double> area(walls_.walls().size(), 0.0);
  flux_shares_.clear();
  each_in_front([&](Index i, Index j, double weight) {
    const double share = weight / all[j] * points_.volume()[j] / spacing;
    flux_shares_.push_back({static_cast<std::int32_t>(i), walls_.wall(j), share});
    area[walls_.wall(j)] += share;
  });
  if (flux_area_.empty()) {
    flux_area_ = area;
  }
  for (FluxShare& one : flux_shares_) {
    one.area *= flux_area_[one.wall] / area[one.wall];
  }
}

template <int Dim>
void TwoFieldConduction<Dim>::rates(const double* temperature,
                                    const std::vector<WallState>& surface, double* rate,
                                    std::vector<double>& from_walls) const {
  const Index rows = points_.size();
  const std::span<const double> values(temperature, static_cast<std::size_t>(rows));
  const double k = conductivity_;
  // Eq. 29, as k grad T = -q.
  std::vector<Vec<Dim>> flux(static_cast<std::size_t>(rows), Vec<Dim>::Zero());
  for (Index i = 0; i < rows; ++i) {
    if (volume_[i] == 0.0) {
      continue;
    }
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (Index bond = families_.begin(i); bond < families_.end(i); ++bond) {
      const Index j = families_.neighbour(bond);
      sum += operators_->weight(bond) * (values[j] - values[i]) *
             (points_.position<Dim>(j) - points_.position<Dim>(i));
    }
    flux[i] = k * operators_->inverse_shape(i) * sum;
  }
  from_walls.assign(surface.size(), 0.0);
  const double zero_energy =
      settings_.laplacian == Laplacian::zero_energy ? settings_.zero_energy : 0.0;
  for (Index i = 0; i < rows; ++i) {
    rate[i] = 0.0;
    if (walls_.wall(i) >= 0) {
      continue;
    }
    const Vec<Dim> own = operators_->inverse_shape(i) * flux[i];
    for (Index bond = families_.begin(i); bond < families_.end(i); ++bond) {
      const Index j = families_.neighbour(bond);
      const Vec<Dim> y = points_.position<Dim>(j) - points_.position<Dim>(i);
      double heat = (own + operators_->inverse_shape(j) * flux[j]).dot(y);
      if (zero_energy > 0.0) {
        const double scale =
            0.5 * (operators_->inverse_shape(i).trace() + operators_->inverse_shape(j).trace());
        heat +=
            zero_energy * scale * (k * (values[j] - values[i]) - 0.5 * (flux[i] + flux[j]).dot(y));
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
void TwoFieldConduction<Dim>::wall_rows(const double* temperature,
                                        const std::vector<WallState>& surface, double* flux,
                                        double* area) const {
  // The slope between the surface and the points next to it.
  parallel_for(points_.size(), [&](Index i) {
    flux[i] = area[i] = 0.0;
    if (walls_.wall(i) >= 0) {
      return;
    }
    for (Index bond = families_.wall_begin(i); bond < families_.end(i); ++bond) {
      const Index j = families_.neighbour(bond);
      if (operators_->weight(bond) == 0.0) {
        continue;
      }
      const double ahead =
          std::max(0.1 * walls_.spacing(),
                   walls_.template distance<Dim>(points_.position().data() + i * Dim, j));
      const double w = operators_->weight(bond);
      flux[i] += w * conductivity_ * (surface[walls_.wall(j)].temperature - temperature[i]) / ahead;
      area[i] += w;
    }
    if (area[i] > 0.0) {
      flux[i] /= area[i];
      area[i] = points_.volume()[i] / walls_.spacing();
    }
  });
  for (const FluxShare& one : flux_shares_) {
    const double met = area[one.point] + one.area;
    flux[one.point] = (flux[one.point] * area[one.point] + one.area * surface[one.wall].flux) / met;
    area[one.point] = met;
  }
}

template <int Dim>
double TwoFieldConduction<Dim>::wall_area(int wall) const {
  if (walls_.walls()[wall].settings.heat == WallHeat::flux) {
    return flux_area_[static_cast<std::size_t>(wall)];
  }
  double area = 0.0;
  std::vector<char> met(static_cast<std::size_t>(points_.size()), 0);
  for (Index i = 0; i < points_.size(); ++i) {
    for (Index bond = families_.wall_begin(i); bond < families_.end(i); ++bond) {
      if (walls_.wall(i) < 0 && operators_->weight(bond) > 0.0) {
        met[families_.neighbour(bond)] = 1;
      }
    }
  }
  for (Index j = 0; j < points_.size(); ++j) {
    if (met[j] != 0 && walls_.wall(j) == wall) {
      area += points_.volume()[j] / walls_.spacing();
    }
  }
  return area;
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
