#pragma once

#include <functional>
#include <span>

#include "lapilli/mpm/heat/heat_part.hpp"

namespace lapilli {

/// Convection of a constant coefficient so weak that explicit steps bear it: the part of its
/// surface term that couples nodes, coefficient times the integral of S_I S_J, stands in the
/// conduction of the part; at each node coefficient area (ambient - T) is left.
struct WeakExchange {
  std::size_t law;
  double coefficient;             // W/(m^2 K)
  std::vector<Index> place;       // of nodes, those that follow among them
  std::vector<double> area;       // integral of S_I over the surface, m^(dim-1)
  std::vector<Index> lead_place;  // of nodes that lead
  std::vector<double> lead_area;  // with what their followers have, where that is positive
};

/// Bounds the largest eigenvalue of C'^-1 A of a symmetric operator A >= 0, 1/s (Lanczos 1950;
/// what thirty steps may miss is added). `apply(x, y)` is y = A x by place, over nodes that lead.
double fastest_rate(std::span<const double> capacity,
                    const std::function<void(std::span<double>, std::span<double>)>& apply);

/// That of the conduction of a part, with the weak laws that stand in it, 1/s.
template <int Dim>
double fastest_rate(const HeatPart<Dim>& part, const std::vector<WeakExchange>& weak = {});

/// That of the slopes of a law of coefficient 1 W/(m^2 K), 1/s.
template <int Dim>
double fastest_exchange(const HeatPart<Dim>& part, std::size_t law);

/// Let weak laws join the conduction of a part, whose fastest rate (1/s) then stays below `most`.
template <int Dim>
std::vector<WeakExchange> join_weak_laws(const SurfaceConditions& laws, const Grid<Dim>& grid,
                                         double most, double rate, HeatPart<Dim>& part);

}  // namespace lapilli
