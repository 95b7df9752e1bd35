#include "lapilli/peridynamics/conduction_at_rest.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "lapilli/core/parallel.hpp"
#include "lapilli/geometry/cell_list.hpp"
#include "lapilli/peridynamics/held_edges.hpp"
#include "lapilli/peridynamics/influence.hpp"

namespace lapilli {
namespace {

constexpr Index piece_size = 512;     // points worked on as one piece
constexpr double nearest_only = 1.2;  // spacings
constexpr double nearest = 0.1;       // spacings: no point is taken to be nearer to its surface

}  // namespace

template <int Dim>
ConductionAtRest<Dim>::ConductionAtRest(const Points& points, const WallSurface& walls,
                                        const PeridynamicHeatSettings& settings,
                                        double conductivity)
    : points_(points),
      walls_(walls),
      conductivity_(conductivity),
      wall_area_(walls.walls().size(), 0.0) {
  take_surface();
  // Nearest neighbours alone are the classical difference star.
  find_bonds(settings, settings.horizon == 0.0 && follows_lattice() ? nearest_only
                                                                    : settings.widest_horizon());
  close_bonds();
}

template <int Dim>
void ConductionAtRest<Dim>::find_bonds(const PeridynamicHeatSettings& settings, double horizon) {
  const double spacing = walls_.spacing();
  const BondWeight weight{settings.influence, horizon * spacing, spacing, true};
  const CellList near(points_.position(), Dim, weight.horizon);
  const Index rows = points_.size();
  graph_.begin.assign(static_cast<std::size_t>(rows) + 1, 0);
  for (Index i = 0; i < rows; ++i) {
    if (fluid(i)) {
      near.each_within(walls_.place(i), weight.horizon, [&](Index j, double squared) {
        const double w = j != i && fluid(j) ? weight(std::sqrt(squared)) : 0.0;
        if (w > 0.0) {
          graph_.neighbour.push_back(static_cast<std::int32_t>(j));
          graph_.bond.push_back(points_.position<Dim>(j) - points_.position<Dim>(i));
          graph_.weight.push_back(w * points_.volume()[i] * points_.volume()[j]);
        }
      });
    }
    graph_.begin[i + 1] = static_cast<Index>(graph_.neighbour.size());
  }
}

template <int Dim>
bool ConductionAtRest<Dim>::follows_lattice() const {
  if (tilted_) {
    return false;
  }
  const double box = std::pow(walls_.spacing(), Dim);
  Vec3 first = Vec3::Zero();
  bool found = false;
  for (Index i = 0; i < points_.size(); ++i) {
    if (!fluid(i)) {
      continue;
    }
    const Vec3 at = walls_.place(i);
    first = found ? first : at;
    found = true;
    const Vec3 steps = (at - first) / walls_.spacing();
    const Vec3 off = steps - Vec3(steps.array().round());
    if (off.cwiseAbs().maxCoeff() > 1e-6 || std::abs(points_.volume()[i] / box - 1.0) > 1e-6) {
      return false;
    }
  }
  return true;
}

template <int Dim>
void ConductionAtRest<Dim>::take_surface() {
  const auto rows = static_cast<std::size_t>(points_.size());
  const double side = walls_.spacing();
  surface_.area.assign(rows, Vec<Dim>::Zero());
  surface_.moment.assign(rows, 0.0);
  for (std::size_t i = 0; i < rows; ++i) {
    surface_.moment[i] = Dim * points_.volume()[i];
  }
  const FluidSurface found = find_fluid_surface(walls_);
  lost_at_ends_ = lapilli::lost_at_ends(found, walls_);
  std::map<FluidSurface::BoxIndex, std::vector<Index>> inhabitants;
  for (Index i = 0; i < points_.size(); ++i) {
    if (fluid(i)) {
      inhabitants[found.box_of(walls_.place(i))].push_back(i);
    }
  }
  const CellList near(points_.position(), Dim, 1.6 * side);
  // The point whose box a piece cuts; pieces of boxes without one point of their own go to the
  // nearest.
  const auto owner_of = [&](const BoundaryPiece& piece, const Vec3& box) {
    const auto own = inhabitants.find(found.box_of(box + Vec3::Constant(0.5 * side)));
    if (own != inhabitants.end() && own->second.size() == 1) {
      return own->second.front();
    }
    Index best = -1;
    double least = 1e300;
    near.each_within(piece.place, 2.0 * side, [&](Index j, double squared) {
      if (fluid(j) && squared < least) {
        least = squared;
        best = j;
      }
    });
    return best;
  };
  for (std::size_t b = 0; b < found.boxes.size(); ++b) {
    for (const BoundaryPiece& piece : found.pieces[b]) {
      const Index owner = owner_of(piece, found.boxes[b]);
      if (owner >= 0) {
        const double ahead = piece.normal.dot(piece.place - walls_.place(owner));
        surface_.area[owner] += piece.area * piece.normal.head<Dim>();
        surface_.moment[owner] -= piece.area * ahead;
        tilted_ = tilted_ || piece.normal.cwiseAbs().maxCoeff() < 1.0 - 1e-9;
        add_contact(owner, piece, ahead);
      }
    }
  }
  for (std::size_t i = 0; i < rows; ++i) {
    surface_.moment[i] = std::max(surface_.moment[i], 0.1 * Dim * points_.volume()[i]);
  }
}

template <int Dim>
void ConductionAtRest<Dim>::add_contact(Index point, const BoundaryPiece& piece, double ahead) {
  if (piece.wall < 0 || walls_.walls()[piece.wall].settings.heat == WallHeat::adiabatic) {
    return;
  }
  wall_area_[piece.wall] += piece.area;
  contacts_.push_back({static_cast<std::int32_t>(point), piece.wall, piece.area,
                       std::max(ahead, nearest * walls_.spacing())});
}

template <int Dim>
void ConductionAtRest<Dim>::close_bonds() {
  // Pieces of one point and wall act as one, through the mean of 1 / distance.
  std::stable_sort(contacts_.begin(), contacts_.end(), [](const Contact& a, const Contact& b) {
    return a.point != b.point ? a.point < b.point : a.wall < b.wall;
  });
  std::vector<Contact> merged;
  for (const Contact& one : contacts_) {
    if (!merged.empty() && merged.back().point == one.point && merged.back().wall == one.wall) {
      Contact& all = merged.back();
      const double over = all.area / all.distance + one.area / one.distance;
      all.area += one.area;
      all.distance = all.area / over;
    } else {
      merged.push_back(one);
    }
  }
  contacts_ = std::move(merged);
  contact_begin_.assign(static_cast<std::size_t>(points_.size()) + 1, 0);
  for (const Contact& one : contacts_) {
    ++contact_begin_[one.point + 1];
  }
  std::vector<Vec<Dim>> places;
  for (Index i = 0; i < points_.size(); ++i) {
    contact_begin_[i + 1] += contact_begin_[i];
    places.push_back(points_.position<Dim>(i));
  }
  BondBalance<Dim> balance(graph_, surface_, std::move(places));
  conductance_ = balance.solve();
  for (double& g : conductance_) {
    g *= conductivity_;
  }
  imbalance_ = *std::max_element(balance.open().begin(), balance.open().end());
  // Only neighbours and conductances are needed from here on.
  graph_.bond = {};
  graph_.weight = {};
  surface_ = {};
}

template <int Dim>
double ConductionAtRest<Dim>::flux_through(const Contact& contact, const WallState& state,
                                           double temperature) const {
  const FluidWallSettings& wall = walls_.walls()[contact.wall].settings;
  switch (wall.heat) {
    case WallHeat::temperature:
      return conductivity_ * (state.temperature - temperature) / contact.distance;
    case WallHeat::flux:
      return state.flux;
    case WallHeat::convection:
      return conductivity_ == 0.0 ? 0.0
                                  : (state.temperature - temperature) /
                                        (contact.distance / conductivity_ + 1.0 / wall.coefficient);
    case WallHeat::adiabatic:
      break;
  }
  return 0.0;
}

template <int Dim>
void ConductionAtRest<Dim>::rates(const double* temperature, const std::vector<WallState>& surface,
                                  double* rate, std::vector<double>& from_walls) const {
  const auto walls = static_cast<Index>(surface.size());
  const Index tasks = (points_.size() + piece_size - 1) / piece_size;
  std::vector<double> partial(static_cast<std::size_t>(tasks * walls), 0.0);
  parallel_runs(tasks, [&](Index task) {
    for (Index i = task * piece_size; i < std::min(points_.size(), (task + 1) * piece_size); ++i) {
      double sum = 0.0;
      for (Index b = graph_.begin[i]; b < graph_.begin[i + 1]; ++b) {
        sum += conductance_[b] * (temperature[graph_.neighbour[b]] - temperature[i]);
      }
      for (Index c = contact_begin_[i]; c < contact_begin_[i + 1]; ++c) {
        const Contact& contact = contacts_[c];
        const double heat =
            contact.area * flux_through(contact, surface[contact.wall], temperature[i]);
        partial[task * walls + contact.wall] += heat;
        sum += heat;
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

template <int Dim>
void ConductionAtRest<Dim>::diagonal(double* sum) const {
  const std::vector<WallState> still(walls_.walls().size());
  parallel_for(points_.size(), [&](Index i) {
    sum[i] = 0.0;
    for (Index b = graph_.begin[i]; b < graph_.begin[i + 1]; ++b) {
      sum[i] += conductance_[b];
    }
    for (Index c = contact_begin_[i]; c < contact_begin_[i + 1]; ++c) {
      // What one kelvin more in the point drives back into walls.
      sum[i] -= contacts_[c].area * flux_through(contacts_[c], still[contacts_[c].wall], 1.0);
    }
  });
}

template <int Dim>
void ConductionAtRest<Dim>::wall_rows(const double* temperature,
                                      const std::vector<WallState>& surface, double* flux,
                                      double* area) const {
  parallel_for(points_.size(), [&](Index i) {
    flux[i] = area[i] = 0.0;
    for (Index c = contact_begin_[i]; c < contact_begin_[i + 1]; ++c) {
      const Contact& contact = contacts_[c];
      flux[i] += contact.area * flux_through(contact, surface[contact.wall], temperature[i]);
      area[i] += contact.area;
    }
    flux[i] = area[i] > 0.0 ? flux[i] / area[i] : 0.0;
  });
}

template class ConductionAtRest<1>;
template class ConductionAtRest<2>;
template class ConductionAtRest<3>;

}  // namespace lapilli
