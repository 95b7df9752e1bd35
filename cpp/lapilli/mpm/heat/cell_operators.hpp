#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "lapilli/core/symmetric_modes.hpp"
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
      : grid_(grid), layout_(layout), shape_(shape), root_(square_root(conductivity)) {
    typename Grid<Dim>::Cell node;
    node.fill(Grid<Dim>::padding);
    int cubes = 1;
    for (int axis = 0; axis < Dim; ++axis) {
      cubes *= layout.per_axis;
    }
    for (int which = 0; which < cubes; ++which) {
      const auto points = gauss_points(cube_of<Dim>(grid, layout, node, which));
      integrate(node, points, true);
      full_volumes_.push_back(volumes);
      full_conduction_.push_back(conduction);
    }
    whole_volumes_.setZero();
    whole_conduction_.setZero();
    for (int which = 0; which < cubes; ++which) {
      whole_volumes_ += full_volumes_[which];
      whole_conduction_ += full_conduction_[which];
    }
  }

  /// Whether a cell lies inside as a whole.
  bool is_whole(const CellCut<Dim>& cell) const {
    return cell.full == (1U << full_volumes_.size()) - 1;
  }
  /// What a whole cell adds.
  const Volumes& whole_volumes() const { return whole_volumes_; }
  const Conduction& whole_conduction() const { return whole_conduction_; }

  /// Integrate over one cell; what it adds is in `volumes` and, where asked for, `conduction`.
  void integrate(const CellCut<Dim>& cell, bool with_conduction = true) {
    if (is_whole(cell)) {
      volumes = whole_volumes_;
      if (with_conduction) {
        conduction = whole_conduction_;
      }
      return;
    }
    integrate(cell.node, cell.points, with_conduction);
    for (std::size_t which = 0; which < full_volumes_.size(); ++which) {
      if ((cell.full >> which) & 1U) {
        volumes += full_volumes_[which];
        if (with_conduction) {
          conduction += full_conduction_[which];
        }
      }
    }
  }

  /// Conduction alone with another conductivity than that of the body.
  void integrate(const CellCut<Dim>& cell, const Mat<Dim>& conductivity) {
    std::vector<QuadraturePoint<Dim>> points = cell.points;
    for (std::size_t which = 0; which < full_volumes_.size(); ++which) {
      if ((cell.full >> which) & 1U) {
        const auto more =
            gauss_points(cube_of<Dim>(grid_, layout_, cell.node, static_cast<int>(which)));
        points.insert(points.end(), more.begin(), more.end());
      }
    }
    const Mat<Dim> own = std::exchange(root_, square_root(conductivity));
    integrate(cell.node, points, true);
    root_ = own;
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
  /// R with R^T R the conductivity, which may be none along some direction.
  static Mat<Dim> square_root(const Mat<Dim>& conductivity) {
    const Eigen::LLT<Mat<Dim>> factor(conductivity);
    if (factor.info() == Eigen::Success) {
      return factor.matrixU();
    }
    const SymmetricModes<Dim> modes = symmetric_modes<Dim>(conductivity);
    return modes.eigenvalues.cwiseMax(0.0).cwiseSqrt().asDiagonal() *
           modes.eigenvectors.transpose();
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
                 const std::vector<QuadraturePoint<Dim>>& points, bool with_conduction) {
    volumes.setZero();
    if (with_conduction) {
      conduction.setZero();
    }
    if (points.empty()) {
      return;
    }
    const auto first = first_node(node);
    slopes_.resize(static_cast<Eigen::Index>(with_conduction ? points.size() : 0) * Dim, nodes);
    Eigen::Index row = 0;
    for (const QuadraturePoint<Dim>& point : points) {
      Values values, slopes;
      for (int axis = 0; axis < Dim; ++axis) {
        const double at = (point.position[axis] - grid_.origin()[axis]) * grid_.inverse_cell_size();
        shape_.evaluate(at, first[axis], values[axis].data(), slopes[axis].data());
      }
      volumes += point.weight * product(values);
      if (with_conduction) {
        add_slopes(values, slopes, std::sqrt(point.weight) * grid_.inverse_cell_size(), row);
        row += Dim;
      }
    }
    if (with_conduction) {
      conduction.noalias() = slopes_.transpose() * slopes_;
    }
  }

  using Values = std::array<std::array<double, support>, Dim>;

  static Volumes product(const Values& values) {
    Volumes all;
    for (int local = 0; local < nodes; ++local) {
      double one = 1.0;
      for (int axis = 0, rest = local; axis < Dim; ++axis, rest /= support) {
        one *= values[axis][rest % support];
      }
      all[local] = one;
    }
    return all;
  }

  void add_slopes(const Values& values, const Values& slopes, double factor, Eigen::Index row) {
    Eigen::Matrix<double, Dim, nodes> gradient;
    for (int axis = 0; axis < Dim; ++axis) {
      Values along = values;
      along[axis] = slopes[axis];
      gradient.row(axis) = factor * product(along).transpose();
    }
    slopes_.template middleRows<Dim>(row) = root_ * gradient;
  }

  const Grid<Dim>& grid_;
  CubeLayout layout_;
  Function shape_;
  Mat<Dim> root_;
  std::vector<Volumes> full_volumes_;
  std::vector<Conduction> full_conduction_;
  Volumes whole_volumes_;
  Conduction whole_conduction_;
  Eigen::Matrix<double, Eigen::Dynamic, nodes> slopes_;
};

}  // namespace lapilli
