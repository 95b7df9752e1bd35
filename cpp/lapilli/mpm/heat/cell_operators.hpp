#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <array>
#include <vector>

#include "lapilli/mpm/surface/cut_shape.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {

/// What one cell of a body adds to the nodes around it: their volumes, integral of S (m^dim), and
/// the conduction between them, integral of grad S . k grad S (W/K).
template <int Dim, class Function>
class CellOperators {
 public:
  static constexpr int support = Function::support;
  static constexpr int nodes = Weights<Dim, Function>::nodes;
  using Volumes = Eigen::Matrix<double, nodes, 1>;
  using Conduction = Eigen::Matrix<double, nodes, nodes>;

  CellOperators(const Grid<Dim>& grid, const CubeLayout& layout, const Function& shape,
                const Mat<Dim>& conductivity)
      : grid_(grid), shape_(shape), root_(square_root(conductivity)) {
    typename Grid<Dim>::Cell node;
    node.fill(Grid<Dim>::padding);
    int cubes = 1;
    for (int axis = 0; axis < Dim; ++axis) {
      cubes *= layout.per_axis;
    }
    for (int which = 0; which < cubes; ++which) {
      const auto points = gauss_points(cube_of<Dim>(grid, layout, node, which));
      integrate(node, points);
      full_volumes_.push_back(volumes);
      full_conduction_.push_back(conduction);
    }
  }

  /// Integrate over one cell; what it adds is in `volumes` and `conduction`.
  void integrate(const CellCut<Dim>& cell) {
    integrate(cell.node, cell.points);
    for (std::size_t which = 0; which < full_volumes_.size(); ++which) {
      if ((cell.full >> which) & 1U) {
        volumes += full_volumes_[which];
        conduction += full_conduction_[which];
      }
    }
  }

  /// The lowest node around the cell of a node.
  typename Grid<Dim>::Cell first_node(typename Grid<Dim>::Cell node) const {
    for (int& at : node) {
      at -= support == 3 ? 1 : 0;
    }
    return node;
  }
  /// Steps from it to a node around, first axis fastest.
  static std::array<int, Dim> steps(int local) {
    std::array<int, Dim> step;
    for (int axis = 0; axis < Dim; ++axis, local /= support) {
      step[axis] = local % support;
    }
    return step;
  }

  Volumes volumes;
  Conduction conduction;

 private:
  static Mat<Dim> square_root(const Mat<Dim>& conductivity) {
    return Eigen::LLT<Mat<Dim>>(conductivity).matrixL().toDenseMatrix().transpose();
  }

  static std::vector<QuadraturePoint<Dim>> gauss_points(const Cube<Dim>& cube) {
    constexpr double place[] = {0.11270166537925831, 0.5, 0.88729833462074169};
    constexpr double weight[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
    std::vector<QuadraturePoint<Dim>> points;
    const int count = Dim == 1 ? 3 : Dim == 2 ? 9 : 27;
    for (int k = 0; k < count; ++k) {
      QuadraturePoint<Dim> point{cube.low, 1.0};
      for (int axis = 0, rest = k; axis < Dim; ++axis, rest /= 3) {
        point.position[axis] += place[rest % 3] * cube.side;
        point.weight *= weight[rest % 3] * cube.side;
      }
      points.push_back(point);
    }
    return points;
  }

  void integrate(const typename Grid<Dim>::Cell& node,
                 const std::vector<QuadraturePoint<Dim>>& points) {
    volumes.setZero();
    conduction.setZero();
    if (points.empty()) {
      return;
    }
    const auto first = first_node(node);
    slopes_.resize(static_cast<Eigen::Index>(points.size()) * Dim, nodes);
    Eigen::Index row = 0;
    for (const QuadraturePoint<Dim>& point : points) {
      double value[Dim][support], slope[Dim][support];
      for (int axis = 0; axis < Dim; ++axis) {
        const double at = (point.position[axis] - grid_.origin()[axis]) * grid_.inverse_cell_size();
        shape_.evaluate(at, first[axis], value[axis], slope[axis]);
      }
      const double weight = std::sqrt(point.weight);
      for (int local = 0; local < nodes; ++local) {
        const auto step = steps(local);
        double product = 1.0;
        Vec<Dim> gradient = Vec<Dim>::Constant(grid_.inverse_cell_size());
        for (int axis = 0; axis < Dim; ++axis) {
          product *= value[axis][step[axis]];
          for (int other = 0; other < Dim; ++other) {
            gradient[other] *= other == axis ? slope[axis][step[axis]] : value[axis][step[axis]];
          }
        }
        volumes[local] += point.weight * product;
        slopes_.template block<Dim, 1>(row, local) = weight * (root_ * gradient);
      }
      row += Dim;
    }
    conduction.noalias() = slopes_.transpose() * slopes_;
  }

  const Grid<Dim>& grid_;
  Function shape_;
  Mat<Dim> root_;
  std::vector<Volumes> full_volumes_;
  std::vector<Conduction> full_conduction_;
  Eigen::Matrix<double, Eigen::Dynamic, nodes> slopes_;
};

}  // namespace lapilli
