#pragma once

#include <string>
#include <vector>

#include "lapilli/algebra/node_system.hpp"
#include "lapilli/core/archive.hpp"
#include "lapilli/mpm/quasi_static/cell_state.hpp"

namespace lapilli {

/// A point of integration of a surface under load.
template <int Dim>
struct LoadedPoint {
  Vec<Dim> position;              // m
  Vec<Dim> area;                  // m^(Dim-1), along the normal into the material
  typename Grid<Dim>::Cell cell;  // whose shape functions, continued beyond it, spread its force
};

/// The surface a traction acts on, as points of integration that the material carries along: they
/// move with it, and their areas turn and stretch (Nanson).
template <int Dim>
class LoadedSurface {
 public:
  explicit LoadedSurface(std::string what) : what_(std::move(what)) {}

  void start(const std::vector<Facet<Dim>>& facets);
  /// Give each point the cell it is in, or the nearest that holds material where it is in none.
  /// Throws RunError for points further than three quarters of a cell away from every such cell.
  void find_cells(const Grid<Dim>& grid, const CellState<Dim>& state);
  /// Where the points are once the unknowns have moved by `moved` since the last reset.
  void follow(const Grid<Dim>& grid, const NodeSystem<Dim>& system, const Eigen::VectorXd& moved);
  /// Start anew from there.
  void reset() { points_ = now_; }

  const std::string& what() const { return what_; }
  const std::vector<LoadedPoint<Dim>>& points() const { return points_; }
  double area() const;  // m^(Dim-1)

  void save(Archive& archive, const std::string& name) const;
  void load(const Archive& archive, const std::string& name);

 private:
  std::string what_;
  std::vector<LoadedPoint<Dim>> points_, now_;
};

}  // namespace lapilli
