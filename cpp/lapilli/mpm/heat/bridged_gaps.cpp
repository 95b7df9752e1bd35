#include "lapilli/mpm/heat/bridged_gaps.hpp"

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/mpm/surface/narrow_gap.hpp"

namespace lapilli {
namespace {

/// Cells that have a node of the part at a corner.
template <int Dim>
std::vector<char> cells_of(const Grid<Dim>& grid, const NodeRows<Dim>& rows) {
  std::vector<char> cells(static_cast<std::size_t>(grid.cell_count()), 0);
  for (const auto& row : rows.rows()) {
    for (int i = row.begin; i < row.end; ++i) {
      const auto node = grid.node_at(row.grid_row * grid.nodes(0) + i);
      for (int corner = 0; corner < 1 << Dim; ++corner) {
        auto cell = node;
        bool inside = true;
        for (int axis = 0; axis < Dim; ++axis) {
          cell[axis] -= corner >> axis & 1;
          inside = inside && cell[axis] >= 0 && cell[axis] < grid.cells(axis);
        }
        if (inside) {
          cells[grid.cell_index(cell)] = 1;
        }
      }
    }
  }
  return cells;
}

}  // namespace

template <int Dim>
std::vector<Note> bridged_gaps(const HeatProblem<Dim>& problem, const HeatPart<Dim>& part) {
  std::vector<Note> all;
  if constexpr (Dim > 1) {
    std::vector<Shape> shapes;
    for (const std::size_t body : part.bodies) {
      if (!problem.bodies[body].shape) {
        return {};
      }
      shapes.push_back(*problem.bodies[body].shape);
    }
    const std::vector<char> cells = cells_of(problem.grid, *part.rows);
    if (const auto gap = narrowest_gap<Dim>(problem.grid, cells, shapes)) {
      all.push_back(note("heat.bridged-gap", "heat: ", gap->in_words(Dim)));
    }
  }
  return all;
}

template std::vector<Note> bridged_gaps(const HeatProblem<1>&, const HeatPart<1>&);
template std::vector<Note> bridged_gaps(const HeatProblem<2>&, const HeatPart<2>&);
template std::vector<Note> bridged_gaps(const HeatProblem<3>&, const HeatPart<3>&);

}  // namespace lapilli
