#include "lapilli/mpm/quasi_static/reference.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lapilli {
namespace {

std::span<const double> numbers(const Eigen::VectorXd& vector) {
  return {vector.data(), static_cast<std::size_t>(vector.size())};
}

Eigen::VectorXd vector_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Index>(numbers.size()));
}

}  // namespace

template <int Dim>
Reference<Dim>::Reference(Points& points, bool gimp)
    : position(points, Dim),
      half_width(gimp ? std::make_unique<PointArray>(points, Dim) : nullptr) {}

template <int Dim>
void Reference<Dim>::start(const Points& points, const PointArray* now, double at) {
  std::copy_n(points.position().data(), points.position().size(), position.data());
  if (half_width) {
    std::copy_n(now->data(), now->values().size(), half_width->data());
  }
  time = at;
  moved.resize(0);
  imbalance.resize(0);
}

template <int Dim>
void Reference<Dim>::locate(const Grid<Dim>& grid, const Points& points,
                            std::span<const LinearElastic> materials,
                            const Boundary<Dim>& boundary) {
  located = factorised = false;
  weights.build(grid, std::as_const(position).values(),
                half_width ? std::as_const(*half_width).values() : std::span<const double>());
  state = std::make_unique<CellState<Dim>>(grid, points, weights, materials);
  facets = boundary.cut_walls(grid, *state, time);
  located = true;
}

template <int Dim>
double Reference<Dim>::farthest(const Points& points, const std::vector<Vec<Dim>>& moves) const {
  double most = 0.0;
  for (Index p = 0; p < points.size(); ++p) {
    for (int axis = 0; axis < Dim; ++axis) {
      const Index k = Dim * p + axis;
      const double to = points.position()[k] + (moves.empty() ? 0.0 : moves[p][axis]);
      most = std::max(most, std::abs(to - position[k]));
    }
  }
  return most;
}

template <int Dim>
void Reference<Dim>::save(Archive& archive) const {
  archive.write("quasi_static/reference/time", time);
  archive.write("quasi_static/reference/pointwise", scheme.pointwise);
  archive.write("quasi_static/reference/moved", numbers(moved));
  archive.write("quasi_static/reference/imbalance", numbers(imbalance));
  archive.write("quasi_static/reference/imbalance_due", imbalance_due ? 1.0 : 0.0);
  archive.write("quasi_static/reference/position", position.values());
  std::vector<double> forces;
  for (const Vec<Dim>& force : wall_forces) {
    forces.insert(forces.end(), force.data(), force.data() + Dim);
  }
  archive.write("quasi_static/reference/wall_forces", std::span<const double>(forces));
  if (half_width) {
    archive.write("quasi_static/reference/half_width", std::as_const(*half_width).values());
  }
}

template <int Dim>
void Reference<Dim>::load(const Archive& archive) {
  time = archive.read_number("quasi_static/reference/time");
  scheme.pointwise = archive.read_number("quasi_static/reference/pointwise");
  moved = vector_of(archive.read_numbers("quasi_static/reference/moved"));
  imbalance = vector_of(archive.read_numbers("quasi_static/reference/imbalance"));
  imbalance_due = archive.read_number("quasi_static/reference/imbalance_due") > 0.0;
  archive.read("quasi_static/reference/position", position.values());
  const std::vector<double> forces = archive.read_numbers("quasi_static/reference/wall_forces");
  wall_forces.resize(forces.size() / Dim);
  for (std::size_t w = 0; w < wall_forces.size(); ++w) {
    wall_forces[w] = Eigen::Map<const Vec<Dim>>(forces.data() + Dim * w);
  }
  if (half_width) {
    archive.read("quasi_static/reference/half_width", half_width->values());
  }
}

template struct Reference<2>;
template struct Reference<3>;

}  // namespace lapilli
