#include "lapilli/peridynamics/conduction.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/parallel.hpp"
#include "lapilli/peridynamics/fluid_surface.hpp"

namespace lapilli {
namespace {

constexpr Index rows_a_task = 128;  // points worked on as one piece

/// Whether a wall's heat is a flux times the area it shares with the fluid.
bool acts_by_area(const FluidWall& wall) {
  return wall.settings.heat == WallHeat::flux || wall.settings.heat == WallHeat::convection;
}

}  // namespace

template <int Dim>
Conduction<Dim>::Conduction(Points& points, const WallSurface& walls,
                            const PeridynamicHeatSettings& settings, double conductivity)
    : points_(points),
      walls_(walls),
      conductivity_(conductivity),
      bonds_(points, walls, settings, conductivity),
      share_(walls.walls().size(), 1.0),
      wall_area_(walls.walls().size(), 0.0) {
  for (const FluidWall& wall : walls.walls()) {
    areas_matter_ |= acts_by_area(wall);
  }
}

template <int Dim>
void Conduction<Dim>::update() {
  const bool first = bonds_.first();
  if (bonds_.update()) {
    share_area(first);
  }
}

template <int Dim>
void Conduction<Dim>::refresh() {
  const bool first = bonds_.first();
  bonds_.refresh();
  share_area(first);
}

template <int Dim>
template <class Body>
void Conduction<Dim>::for_wall_bonds(Index point, const Body& body) const {
  const double least = 0.1 * walls_.spacing();
  for (Index bond = families().wall_begin(point); bond < families().end(point); ++bond) {
    if (bonds_[bond] == 0.0) {
      continue;
    }
    const Index j = families().neighbour(bond);
    const double ahead = std::max(least, walls_.template distance<Dim>(position(point), j));
    const double area = bonds_[bond] * (ahead + walls_.depth(j)) / conductivity_;
    body(WallBond{walls_.wall(j), area, ahead});
  }
}

template <int Dim>
void Conduction<Dim>::share_area(bool first) {
  if (first) {
    wall_area_ = shared_areas(walls_);
  }
  if (!areas_matter_) {
    return;
  }
  std::vector<double> met(wall_area_.size(), 0.0);
  for (Index i = 0; i < points_.size(); ++i) {
    if (families().owns(i) && families().wall_begin(i) < families().end(i)) {
      for_wall_bonds(i, [&](const WallBond& bond) { met[bond.wall] += bond.area; });
    }
  }
  for (std::size_t k = 0; k < met.size(); ++k) {
    share_[k] = acts_by_area(walls_.walls()[k]) && met[k] > 0.0 ? wall_area_[k] / met[k] : 1.0;
  }
}

template <int Dim>
double Conduction<Dim>::flux_through(const WallBond& bond, const WallState& state,
                                     double temperature) const {
  const FluidWallSettings& wall = walls_.walls()[bond.wall].settings;
  switch (wall.heat) {
    case WallHeat::temperature:
      return conductivity_ * (state.temperature - temperature) / bond.distance;
    case WallHeat::flux:
      return state.flux;
    case WallHeat::convection:
      return wall.coefficient > 0.0 ? (state.temperature - temperature) /
                                          (bond.distance / conductivity_ + 1.0 / wall.coefficient)
                                    : 0.0;
    case WallHeat::adiabatic:
      break;
  }
  return 0.0;
}

template <int Dim>
void Conduction<Dim>::rates(const double* temperature, const std::vector<WallState>& surface,
                            double* rate, std::vector<double>& from_walls) const {
  const std::int32_t* neighbours = families().neighbours();
  const auto walls = static_cast<Index>(surface.size());
  const Index tasks = (points_.size() + rows_a_task - 1) / rows_a_task;
  std::vector<double> partial(static_cast<std::size_t>(tasks * walls), 0.0);
  parallel_runs(tasks, [&](Index task) {
    for (Index i = task * rows_a_task; i < std::min(points_.size(), (task + 1) * rows_a_task);
         ++i) {
      rate[i] = 0.0;
      if (!families().owns(i)) {
        continue;
      }
      const double own = temperature[i];
      double sum = 0.0;
      for (Index k = families().begin(i); k < families().wall_begin(i); ++k) {
        sum += bonds_[k] * (temperature[neighbours[k]] - own);
      }
      if (families().wall_begin(i) < families().end(i)) {
        for_wall_bonds(i, [&](const WallBond& bond) {
          const double heat =
              share_[bond.wall] * bond.area * flux_through(bond, surface[bond.wall], own);
          partial[task * walls + bond.wall] += heat;
          sum += heat;
        });
      }
      rate[i] = sum;
    }
  });
  from_walls.assign(surface.size(), 0.0);
  for (Index task = 0; task < tasks; ++task) {
    for (Index k = 0; k < walls; ++k) {
      from_walls[k] += partial[task * walls + k];
    }
  }
}

// The gradient comes from the areas that conductances mean, G r / k: V grad T is the sum of area
// times what T differs by on the face of each bond. No point leaves the range of its family.
template <int Dim>
void Conduction<Dim>::add_missed(const double* temperature, const std::vector<WallState>& surface,
                                 const double* shift, double* missed) const {
  parallel_for(points_.size(), [&](Index i) {
    if (!families().owns(i)) {
      return;
    }
    const Eigen::Map<const Vec<Dim>> here(position(i)), by(shift + i * Dim);
    double sum = 0.0, least = 0.0, most = 0.0;
    for (Index k = families().begin(i); k < families().end(i); ++k) {
      const Index j = families().neighbour(k);
      double difference = 0.5 * (temperature[j] - temperature[i]);
      if (k >= families().wall_begin(i)) {
        const int wall = walls_.wall(j);
        const bool holds = walls_.walls()[wall].settings.heat == WallHeat::temperature;
        difference = holds ? surface[wall].temperature - temperature[i] : 0.0;
      }
      const Vec<Dim> bond = Eigen::Map<const Vec<Dim>>(position(j)) - here;
      sum += bonds_[k] / conductivity_ * by.dot(bond) * difference;
      least = std::min(least, difference);
      most = std::max(most, difference);
    }
    const double volume = points_.volume()[i];
    missed[i] += std::clamp(sum, volume * least, volume * most);
  });
}

template <int Dim>
void Conduction<Dim>::diagonal(double* sum) const {
  const std::vector<WallState> still(walls_.walls().size());
  parallel_for(points_.size(), [&](Index i) {
    sum[i] = 0.0;
    if (!families().owns(i)) {
      return;
    }
    for (Index k = families().begin(i); k < families().wall_begin(i); ++k) {
      sum[i] += families().neighbour(k) == i ? 0.0 : std::abs(bonds_[k]);
    }
    if (families().wall_begin(i) < families().end(i)) {
      // What one kelvin more in the point drives back into walls.
      for_wall_bonds(i, [&](const WallBond& bond) {
        sum[i] -= share_[bond.wall] * bond.area * flux_through(bond, still[bond.wall], 1.0);
      });
    }
  });
}

template <int Dim>
void Conduction<Dim>::wall_rows(const double* temperature, const std::vector<WallState>& surface,
                                double* flux, double* area) const {
  parallel_for(points_.size(), [&](Index i) {
    flux[i] = area[i] = 0.0;
    if (!families().owns(i) || families().wall_begin(i) == families().end(i)) {
      return;
    }
    for_wall_bonds(i, [&](const WallBond& bond) {
      const double met = share_[bond.wall] * bond.area;
      flux[i] += met * flux_through(bond, surface[bond.wall], temperature[i]);
      area[i] += met;
    });
    flux[i] = area[i] > 0.0 ? flux[i] / area[i] : 0.0;
  });
}

template <int Dim>
void Conduction<Dim>::save(Archive& archive) const {
  bonds_.save(archive);
  archive.write("heat/wall_area", wall_area_);
}

template <int Dim>
void Conduction<Dim>::load(const Archive& archive) {
  bonds_.load(archive);
  archive.read("heat/wall_area", wall_area_);
}

template class Conduction<1>;
template class Conduction<2>;
template class Conduction<3>;

}  // namespace lapilli
