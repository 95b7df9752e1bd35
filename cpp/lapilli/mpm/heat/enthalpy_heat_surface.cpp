#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/enthalpy_heat.hpp"
#include "lapilli/mpm/heat/weak_exchange.hpp"

namespace lapilli {
namespace {

/// Newton's rounds may end at their bar or at rounding, not where the exchange is not met: RunError
/// with the place where a residual (J) is left beside what was exchanged, `scale` (J).
template <int Dim>
void require_solved(const SurfaceTerm::Vector& residual, double scale, const Grid<Dim>& grid,
                    const std::vector<std::array<int, 3>>& coordinates) {
  constexpr double most = 1e-6;  // of what the surface exchanges in a step
  Eigen::Index worst = 0;
  if (residual.cwiseAbs().maxCoeff(&worst) <= most * scale) {
    return;
  }
  Vec<Dim> at = grid.origin();
  for (std::size_t axis = 0; axis < Dim; ++axis) {
    at[static_cast<Eigen::Index>(axis)] +=
        coordinates[static_cast<std::size_t>(worst)][axis] * grid.cell_size();
  }
  throw RunError(message("heat: what the surface exchanges was not found near (", at.transpose(),
                         ") m: off by ", std::abs(residual[worst]) / scale,
                         " of it in a step; give a smaller time.step"));
}

}  // namespace

template <int Dim>
void EnthalpyHeat<Dim>::connect_surface() {
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    const HeatPart<Dim>& part = solved_[k].part;
    for (const Index place : part.unknown_place) {
      unknown_.push_back({k, place});
    }
    for (const auto& at : part.rows->coordinates(part.unknown_place)) {
      coordinates_.push_back(at);
    }
  }
  // One system over all parts: sites below each other, unknowns beside each other.
  std::vector<SurfaceTerm::Part> joined(laws_.size());
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    const bool contact = law >= outer_laws();
    std::vector<Eigen::Triplet<double>> entries;
    SurfaceSites& sites = joined[law].sites;
    sites.layer.thickness = 0.0;
    double rate = 0.0;
    for (std::size_t part = 0; part < solved_.size(); ++part) {
      const SurfaceTerm::Part& own = solved_[part].part.surface[law];
      if (own.sites.area.empty()) {
        continue;
      }
      rate = std::max(rate, fastest_exchange(solved_[part].part, law));
      // At a contact the temperature of the second body counts against that of the first.
      const bool second = contact && part != part_of_[contacts_[law - outer_laws()].first];
      const int column = first_unknown(part);
      const auto row = contact ? 0 : static_cast<int>(sites.area.size());
      for (Eigen::Index k = 0; k < own.trace.rows(); ++k) {
        for (SurfaceTerm::Trace::InnerIterator it(own.trace, k); it; ++it) {
          entries.emplace_back(row + static_cast<int>(k), column + static_cast<int>(it.col()),
                               second ? -it.value() : it.value());
        }
      }
      if (second) {
        continue;
      }
      const auto add = [](auto& all, const auto& some) {
        all.insert(all.end(), some.begin(), some.end());
      };
      add(sites.position, own.sites.position);
      add(sites.normal, own.sites.normal);
      add(sites.area, own.sites.area);
      add(sites.hold, own.sites.hold);
      add(sites.conductivity, own.sites.conductivity);
      sites.depth = own.sites.depth;
      const HoldLayer& layer = own.sites.layer;
      sites.layer = {std::max(sites.layer.thickness, layer.thickness),
                     sites.layer.behind || layer.behind};
    }
    joined[law].trace = SurfaceTerm::Trace(static_cast<Eigen::Index>(sites.area.size()),
                                           static_cast<Eigen::Index>(unknown_.size()));
    joined[law].trace.setFromTriplets(entries.begin(), entries.end());
    exchange_rate_.push_back(contact ? 2.0 * rate : rate);  // (a - b)^2 <= 2 a^2 + 2 b^2
  }
  surface_ = SurfaceTerm(laws_, std::move(joined), static_cast<Eigen::Index>(unknown_.size()),
                         std::vector<bool>(laws_.size(), false));
}

template <int Dim>
int EnthalpyHeat<Dim>::first_unknown(std::size_t part) const {
  std::size_t before = 0;
  for (std::size_t k = 0; k < part; ++k) {
    before += solved_[k].part.unknown_place.size();
  }
  return static_cast<int>(before);
}

template <int Dim>
template <class Values>
typename EnthalpyHeat<Dim>::Vector EnthalpyHeat<Dim>::gather(const Values& values) const {
  Vector some(static_cast<Eigen::Index>(unknown_.size()));
  for (std::size_t k = 0; k < unknown_.size(); ++k) {
    some[static_cast<Eigen::Index>(k)] = values(unknown_[k]);
  }
  return some;
}

template <int Dim>
bool EnthalpyHeat<Dim>::bears_explicitly(double size) const {
  constexpr double most = 1.5;  // automatic steps of conduction alone have 1.2, 2 is the end
  double sum = 0.0;
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    sum += surface_.steepest(law) * exchange_rate_[law];
  }
  return sum == 0.0 || size * (2.0 / limit_.hard + sum) <= most;
}

template <int Dim>
void EnthalpyHeat<Dim>::exchange_with_surroundings(const Step& step) {
  if (surface_.empty() || unknown_.empty()) {
    return;
  }
  const Vector temperature =
      gather([&](const Unknown& u) { return solved_[u.part].part.temperature[u.place]; });
  surface_.evaluate(laws_, temperature, step.time, step.time + step.size);
  Vector given = step.size * surface_.force(), rise = Vector::Zero(given.size());
  if (!bears_explicitly(step.size)) {
    const Vector start = gather([&](const Unknown& u) { return solved_[u.part].stored[u.place]; });
    const Vector coming = gather([&](const Unknown& u) { return solved_[u.part].heat[u.place]; });
    const Vector end = solve_surface(step.size, start, coming);
    given = end - start - coming;
    Eigen::Index k = 0;
    rise = gather([&](const Unknown& u) {
             return solved_[u.part].enthalpy.at(u.place, end[k++]).temperature;
           }) -
           temperature;
  }
  for (std::size_t k = 0; k < unknown_.size(); ++k) {
    solved_[unknown_[k].part].heat[unknown_[k].place] += given[static_cast<Eigen::Index>(k)];
  }
  std::vector<double> heat(laws_.size());
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    heat[law] = step.size * surface_.heat(law, rise);
  }
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    through_contact_[k] -= heat[outer_laws() + k];
    heat[outer_laws() + k] = 0.0;  // what one body gives the other takes
  }
  laws_.account().book(heat, given.sum());
}

template <int Dim>
typename EnthalpyHeat<Dim>::Vector EnthalpyHeat<Dim>::solve_surface(double size,
                                                                    const Vector& start,
                                                                    const Vector& coming) {
  constexpr int most_rounds = 40, most_halvings = 6;
  constexpr double resists = 1e12;  // capacity of what melts, in those of its node
  const Vector wanted = start + coming + size * surface_.force();
  Vector capacity(start.size()), temperature(start.size());
  const auto look = [&](const Vector& stored) {
    for (Eigen::Index k = 0; k < stored.size(); ++k) {
      const Unknown& u = unknown_[static_cast<std::size_t>(k)];
      const auto [value, slope] = solved_[u.part].enthalpy.at(u.place, stored[k]);
      temperature[k] = value;
      capacity[k] = slope > 0.0 ? 1.0 / slope : resists * solved_[u.part].part.capacity[u.place];
    }
  };
  look(start);
  const Vector before = temperature;
  const double rounding = (size * surface_.slopes_times(before)).cwiseAbs().maxCoeff();
  const double bar =
      std::max({1e-11 * (wanted - start).cwiseAbs().maxCoeff(), 1e-14 * rounding, 1e-300});
  const auto residual_of = [&](const Vector& stored) {
    look(stored);
    return Vector(wanted - stored - size * surface_.slopes_times(temperature - before));
  };
  Vector stored = start + coming;
  Vector residual = residual_of(stored);
  for (int round = 0; round < most_rounds && residual.cwiseAbs().maxCoeff() > bar; ++round) {
    SurfaceTerm::Matrix base(capacity.size(), capacity.size());
    base.setIdentity();
    base.diagonal() = capacity;
    solver_.set_base(
        base, 0.0,
        Dim == 3 ? SurfaceSolver::Method::conjugate_gradient : SurfaceSolver::Method::direct,
        coordinates_);
    const Vector change =
        residual - size * surface_.slopes_times(solver_.solve(surface_, size, residual));
    double share = 1.0;
    Vector trial = stored + change;
    Vector next = residual_of(trial);
    for (int k = 0; k < most_halvings && !(next.norm() < residual.norm()); ++k) {
      share *= 0.5;
      trial = stored + share * change;
      next = residual_of(trial);
    }
    stored = trial;
    residual = next;
  }
  const double exchanged = std::max((wanted - start).cwiseAbs().maxCoeff(), rounding);
  require_solved(residual, exchanged, problem_.grid, coordinates_);
  return stored;
}

#define LAPILLI_INSTANTIATE(Dim)                                                \
  template void EnthalpyHeat<Dim>::connect_surface();                           \
  template bool EnthalpyHeat<Dim>::bears_explicitly(double) const;              \
  template void EnthalpyHeat<Dim>::exchange_with_surroundings(const Step&);     \
  template typename EnthalpyHeat<Dim>::Vector EnthalpyHeat<Dim>::solve_surface( \
      double, const Vector&, const Vector&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
