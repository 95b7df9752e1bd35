#include "lapilli/mpm/quasi_static/equilibrium.hpp"

#include <algorithm>
#include <limits>

#include "lapilli/core/parallel.hpp"

namespace lapilli {
template <int Dim>
Equilibrium<Dim>::Equilibrium(const Grid<Dim>& grid, const Points& points,
                              const PointWeights<Dim>& weights, const CellState<Dim>& state,
                              std::span<const LinearElastic> materials,
                              std::span<const double> stress, const Loads<Dim>& loads,
                              NodeSystem<Dim>& system, DirectSolver& solver)
    : grid_(grid),
      points_(points),
      weights_(weights),
      state_(state),
      materials_(materials),
      stress_(stress),
      loads_(loads),
      system_(system),
      solver_(solver) {
  for (int axis = 0; axis < Dim; ++axis) {
    ghost_matrix_[axis] = ghost_matrix<Dim>(axis, grid.cell_size());
  }
  lay_out();
  external_force();
}

template <int Dim>
void Equilibrium<Dim>::lay_out() {
  std::vector<CellBox<Dim>> boxes;
  for (const auto& group : weights_.groups()) {
    boxes.push_back(group.box);
  }
  for (const WallTerm<Dim>& wall : loads_.walls) {
    boxes.push_back(wall.box);
  }
  if (loads_.ghost > 0.0) {
    for (const auto& pairs : loads_.ghost_pairs) {
      boxes.insert(boxes.end(), pairs.begin(), pairs.end());
    }
  }
  if (system_.lay_out(grid_, std::move(boxes))) {
    solver_.analyse(system_.lower(), system_.part_start());
  }
}

template <int Dim>
void Equilibrium<Dim>::external_force() {
  external_ = Eigen::VectorXd::Zero(system_.unknowns());
  if (!loads_.body_force.empty()) {
    weights_.for_each_group([&](const typename PointWeights<Dim>::Group& group) {
      for (Index k = group.begin; k < group.end; ++k) {
        const Index p = weights_.order()[k];
        const Vec<Dim> load = points_.volume()[p] * loads_.body_force[p];
        const double* value = weights_.value(p);
        for_each_node(grid_, group.box, [&](int a, Index node) {
          external_.segment<Dim>(Dim * system_.row(node)) += value[a] * load;
        });
      }
    });
  }
  for (std::size_t f = 0; f < loads_.traction_faces.size(); ++f) {
    const Facet<Dim>& facet = loads_.traction_faces[f];
    CellBox<Dim> box{facet.cell, {}};
    box.cells.fill(1);
    for (std::size_t q = 0; q < facet.points.size(); ++q) {
      double value[1 << Dim];
      Vec<Dim> gradient[1 << Dim];
      cell_shape<Dim>(grid_, facet.cell, facet.points[q].position, value, gradient);
      for_each_node(grid_, box, [&](int a, Index node) {
        if (system_.row(node) >= 0) {
          external_.segment<Dim>(Dim * system_.row(node)) +=
              facet.points[q].weight * value[a] * loads_.tractions[f][q];
        }
      });
    }
  }
}

template <int Dim>
SymmetricTensor Equilibrium<Dim>::strain(Index point, const Eigen::VectorXd& u) const {
  const Vec<Dim>* gradient = weights_.gradient(point);
  Mat3 slope = Mat3::Zero();
  for_each_node(grid_, weights_.box(point), [&](int a, Index node) {
    slope.topLeftCorner<Dim, Dim>() +=
        u.segment<Dim>(Dim * system_.row(node)) * gradient[a].transpose();
  });
  return symmetric_part(slope);
}

template <int Dim>
Vec<Dim> Equilibrium<Dim>::displacement(Index point, const Eigen::VectorXd& u) const {
  const double* value = weights_.value(point);
  Vec<Dim> sum = Vec<Dim>::Zero();
  for_each_node(grid_, weights_.box(point), [&](int a, Index node) {
    sum += value[a] * u.segment<Dim>(Dim * system_.row(node));
  });
  return sum;
}

template <int Dim>
void Equilibrium<Dim>::add_internal_force(const Eigen::VectorXd& u, Eigen::VectorXd& force) const {
  weights_.for_each_group([&](const typename PointWeights<Dim>::Group& group) {
    for (Index k = group.begin; k < group.end; ++k) {
      const Index p = weights_.order()[k];
      SymmetricTensor stress = stress_of(materials_[points_.body()[p]], strain(p, u));
      for (int c = 0; c < 6; ++c) {
        stress[c] += stress_[6 * p + c];
      }
      const Mat<Dim> load = points_.volume()[p] * stress.template block<Dim>();
      const Vec<Dim>* gradient = weights_.gradient(p);
      for_each_node(grid_, group.box, [&](int a, Index node) {
        force.segment<Dim>(Dim * system_.row(node)) += load * gradient[a];
      });
    }
  });
}

template <int Dim>
Imbalance Equilibrium<Dim>::residual(const Eigen::VectorXd& u) const {
  Eigen::VectorXd internal = Eigen::VectorXd::Zero(system_.unknowns());
  add_internal_force(u, internal);
  const Eigen::VectorXd held_back = total(u);
  double reference = std::max(external_.squaredNorm(), internal.squaredNorm());
  double wall_square = 0.0, rounding_square = 0.0;
  const auto gather = [&](const CellBox<Dim>& box) {
    Eigen::VectorXd local(Dim * box.node_count());
    for_each_node(grid_, box, [&](int a, Index node) {
      local.segment<Dim>(Dim * a) = held_back.segment<Dim>(Dim * system_.row(node));
    });
    return local;
  };
  const auto scatter = [&](const CellBox<Dim>& box, const Eigen::VectorXd& local) {
    for_each_node(grid_, box, [&](int a, Index node) {
      internal.segment<Dim>(Dim * system_.row(node)) += local.segment<Dim>(Dim * a);
    });
  };
  for (const WallTerm<Dim>& wall : loads_.walls) {
    const Eigen::VectorXd local = gather(wall.box);
    const Eigen::VectorXd held = wall.matrix * local;
    rounding_square += (wall.matrix.cwiseAbs() * local.cwiseAbs()).squaredNorm();
    wall_square += held.squaredNorm() + wall.force.squaredNorm();
    scatter(wall.box, held - wall.force);
  }
  if (loads_.ghost > 0.0) {
    for (int axis = 0; axis < Dim; ++axis) {
      for (const CellBox<Dim>& pair : loads_.ghost_pairs[axis]) {
        const Eigen::VectorXd local = gather(pair);
        const Eigen::Map<const Eigen::Matrix<double, Dim, Eigen::Dynamic>> values(
            local.data(), Dim, pair.node_count());
        const Eigen::Matrix<double, Dim, Eigen::Dynamic> resisted =
            ghost_stiffness(pair, axis) * values * ghost_matrix_[axis];
        scatter(pair, Eigen::Map<const Eigen::VectorXd>(resisted.data(), resisted.size()));
      }
    }
  }
  Imbalance imbalance{external_ - internal, std::sqrt(std::max(reference, wall_square)),
                      std::numeric_limits<double>::epsilon() * std::sqrt(rounding_square)};
  if (loads_.carried.size() > 0) {
    imbalance.force -= loads_.carried;
  }
  for (Index k = 0; k < imbalance.force.size(); ++k) {
    if (system_.is_dropped(k)) {
      imbalance.force[k] = 0.0;
    }
  }
  return imbalance;
}

template <int Dim>
std::vector<Vec<Dim>> Equilibrium<Dim>::wall_forces(const Eigen::VectorXd& u, int walls) const {
  std::vector<Vec<Dim>> forces(walls, Vec<Dim>::Zero());
  const Eigen::VectorXd held_back = total(u);
  for (const WallTerm<Dim>& wall : loads_.walls) {
    Vec<Dim>& force = forces[wall.wall];
    for_each_node(grid_, wall.box, [&](int a, Index node) {
      force -= wall.reaction.template middleCols<Dim>(Dim * a) *
               held_back.segment<Dim>(Dim * system_.row(node));
    });
    force += wall.given;
  }
  return forces;
}

template class Equilibrium<2>;
template class Equilibrium<3>;

}  // namespace lapilli
