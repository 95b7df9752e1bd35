#include "lapilli/peridynamics/heat_exchange.hpp"

#include "lapilli/peridynamics/conduction.hpp"
#include "lapilli/peridynamics/conduction_at_rest.hpp"
#include "lapilli/peridynamics/two_field_conduction.hpp"

namespace lapilli {
namespace {

template <int Dim>
std::unique_ptr<HeatExchange> make(Points& points, const WallSurface& walls,
                                   const PeridynamicHeatSettings& settings, double conductivity,
                                   bool points_move) {
  if (settings.laplacian == Laplacian::literal || settings.laplacian == Laplacian::zero_energy) {
    return std::make_unique<TwoFieldConduction<Dim>>(points, walls, settings, conductivity);
  }
  if (!points_move && settings.laplacian != Laplacian::compact && walls.region()) {
    return std::make_unique<ConductionAtRest<Dim>>(points, walls, settings, conductivity);
  }
  return std::make_unique<Conduction<Dim>>(points, walls, settings, conductivity);
}

}  // namespace

std::unique_ptr<HeatExchange> make_heat_exchange(Points& points, const WallSurface& walls,
                                                 const PeridynamicHeatSettings& settings,
                                                 double conductivity, bool points_move) {
  switch (points.dimension()) {
    case 1:
      return make<1>(points, walls, settings, conductivity, points_move);
    case 2:
      return make<2>(points, walls, settings, conductivity, points_move);
    default:
      return make<3>(points, walls, settings, conductivity, points_move);
  }
}

}  // namespace lapilli
