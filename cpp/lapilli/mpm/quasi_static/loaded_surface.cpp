#include "lapilli/mpm/quasi_static/loaded_surface.hpp"

#include <Eigen/LU>
#include <optional>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/quasi_static/support_terms.hpp"

namespace lapilli {
namespace {

constexpr double behind = 1e-7;        // cells; a point on a face belongs to the cell behind it
constexpr double farthest_off = 0.75;  // cells, of a point from the cell whose functions it takes

/// Squared distance of a place (in cells) from a cell.
template <int Dim>
double squared_distance(const Vec<Dim>& at, const typename Grid<Dim>::Cell& cell) {
  double sum = 0.0;
  for (int axis = 0; axis < Dim; ++axis) {
    const double off = std::max({0.0, cell[axis] - at[axis], at[axis] - cell[axis] - 1.0});
    sum += off * off;
  }
  return sum;
}

/// The occupied cell nearest to a place (in cells) among the one it is in and its neighbours.
template <int Dim>
std::optional<typename Grid<Dim>::Cell> nearest_occupied(const Grid<Dim>& grid,
                                                         const CellState<Dim>& state,
                                                         const Vec<Dim>& at) {
  std::optional<typename Grid<Dim>::Cell> nearest;
  double least = farthest_off * farthest_off;
  int neighbours = 1;
  for (int axis = 0; axis < Dim; ++axis) {
    neighbours *= 3;
  }
  for (int k = 0; k < neighbours; ++k) {
    typename Grid<Dim>::Cell cell;
    int rest = k;
    bool inside = true;
    for (int axis = 0; axis < Dim; ++axis, rest /= 3) {
      cell[axis] = static_cast<int>(std::floor(at[axis])) + rest % 3 - 1;
      inside = inside && cell[axis] >= 0 && cell[axis] < grid.cells(axis);
    }
    if (!inside || !state.occupied[grid.cell_index(cell)]) {
      continue;
    }
    const double away = squared_distance<Dim>(at, cell);
    if (away < least) {
      least = away;
      nearest = cell;
    }
  }
  return nearest;
}

}  // namespace

template <int Dim>
void LoadedSurface<Dim>::start(const std::vector<Facet<Dim>>& facets) {
  points_.clear();
  for (const Facet<Dim>& facet : facets) {
    for (const SurfacePoint<Dim>& point : facet.points) {
      points_.push_back({point.position, point.weight * point.normal, facet.cell});
    }
  }
  now_ = points_;
}

template <int Dim>
void LoadedSurface<Dim>::find_cells(const Grid<Dim>& grid, const CellState<Dim>& state) {
  for (LoadedPoint<Dim>& point : points_) {
    const Vec<Dim> at = grid.local(point.position) + behind * point.area.normalized();
    const auto cell = nearest_occupied<Dim>(grid, state, at);
    if (!cell) {
      throw RunError(message(what_, " lies off the material at ", point.position.transpose(),
                             " m: end it where the body ends"));
    }
    point.cell = *cell;
  }
}

template <int Dim>
void LoadedSurface<Dim>::follow(const Grid<Dim>& grid, const NodeSystem<Dim>& system,
                                const Eigen::VectorXd& moved) {
  now_ = points_;
  for (LoadedPoint<Dim>& point : now_) {
    CellBox<Dim> box{point.cell, {}};
    box.cells.fill(1);
    double value[1 << Dim];
    Vec<Dim> gradient[1 << Dim];
    cell_shape<Dim>(grid, point.cell, point.position, value, gradient);
    Vec<Dim> move = Vec<Dim>::Zero();
    Mat<Dim> deformation = Mat<Dim>::Identity();
    for_each_node(grid, box, [&](int a, Index node) {
      const Vec<Dim> u = moved.segment<Dim>(Dim * system.row(node));
      move += value[a] * u;
      deformation += u * gradient[a].transpose();
    });
    point.position += move;
    point.area = deformation.determinant() * deformation.inverse().transpose() * point.area;
  }
}

template <int Dim>
double LoadedSurface<Dim>::area() const {
  double sum = 0.0;
  for (const LoadedPoint<Dim>& point : points_) {
    sum += point.area.norm();
  }
  return sum;
}

template <int Dim>
void LoadedSurface<Dim>::save(Archive& archive, const std::string& name) const {
  std::vector<double> numbers;
  for (const auto* list : {&points_, &now_}) {
    for (const LoadedPoint<Dim>& point : *list) {
      numbers.insert(numbers.end(), point.position.data(), point.position.data() + Dim);
      numbers.insert(numbers.end(), point.area.data(), point.area.data() + Dim);
    }
  }
  archive.write(name, std::span<const double>(numbers));
}

template <int Dim>
void LoadedSurface<Dim>::load(const Archive& archive, const std::string& name) {
  const std::vector<double> numbers = archive.read_numbers(name);
  const std::size_t count = numbers.size() / (4 * Dim);
  const double* from = numbers.data();
  for (auto* list : {&points_, &now_}) {
    list->assign(count, {});
    for (LoadedPoint<Dim>& point : *list) {
      point.position = Eigen::Map<const Vec<Dim>>(from);
      point.area = Eigen::Map<const Vec<Dim>>(from + Dim);
      from += 2 * Dim;
    }
  }
}

template class LoadedSurface<2>;
template class LoadedSurface<3>;

}  // namespace lapilli
