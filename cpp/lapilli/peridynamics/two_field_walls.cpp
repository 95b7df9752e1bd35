// What the two fields exchange with walls.
#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/parallel.hpp"
#include "lapilli/peridynamics/two_field_conduction.hpp"

namespace lapilli {

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

/// In line with the family of the fluid point, off the face of the wall, which has `of_wall`.
template <int Dim>
double TwoFieldConduction<Dim>::rise_beyond(Index point, Index wall_point,
                                            std::span<const double> temperature,
                                            double of_wall) const {
  double rise = 0.0, moment = 0.0;
  const auto see = [&](Index k, double weight) {
    const double ahead =
        walls_.template distance<Dim>(points_.position().data() + k * Dim, wall_point);
    rise += weight * ahead * (temperature[k] - of_wall);
    moment += weight * ahead * ahead;
  };
  see(point, weight_(0.5 * walls_.spacing()) * volume_[point]);
  for (Index bond = families_.begin(point); bond < families_.wall_begin(point); ++bond) {
    see(families_.neighbour(bond), operators_->weight(bond));
  }
  const double slope = moment > 0.0 ? rise / moment : 0.0;
  return of_wall - slope * walls_.depth(wall_point) - temperature[point];
}

/// The fluid point that stands before a wall point, of the family of another.
template <int Dim>
Index TwoFieldConduction<Dim>::in_front(Index wall_point, Index owner) const {
  const Eigen::Map<const Vec<Dim>> normal(walls_.normal(wall_point));
  Index best = owner;
  double least = std::numeric_limits<double>::infinity();
  const auto see = [&](Index k) {
    const Vec<Dim> y = points_.position<Dim>(k) - points_.position<Dim>(wall_point);
    const double ahead = normal.dot(y), aside = (y - ahead * normal).norm();
    // The nearest of those that stand as straight, to a hundredth of the way.
    if (const double off = aside + 0.01 * std::abs(ahead); off < least) {
      least = off;
      best = k;
    }
  };
  see(owner);
  for (Index bond = families_.begin(owner); bond < families_.wall_begin(owner); ++bond) {
    if (operators_->weight(bond) != 0.0) {
      see(families_.neighbour(bond));
    }
  }
  return best;
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
      if (walls_.wall(i) < 0 && operators_->weight(bond) > 0.0 &&
          first_layer(families_.neighbour(bond))) {
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

#define LAPILLI_INSTANTIATE(Dim)                                                                 \
  template void TwoFieldConduction<Dim>::share_fluxes();                                         \
  template double TwoFieldConduction<Dim>::rise_beyond(Index, Index, std::span<const double>,    \
                                                       double) const;                            \
  template Index TwoFieldConduction<Dim>::in_front(Index, Index) const;                          \
  template void TwoFieldConduction<Dim>::wall_rows(const double*, const std::vector<WallState>&, \
                                                   double*, double*) const;                      \
  template double TwoFieldConduction<Dim>::wall_area(int) const;
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
