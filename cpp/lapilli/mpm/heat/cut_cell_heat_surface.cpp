#include <algorithm>
#include <cmath>

#include "lapilli/mpm/heat/cut_cell_heat.hpp"

namespace lapilli {
namespace {

// Unknowns near the surface from which a factor takes longer than iterating.
constexpr std::size_t direct_limit = 60'000;

}  // namespace

template <int Dim>
void CutCellHeat<Dim>::connect_surface(std::vector<double>& rates) {
  // Explicit exchange is free, an implicit one costs a system over the surface: worth steps this
  // much smaller.
  constexpr double worth = Dim == 3 ? 3.0 : 1.5;
  const double most = worth * *std::max_element(rates.begin(), rates.end());
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    Solved& one = solved_[k];
    std::vector<bool> elsewhere(laws_.size(), false);
    if (!is_implicit()) {
      one.weak = join_weak_laws<Dim>(laws_, problem_.grid, most, rates[k], one.part);
      for (const WeakExchange& weak : one.weak) {
        elsewhere[weak.law] = true;
      }
      if (!one.weak.empty()) {
        rates[k] = fastest_rate(one.part, one.weak);
      }
      for (std::size_t law = 0; law < laws_.size(); ++law) {
        one.exchange_rate.push_back(elsewhere[law] ? 0.0 : fastest_exchange(one.part, law));
      }
    }
    if (is_implicit()) {
      elsewhere.assign(laws_.size(), true);
    }
    one.near.surface =
        SurfaceTerm(laws_, is_adaptive() ? one.part.surface : std::move(one.part.surface),
                    static_cast<Eigen::Index>(one.near.unknown_place.size()), elsewhere);
    one.part.nodal = {};
  }
}

template <int Dim>
void CutCellHeat<Dim>::exchange_weakly(Solved& one, const Step& step, std::span<double> heat) {
  const double* inverse = one.inverse.data();
  const double* temperature = one.part.temperature.data();
  for (const WeakExchange& weak : one.weak) {
    const double ambient =
        laws_.uniform(weak.law, 0.0, {}, step.time, step.time + step.size).ambient;
    const double factor = step.size * weak.coefficient;
    double sum = 0.0;
    for (std::size_t k = 0; k < weak.place.size(); ++k) {
      const Index place = weak.place[k];
      const double given = weak.area[k] * (ambient - temperature[place]);
      one.increment[place] += factor * given * inverse[place];
      sum += given;
    }
    heat[weak.law] = factor * sum;
  }
}

template <int Dim>
void CutCellHeat<Dim>::centre_weak_exchange(Solved& one, double step, std::span<double> heat) {
  // Exchange at the middle of the step, where the surface is warmer by half of what it rises.
  for (const WeakExchange& weak : one.weak) {
    const double factor = 0.5 * step * weak.coefficient;
    double sum = 0.0;
    for (std::size_t k = 0; k < weak.lead_place.size(); ++k) {
      double& rise = one.increment[weak.lead_place[k]];
      const double slope = factor * weak.lead_area[k];
      rise /= 1.0 + slope * one.inverse[weak.lead_place[k]];
      sum += slope * rise;
    }
    laws_.account().book(weak.law, heat[weak.law] - sum);
  }
}

template <int Dim>
void CutCellHeat<Dim>::prepare(const Solved& one, System& system, double scale) const {
  if (system.solver.has_base(scale)) {
    return;
  }
  const SurfaceTerm::Vector capacity = gather(system, one.part.capacity);
  SurfaceTerm::Matrix base(capacity.size(), capacity.size());
  base = scale > 0.0 ? SurfaceTerm::Matrix(scale * system.conduction) : base;
  std::vector<Eigen::Triplet<double>> diagonal;
  for (Eigen::Index k = 0; k < capacity.size(); ++k) {
    diagonal.emplace_back(static_cast<int>(k), static_cast<int>(k), capacity[k]);
  }
  SurfaceTerm::Matrix stored(capacity.size(), capacity.size());
  stored.setFromTriplets(diagonal.begin(), diagonal.end());
  base += stored;
  const HeatSolver choice = problem_.settings.solver;
  const bool whole = scale > 0.0;
  const std::size_t limit = !whole     ? direct_limit
                            : Dim == 3 ? std::size_t{30'000}
                                       : std::size_t{400'000};
  const std::size_t size = system.unknown_place.size();
  // Near a surface in space a factor fills up; without a prescribed temperature a few rounds of
  // conjugate gradients do.
  bool holds = false;
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    holds = holds || laws_.holds_temperature(law);
  }
  const bool few_rounds = Dim == 3 && !whole && !holds && size > 2000;
  const bool direct = choice == HeatSolver::direct ||
                      (choice == HeatSolver::automatic && !few_rounds && size <= limit);
  system.solver.set_base(
      std::move(base), scale,
      direct ? SurfaceSolver::Method::direct : SurfaceSolver::Method::conjugate_gradient,
      direct ? one.part.rows->coordinates(system.unknown_place)
             : std::vector<std::array<int, 3>>{});
}

template <int Dim>
bool CutCellHeat<Dim>::bears_explicitly(const Solved& one, double step) const {
  constexpr double most = 1.5;  // automatic steps of conduction alone have 1.2, 2 is the end
  double sum = 0.0;
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    sum += one.near.surface.steepest(law) * one.exchange_rate[law];
  }
  return sum == 0.0 || step * (2.0 / limit_.hard + sum) <= most;
}

template <int Dim>
void CutCellHeat<Dim>::exchange_with_surroundings(Solved& one, const Step& step) {
  System& near = one.near;
  if (near.surface.empty() || near.unknown_place.empty()) {
    return;
  }
  near.surface.evaluate(laws_, gather(near, one.part.temperature), step.time,
                        step.time + step.size);
  const SurfaceTerm::Vector before = gather(near, one.increment);
  const SurfaceTerm::Vector capacity = gather(near, one.part.capacity);
  SurfaceTerm::Vector rise, later = SurfaceTerm::Vector::Zero(before.size());
  if (!bears_explicitly(one, step.size)) {
    prepare(one, near, 0.0);
    rise = near.solver.solve(near.surface, step.size,
                             capacity.cwiseProduct(before) + step.size * near.surface.force());
    later = rise;
  } else {
    rise = before + step.size * near.surface.force().cwiseQuotient(capacity);
  }
  scatter(near, rise, one.increment);
  book_laws(one, step.size, later, capacity.dot(rise - before));
}

template <int Dim>
void CutCellHeat<Dim>::book_laws(const Solved& one, double size, const SurfaceTerm::Vector& rise,
                                 double given) {
  std::vector<double> heat(laws_.size());
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    heat[law] = size * one.near.surface.heat(law, rise);
  }
  laws_.account().book(heat, given);
}

#define LAPILLI_INSTANTIATE(Dim)                                                               \
  template void CutCellHeat<Dim>::connect_surface(std::vector<double>&);                       \
  template void CutCellHeat<Dim>::exchange_weakly(Solved&, const Step&, std::span<double>);    \
  template void CutCellHeat<Dim>::centre_weak_exchange(Solved&, double, std::span<double>);    \
  template void CutCellHeat<Dim>::prepare(const Solved&, System&, double) const;               \
  template bool CutCellHeat<Dim>::bears_explicitly(const Solved&, double) const;               \
  template void CutCellHeat<Dim>::exchange_with_surroundings(Solved&, const Step&);            \
  template void CutCellHeat<Dim>::book_laws(const Solved&, double, const SurfaceTerm::Vector&, \
                                            double);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
