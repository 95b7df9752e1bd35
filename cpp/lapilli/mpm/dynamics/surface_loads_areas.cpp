// Areas of loads and what they are scaled by.
#include <numeric>

#include "lapilli/mpm/dynamics/surface_loads.hpp"
#include "lapilli/mpm/surface/surface_regions.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"

namespace lapilli {
namespace {

constexpr int smoothing = 2;  // passes over the fraction, for its normals

}  // namespace

ContactFaces contact_faces(const Walls& walls) {
  ContactFaces faces;
  for (std::size_t face = 0; face < walls.size(); ++face) {
    faces[face] = !walls[face].is_open();
  }
  return faces;
}

/// Loads that go on are scaled as they were: bodies have moved away from their shapes.
template <int Dim>
void SurfaceLoads<Dim>::go_on(const PointStart& start) {
  const std::string name = "dynamics/loads/area_ratios";
  if (start.state != nullptr && !start.load.empty() && start.state->contains(name + "/bodies")) {
    ratios_ = AreaRatios::of_before(*start.state, name, start.body, start.load);
  }
}

template <int Dim>
AreaRatios::Found SurfaceLoads<Dim>::areas_without_others(
    const DynamicsData<Dim>& data, const DistanceFunction& distance,
    const std::vector<std::size_t>& bodies) const {
  const std::unique_ptr<Points> some = points_of(data.points, bodies);
  OutsideCells<Dim> cells(data.grid, static_cast<int>(data.half_widths.size()));
  cells.start(*some, distance);
  const NodalAreas<Dim> areas =
      free_areas(data.grid, nodal_sums<Dim>(*some, data.grid, data.shape, data.half_widths), cells);
  const auto parts = divide_surface<Dim>(
      data.grid, areas,
      [&] {
        return surface_places<Dim>(data.grid, *some, data.shape, data.half_widths, areas,
                                   contact_faces(data.walls));
      },
      regions_of(laws_));
  AreaRatios::Found found{std::accumulate(areas.area.begin(), areas.area.end(), 0.0), {}};
  for (const auto& of_law : parts) {
    found.by_condition.push_back(lapilli::area_of<Dim>(of_law, areas.area));
  }
  return found;
}

template <int Dim>
void SurfaceLoads<Dim>::compare_with_shapes(const DynamicsData<Dim>& data,
                                            const DynamicsProblem<Dim>& problem) {
  std::vector<Shape> shapes;
  for (const DynamicsBody& body : problem.bodies) {
    if (!body.shape) {
      return;
    }
    shapes.push_back(*body.shape);
  }
  const ShapeAreas wanted = areas_of_shapes<Dim>(data.grid, data.shape, shapes, regions_of(laws_),
                                                 contact_faces(data.walls));
  ratios_ = AreaRatios(wanted, [&](const std::vector<std::size_t>& bodies) {
    return areas_without_others(data, problem.distance, bodies);
  });
}

template <int Dim>
NodalAreas<Dim> SurfaceLoads<Dim>::free_areas(const Grid<Dim>& grid, const NodalSums<Dim>& sums,
                                              const OutsideCells<Dim>& cells) const {
  if (!contact_.any()) {
    return nodal_normal_areas(grid, sums, surface_nodes(grid, cells.flags(), sums.fraction),
                              smoothing, true);
  }
  const NodalSums<Dim> free = contact_.without_contact(sums);
  const std::vector<unsigned char> outside = contact_.without_walls(cells.flags());
  return nodal_normal_areas(grid, free, surface_nodes(grid, std::span(outside), sums.fraction),
                            smoothing, true);
}

#define LAPILLI_INSTANTIATE(Dim)                                                                  \
  template void SurfaceLoads<Dim>::go_on(const PointStart&);                                      \
  template void SurfaceLoads<Dim>::compare_with_shapes(const DynamicsData<Dim>&,                  \
                                                       const DynamicsProblem<Dim>&);              \
  template NodalAreas<Dim> SurfaceLoads<Dim>::free_areas(const Grid<Dim>&, const NodalSums<Dim>&, \
                                                         const OutsideCells<Dim>&) const;
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
