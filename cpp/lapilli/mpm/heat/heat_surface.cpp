#include "lapilli/mpm/heat/heat_surface.hpp"

#include <algorithm>
#include <map>

namespace lapilli {

template <int Dim>
HeatSurface<Dim>::HeatSurface(const Points& points, const HeatProblem<Dim>& problem)
    : problem_(problem),
      contact_(problem.grid, problem.walls),
      outside_(problem.grid, static_cast<int>(problem.bodies.size())),
      version_(points.version()) {
  outside_.start(points, problem.distance);
}

template <int Dim>
NodalAreas<Dim> HeatSurface<Dim>::areas(const Points& points,
                                        const HeatCoefficients<Dim>& coefficients,
                                        const NodalSums<Dim>& sums) {
  const HeatSettings& settings = problem_.settings;
  if (settings.method == FluxMethod::paper) {
    return paper_areas(points, problem_, coefficients, sums);
  }
  if (points.version() != version_) {
    outside_.follow(points);
    version_ = points.version();
  }
  if (settings.method == FluxMethod::node) {
    return face_areas(problem_.grid, points, outside_.flags());
  }
  if (contact_.any()) {
    const NodalSums<Dim> both = contact_.mirrored(sums);
    const std::vector<unsigned char> flags = contact_.without_walls(outside_.flags());
    NodalAreas<Dim> areas = nodal_normal_areas(
        problem_.grid, both, surface_nodes(problem_.grid, std::span(flags), both.fraction),
        settings.normal_smoothing, settings.corner_fit);
    contact_.take_off(areas, sums, outside_.flags());
    return areas;
  }
  return nodal_normal_areas(problem_.grid, sums,
                            surface_nodes(problem_.grid, outside_.flags(), sums.fraction),
                            settings.normal_smoothing, settings.corner_fit);
}

namespace {

/// Nodes of the body in a cell that is not full, by node.
template <int Dim>
std::vector<unsigned char> nodes_beside_free_cells(const Points& points,
                                                   const HeatProblem<Dim>& problem,
                                                   const NodalSums<Dim>& sums) {
  const Grid<Dim>& grid = problem.grid;
  std::vector<double> fill(static_cast<std::size_t>(grid.cell_count()), 0.0);
  for (Index row = 0; row < points.size(); ++row) {
    fill[grid.cell_index(grid.cell_containing(points.position<Dim>(row)))] += points.volume()[row];
  }
  // Walls are no surface: the cells behind them count as full.
  const std::vector<unsigned char> none(fill.size(), 1);
  const std::vector<unsigned char> free = WallContact<Dim>(grid, problem.walls).without_walls(none);
  for (std::size_t cell = 0; cell < fill.size(); ++cell) {
    fill[cell] = free[cell] != 0 ? fill[cell] : grid.cell_volume();
  }
  // A cell filled to exactly eta must not be decided by rounding.
  const double least = problem.settings.surface_fraction * grid.cell_volume() * (1.0 - 1e-9);
  std::vector<unsigned char> surface(static_cast<std::size_t>(grid.node_count()), 0);
  for (Index node = 0; node < grid.node_count(); ++node) {
    const auto at = grid.node_at(node);
    if (sums.fraction[node] <= 0.0) {
      continue;
    }
    for (int corner = 0; corner < (1 << Dim); ++corner) {
      auto cell = at;
      for (int axis = 0; axis < Dim; ++axis) {
        cell[axis] -= (corner >> axis) & 1;
      }
      if (fill[grid.cell_index(cell)] < least) {
        surface[node] = 1;
      }
    }
  }
  return surface;
}

}  // namespace

template <int Dim>
NodalAreas<Dim> paper_areas(const Points& points, const HeatProblem<Dim>& problem,
                            const HeatCoefficients<Dim>& coefficients, const NodalSums<Dim>& sums) {
  const Grid<Dim>& grid = problem.grid;
  const std::vector<unsigned char> surface = nodes_beside_free_cells(points, problem, sums);
  std::vector<double> area(surface.size(), 0.0);
  for (Index row = 0; row < points.size(); ++row) {
    with_shape(problem.shape, coefficients.half_width[points.body()[row]], [&](auto shape) {
      const Weights<Dim, decltype(shape)> weights(grid, shape,
                                                  points.position().data() + row * Dim);
      Vec<Dim> normal = Vec<Dim>::Zero();
      bool near = false;
      weights.for_each_node(grid, [&](Index node, double, const Vec<Dim>& slope) {
        normal -= sums.fraction[node] * slope;
        near = near || surface[node] != 0;
      });
      const double length = normal.norm() * grid.cell_size();
      if (!near || length < 1e-12) {
        return;
      }
      normal.normalize();
      weights.for_each_node(grid, [&](Index node, double, const Vec<Dim>& slope) {
        area[node] += points.volume()[row] * normal.dot(slope);
      });
    });
  }
  NodalAreas<Dim> areas;
  for (Index node = 0; node < grid.node_count(); ++node) {
    if (surface[node] != 0) {
      areas.node.push_back(node);
      areas.area.push_back(area[node]);
      const double length = sums.area_vector[node].norm();
      areas.normal.push_back(length > 0.0 ? Vec<Dim>(sums.area_vector[node] / length)
                                          : Vec<Dim>::Zero());
      areas.vector.push_back(area[node] * areas.normal.back());
      Vec3 position = Vec3::Zero();
      position.template head<Dim>() = grid.node_position(node);
      areas.position.push_back(position);
    }
  }
  areas.weight = areas.normal;
  areas.positive = areas.area;  // the paper keeps negative areas under every law
  return areas;
}

template <int Dim>
NodalAreas<Dim> face_areas(const Grid<Dim>& grid, const Points& points,
                           std::span<const unsigned char> outside) {
  struct Entry {
    double area = 0.0;
    Vec<Dim> normal = Vec<Dim>::Zero();
  };
  std::vector<unsigned char> occupied(static_cast<std::size_t>(grid.cell_count()), 0);
  for (Index row = 0; row < points.size(); ++row) {
    occupied[grid.cell_index(grid.cell_containing(points.position<Dim>(row)))] = 1;
  }
  std::map<Index, Entry> entries;
  const double share = std::pow(grid.cell_size(), Dim - 1) / (1 << (Dim - 1));
  for (Index cell = 0; cell < grid.cell_count(); ++cell) {
    if (occupied[cell] == 0) {
      continue;
    }
    const auto at = grid.cell_at(cell);
    for (int axis = 0; axis < Dim; ++axis) {
      for (const int side : {0, 1}) {
        if (outside[cell + (2 * side - 1) * grid.cell_stride(axis)] == 0) {
          continue;
        }
        for (int corner = 0; corner < (1 << Dim); ++corner) {
          if (((corner >> axis) & 1) != side) {
            continue;
          }
          auto node = at;
          for (int other = 0; other < Dim; ++other) {
            node[other] += (corner >> other) & 1;
          }
          Entry& entry = entries[grid.node_index(node)];
          entry.area += share;
          entry.normal[axis] += (2 * side - 1) * share;
        }
      }
    }
  }
  NodalAreas<Dim> areas;
  for (const auto& [node, entry] : entries) {
    areas.node.push_back(node);
    areas.area.push_back(entry.area);
    const double length = entry.normal.norm();
    areas.normal.push_back(length > 0.0 ? Vec<Dim>(entry.normal / length) : Vec<Dim>::Zero());
    areas.vector.push_back(entry.normal);
    Vec3 position = Vec3::Zero();
    position.template head<Dim>() = grid.node_position(node);
    areas.position.push_back(position);
  }
  areas.weight = areas.normal;
  areas.positive = areas.area;
  return areas;
}

#define LAPILLI_INSTANTIATE(Dim)                                                             \
  template class HeatSurface<Dim>;                                                           \
  template NodalAreas<Dim> paper_areas(const Points&, const HeatProblem<Dim>&,               \
                                       const HeatCoefficients<Dim>&, const NodalSums<Dim>&); \
  template NodalAreas<Dim> face_areas(const Grid<Dim>&, const Points&,                       \
                                      std::span<const unsigned char>);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
