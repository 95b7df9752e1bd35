#include "lapilli/mpm/heat/weak_exchange.hpp"

#include <cmath>

namespace lapilli {
namespace {

/// Add coefficient times the integral of S_I S_J over the surface of a law to the conduction.
template <int Dim>
void join(const Grid<Dim>& grid, const WeakExchange& weak, HeatPart<Dim>& part) {
  const auto& [node, place, trace] = part.nodal;
  const std::vector<double>& area = part.surface[weak.law].sites.area;
  const auto& rows = trace[weak.law];
  for (Eigen::Index site = 0; site < rows.rows(); ++site) {
    const double weight = weak.coefficient * area[site];
    for (SurfaceTerm::Trace::InnerIterator a(rows, site); a; ++a) {
      for (SurfaceTerm::Trace::InnerIterator b(rows, site); b; ++b) {
        if (node[a.col()] >= node[b.col()]) {
          continue;  // once a pair, from the earlier node
        }
        const auto from = grid.node_at(node[a.col()]), to = grid.node_at(node[b.col()]);
        typename SharedStencil<Dim>::Step step;
        for (int axis = 0; axis < Dim; ++axis) {
          step[axis] = to[axis] - from[axis];
        }
        part.conduction->add(place[a.col()], place[b.col()], step, weight * a.value() * b.value());
      }
    }
  }
}

/// The integrals of the functions of a trace over the surface, where positive.
void integrate(const SurfaceTerm::Trace& trace, const std::vector<double>& area,
               const std::vector<Index>& place, std::vector<Index>& places,
               std::vector<double>& integrals) {
  const Eigen::Map<const Eigen::VectorXd> areas(area.data(),
                                                static_cast<Eigen::Index>(area.size()));
  const Eigen::VectorXd all = trace.transpose() * areas;
  for (Eigen::Index k = 0; k < all.size(); ++k) {
    if (all[k] > 0.0) {
      places.push_back(place[static_cast<std::size_t>(k)]);
      integrals.push_back(all[k]);
    }
  }
}

template <int Dim>
WeakExchange exchange_of(const SurfaceConditions& laws, std::size_t law,
                         const HeatPart<Dim>& part) {
  WeakExchange weak;
  weak.law = law;
  weak.coefficient = given_coefficient(laws[law])->at(0.0);
  const SurfaceTerm::Part& surface = part.surface[law];
  integrate(part.nodal.trace[law], surface.sites.area, part.nodal.place, weak.place, weak.area);
  integrate(surface.trace, surface.sites.area, part.unknown_place, weak.lead_place, weak.lead_area);
  return weak;
}

}  // namespace

template <int Dim>
std::vector<WeakExchange> join_weak_laws(const SurfaceConditions& laws, const Grid<Dim>& grid,
                                         double most, double rate, HeatPart<Dim>& part) {
  std::vector<WeakExchange> weak;
  for (std::size_t law = 0; law < laws.size(); ++law) {
    const Value* coefficient = given_coefficient(laws[law]);
    if (coefficient == nullptr || !laws.is_uniform(law) || !coefficient->is_constant()) {
      continue;
    }
    // Rates of two operators together are at most the sum of theirs.
    const double added = coefficient->at(0.0) * fastest_exchange(part, law);
    if (added >= 0.0 && rate + added <= most) {
      rate += added;
      weak.push_back(exchange_of(laws, law, part));
      join(grid, weak.back(), part);
    }
  }
  return weak;
}

template <int Dim>
double fastest_exchange(const HeatPart<Dim>& part, std::size_t law) {
  const auto& trace = part.surface[law].trace;
  const std::vector<double>& area = part.surface[law].sites.area;
  const Eigen::Map<const Eigen::VectorXd> areas(area.data(),
                                                static_cast<Eigen::Index>(area.size()));
  const std::vector<Index>& unknown = part.unknown_place;
  std::vector<double> capacity;
  for (const Index place : unknown) {
    capacity.push_back(part.capacity[place]);
  }
  return fastest_rate(capacity, [&](std::span<double> x, std::span<double> y) {
    const Eigen::Map<const Eigen::VectorXd> in(x.data(), static_cast<Eigen::Index>(x.size()));
    const Eigen::VectorXd there = trace * in;
    Eigen::Map<Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size())) =
        trace.transpose() * areas.cwiseProduct(there);
  });
}

#define LAPILLI_INSTANTIATE(Dim)                                                                \
  template std::vector<WeakExchange> join_weak_laws(const SurfaceConditions&, const Grid<Dim>&, \
                                                    double, double, HeatPart<Dim>&);            \
  template double fastest_exchange(const HeatPart<Dim>&, std::size_t);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
