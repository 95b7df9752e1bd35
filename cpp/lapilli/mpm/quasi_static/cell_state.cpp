#include "lapilli/mpm/quasi_static/cell_state.hpp"

#include <algorithm>

namespace lapilli {
namespace {

template <int Dim>
bool at_edge(const Grid<Dim>& grid, const std::vector<char>& occupied, Index cell) {
  for (int axis = 0; axis < Dim; ++axis) {
    const Index stride = grid.cell_stride(axis);
    if (!occupied[cell - stride] || !occupied[cell + stride]) {
      return true;
    }
  }
  return false;
}

}  // namespace

template <int Dim>
CellState<Dim>::CellState(const Grid<Dim>& grid, std::span<const double> volume_of,
                          std::span<const Index> body, const PointWeights<Dim>& weights,
                          std::span<const LinearElastic> materials)
    : occupied(grid.cell_count(), 0),
      lame(grid.cell_count(), 0.0),
      shear(grid.cell_count(), 0.0),
      youngs(grid.cell_count(), 0.0) {
  std::vector<double> volume(grid.cell_count(), 0.0);
  for (Index p : weights.order()) {
    const LinearElastic& material = materials[body[p]];
    const double v = volume_of[p];
    for_each_cell(grid, weights.box(p), [&](Index cell) {
      occupied[cell] = 1;
      volume[cell] += v;
      lame[cell] += v * material.lambda();
      shear[cell] += v * material.shear_modulus();
      youngs[cell] += v * material.youngs_modulus;
    });
  }
  for (Index cell = 0; cell < grid.cell_count(); ++cell) {
    if (occupied[cell]) {
      lame[cell] /= volume[cell];
      shear[cell] /= volume[cell];
      youngs[cell] /= volume[cell];
    }
  }
}

template <int Dim>
std::vector<char> cells_near_material(const Grid<Dim>& grid, const CellState<Dim>& state) {
  std::vector<char> near = state.occupied;
  for (int axis = 0; axis < Dim; ++axis) {
    const std::vector<char> before = near;
    const Index stride = grid.cell_stride(axis);
    for (Index cell = stride; cell + stride < grid.cell_count(); ++cell) {
      near[cell] = before[cell] || before[cell - stride] || before[cell + stride];
    }
  }
  return near;
}

template <int Dim>
Index inner_cell(const Grid<Dim>& grid, const Facet<Dim>& facet) {
  constexpr double look_in = 0.75;  // cells
  return grid.cell_index(
      grid.cell_containing(facet.centre() + look_in * grid.cell_size() * facet.normal()));
}

namespace {

/// Of the cells marked, those that a chain of common faces leads to from the material: ghost
/// stabilisation acts across faces, and nothing else holds the nodes of an empty cell that touches
/// the material with an edge only.
template <int Dim>
std::vector<char> reached_from_material(const Grid<Dim>& grid, const std::vector<char>& occupied,
                                        const std::vector<char>& marked) {
  std::vector<char> reached(marked.size(), 0);
  std::vector<Index> to_visit;
  const auto visit_neighbours = [&](Index cell) {
    for (int axis = 0; axis < Dim; ++axis) {
      for (const Index step : {-grid.cell_stride(axis), grid.cell_stride(axis)}) {
        const Index next = cell + step;
        if (next >= 0 && next < grid.cell_count() && marked[next] && !reached[next]) {
          reached[next] = 1;
          to_visit.push_back(next);
        }
      }
    }
  };
  for (Index cell = 0; cell < grid.cell_count(); ++cell) {
    if (occupied[cell]) {
      visit_neighbours(cell);
    }
  }
  while (!to_visit.empty()) {
    const Index cell = to_visit.back();
    to_visit.pop_back();
    visit_neighbours(cell);
  }
  return reached;
}

}  // namespace

template <int Dim>
std::vector<Facet<Dim>> facets_at_material(const Grid<Dim>& grid, CellState<Dim>& state,
                                           std::vector<Facet<Dim>> facets, bool hold_empty_cells) {
  std::vector<char> empty(static_cast<std::size_t>(grid.cell_count()), 0);
  std::erase_if(facets, [&](const Facet<Dim>& facet) {
    const Index cell = grid.cell_index(facet.cell);
    if (state.occupied[cell]) {
      return false;
    }
    if (!hold_empty_cells) {
      return true;
    }
    const Index inner = inner_cell(grid, facet);
    if (inner < 0 || inner >= grid.cell_count() || !state.occupied[inner]) {
      return true;
    }
    state.lame[cell] = state.lame[inner];
    state.shear[cell] = state.shear[inner];
    state.youngs[cell] = state.youngs[inner];
    empty[cell] = 1;
    return false;
  });
  if (hold_empty_cells) {
    const std::vector<char> reached = reached_from_material(grid, state.occupied, empty);
    std::erase_if(facets, [&](const Facet<Dim>& facet) {
      const Index cell = grid.cell_index(facet.cell);
      return empty[cell] && !reached[cell];
    });
  }
  return facets;
}

template <int Dim>
std::array<std::vector<CellBox<Dim>>, Dim> ghost_pairs(const Grid<Dim>& grid,
                                                       const CellState<Dim>& state,
                                                       std::span<const Facet<Dim>> facets) {
  enum : char { none = 0, active = 1, cut = 2 };
  std::vector<char> kind(grid.cell_count(), none);
  for (Index cell = 0; cell < grid.cell_count(); ++cell) {
    if (state.occupied[cell]) {
      kind[cell] = at_edge(grid, state.occupied, cell) ? cut : active;
    }
  }
  for (const Facet<Dim>& facet : facets) {
    kind[grid.cell_index(facet.cell)] = cut;
  }
  std::array<std::vector<CellBox<Dim>>, Dim> pairs;
  for (int axis = 0; axis < Dim; ++axis) {
    const Index stride = grid.cell_stride(axis);
    for (Index cell = 0; cell + stride < grid.cell_count(); ++cell) {
      if (kind[cell] && kind[cell + stride] && (kind[cell] == cut || kind[cell + stride] == cut)) {
        CellBox<Dim> box{grid.cell_at(cell), {}};
        box.cells.fill(1);
        box.cells[axis] = 2;
        pairs[axis].push_back(box);
      }
    }
  }
  return pairs;
}

template struct CellState<2>;
template struct CellState<3>;
template std::vector<char> cells_near_material(const Grid<2>&, const CellState<2>&);
template std::vector<char> cells_near_material(const Grid<3>&, const CellState<3>&);
template Index inner_cell(const Grid<2>&, const Facet<2>&);
template Index inner_cell(const Grid<3>&, const Facet<3>&);
template std::vector<Facet<2>> facets_at_material(const Grid<2>&, CellState<2>&,
                                                  std::vector<Facet<2>>, bool);
template std::vector<Facet<3>> facets_at_material(const Grid<3>&, CellState<3>&,
                                                  std::vector<Facet<3>>, bool);
template std::array<std::vector<CellBox<2>>, 2> ghost_pairs<2>(const Grid<2>&, const CellState<2>&,
                                                               std::span<const Facet<2>>);
template std::array<std::vector<CellBox<3>>, 3> ghost_pairs<3>(const Grid<3>&, const CellState<3>&,
                                                               std::span<const Facet<3>>);

}  // namespace lapilli
