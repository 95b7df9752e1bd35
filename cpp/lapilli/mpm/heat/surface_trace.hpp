#pragma once

#include <span>
#include <utility>
#include <vector>

#include "lapilli/mpm/heat/heat_laws.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"

namespace lapilli {

/// How the temperature at a place of the surface comes from the nodes around it: shape functions,
/// and where some of these nodes have next to nothing of the body, what reproduces straight lines
/// from the others. `fraction` is sum V S / h^dim by node; `own` is the node the place belongs to,
/// taken alone where no other will do.
template <int Dim>
std::vector<std::pair<Index, double>> surface_trace(const Grid<Dim>& grid, ShapeFunction shape,
                                                    double half_width, const Vec<Dim>& place,
                                                    std::span<const double> fraction, Index own);

/// The laws of the surface at its own temperature, over one step: the nodal rises d that solve
///
///   (C + dt M) d = C d0 + dt E,   E_I = sum S_I(x_s) rate_s,   M_IJ = sum slope_s S_I(x_s)
///   S_J(x_s)
///
/// over the places s of the surface, by conjugate gradients. Acting on every node of the band
/// instead, a law pins the whole band once coefficient h / conductivity passes .3.
template <int Dim>
class SurfaceSystem {
 public:
  /// `increment` holds d0 on entry and d on return. A node beside a corner, whose places lie too
  /// deep, stops at the end of `range` (K). Books the heat of each law. Returns the iterations;
  /// throws RunError when they do not converge.
  int solve(HeatLaws<Dim>& laws, std::span<const double> capacity,
            std::span<const double> temperature, const TemperatureRange& range, double step,
            std::span<double> increment);

 private:
  struct Site {
    std::size_t first, last;  // of place_ and weight_
    double rate, slope;       // W, W/K
  };

  void number_nodes(const HeatLaws<Dim>& laws, std::size_t nodes);
  void gather(const HeatLaws<Dim>& laws);
  double at(const Site& site, const std::vector<double>& x) const;
  void multiply(const std::vector<double>& x, double step, std::vector<double>& product) const;
  void book(HeatLaws<Dim>& laws, double step, double given) const;

  std::vector<int> number_;  // by node of the grid, -1 off the surface
  std::vector<Index> node_;  // of the unknowns
  std::vector<Site> sites_;
  std::vector<std::size_t> sites_of_law_;
  std::vector<int> place_;
  std::vector<double> weight_;
  std::vector<double> capacity_, rise_, residual_, direction_, image_, diagonal_;
};

}  // namespace lapilli
