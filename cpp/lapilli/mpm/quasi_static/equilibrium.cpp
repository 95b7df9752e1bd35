#include "lapilli/mpm/quasi_static/equilibrium.hpp"

#include <algorithm>
#include <limits>

#include "lapilli/core/parallel.hpp"

namespace lapilli {
template <int Dim>
Equilibrium<Dim>::Equilibrium(const Grid<Dim>& grid, std::span<const double> volume,
                              std::span<const Index> body, const PointWeights<Dim>& weights,
                              const CellState<Dim>& state, const SolidState& solids,
                              const Loads<Dim>& loads, NodeSystem<Dim>& system,
                              DirectSolver& solver)
    : grid_(grid),
      volume_(volume),
      body_(body),
      weights_(weights),
      state_(state),
      solids_(solids),
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
  for (const SupportTerm<Dim>& wall : loads_.walls) {
    boxes.push_back(wall.box);
  }
  for (const JointGap<Dim>& joint : loads_.joint_gaps) {
    boxes.push_back(joint.box);
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
template <class Add>
void Equilibrium<Dim>::spread(const SurfaceForce<Dim>& load, const Add& add) const {
  CellBox<Dim> box{load.cell, {}};
  box.cells.fill(1);
  double value[1 << Dim];
  Vec<Dim> gradient[1 << Dim];
  cell_shape<Dim>(grid_, load.cell, load.position, value, gradient);
  for_each_node(grid_, box, [&](int a, Index node) {
    add(Dim * system_.row(node), Vec<Dim>(value[a] * load.force));
  });
}

template <int Dim>
void Equilibrium<Dim>::external_force() {
  external_ = Eigen::VectorXd::Zero(system_.unknowns());
  if (!loads_.body_force.empty()) {
    weights_.for_each_group([&](const typename PointWeights<Dim>::Group& group) {
      for (Index k = group.begin; k < group.end; ++k) {
        const Index p = weights_.order()[k];
        const Vec<Dim> load = volume_[p] * loads_.body_force[p];
        const double* value = weights_.value(p);
        const Vec<Dim>* gradient = weights_.gradient(p);
        const Vec<Dim>* mean = state_.mean.of_point(p);
        const double linear_pressure = load.dot(state_.mean.arm(p));
        const double even_pressure =
            mean != nullptr && loads_.hydrostatic
                ? volume_[p] * loads_.hydrostatic->at(state_.mean.middle(p))
                : 0.0;
        for_each_node(grid_, group.box, [&](int a, Index node) {
          Vec<Dim> on_node = value[a] * load;
          if (mean != nullptr) {
            on_node += linear_pressure * (gradient[a] - mean[a]) - even_pressure * mean[a];
          }
          external_.segment<Dim>(Dim * system_.row(node)) += on_node;
        });
      }
    });
  }
  for (const SurfaceForce<Dim>& load : loads_.surface_forces) {
    spread(load, [&](Index row, const Vec<Dim>& force) { external_.segment<Dim>(row) += force; });
  }
  for (const SurfaceForce<Dim>& load : loads_.skin_forces) {
    spread(load, [&](Index row, const Vec<Dim>& force) { external_.segment<Dim>(row) += force; });
  }
}

template <int Dim>
SymmetricTensor Equilibrium<Dim>::strain(Index point, const Eigen::VectorXd& u) const {
  const Vec<Dim>* gradient = weights_.gradient(point);
  const Vec<Dim>* mean = state_.mean.of_point(point);
  Mat3 slope = Mat3::Zero();
  double added = 0.0;  // dilatation of the cell minus that of the point
  for_each_node(grid_, weights_.box(point), [&](int a, Index node) {
    const Vec<Dim> move = u.segment<Dim>(Dim * system_.row(node));
    slope.topLeftCorner<Dim, Dim>() += move * gradient[a].transpose();
    added += mean != nullptr ? move.dot(mean[a] - gradient[a]) : 0.0;
  });
  slope.diagonal().template head<Dim>().array() += added / Dim;
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

/// Forces of the points. What cancels in the strain of a nearly rigid point is as large as its
/// stiffness times the displacement.
template <int Dim>
void Equilibrium<Dim>::add_internal_force(const Eigen::VectorXd& u, Eigen::VectorXd& force,
                                          Eigen::VectorXd& cancelled) const {
  weights_.for_each_group([&](const typename PointWeights<Dim>::Group& group) {
    for (Index k = group.begin; k < group.end; ++k) {
      const Index p = weights_.order()[k];
      const SymmetricTensor stress = solids_.stress_after(p, body_[p], strain(p, u));
      const double held = solids_.largest_stress(p);
      const Mat<Dim> load = volume_[p] * stress.template block<Dim>();
      const double pressure = volume_[p] * stress.template block<Dim>().trace() / Dim;
      const Vec<Dim>* gradient = weights_.gradient(p);
      const Vec<Dim>* mean = state_.mean.of_point(p);
      double turned = 0.0;
      for_each_node(grid_, group.box, [&](int a, Index node) {
        turned += gradient[a].norm() * u.segment<Dim>(Dim * system_.row(node)).norm();
      });
      const double size = volume_[p] * (held + solids_.elastic(body_[p]).wave_modulus() * turned);
      for_each_node(grid_, group.box, [&](int a, Index node) {
        Vec<Dim> on_node = load * gradient[a];
        if (mean != nullptr) {
          on_node += pressure * (mean[a] - gradient[a]);
        }
        const Index row = Dim * system_.row(node);
        force.segment<Dim>(row) += on_node;
        cancelled.segment<Dim>(row).array() += size * gradient[a].norm();
      });
    }
  });
}

template <int Dim>
Eigen::VectorXd Equilibrium<Dim>::gather(const CellBox<Dim>& box,
                                         const Eigen::VectorXd& from) const {
  Eigen::VectorXd local(Dim * box.node_count());
  for_each_node(grid_, box, [&](int a, Index node) {
    local.segment<Dim>(Dim * a) = from.segment<Dim>(Dim * system_.row(node));
  });
  return local;
}

template <int Dim>
void Equilibrium<Dim>::scatter(const CellBox<Dim>& box, const Eigen::VectorXd& local,
                               Eigen::VectorXd& to) const {
  for_each_node(grid_, box, [&](int a, Index node) {
    to.segment<Dim>(Dim * system_.row(node)) += local.segment<Dim>(Dim * a);
  });
}

template <int Dim>
void Equilibrium<Dim>::add_walls(const Eigen::VectorXd& held_back, Eigen::VectorXd& internal,
                                 Eigen::VectorXd& cancelled, double& wall_square) const {
  for (const SupportTerm<Dim>& wall : loads_.walls) {
    const Eigen::VectorXd local = gather(wall.box, held_back);
    const Eigen::VectorXd held = wall.matrix * local;
    wall_square += held.squaredNorm() + wall.force.squaredNorm();
    scatter(wall.box, held - wall.force, internal);
    scatter(wall.box, wall.matrix.cwiseAbs() * local.cwiseAbs() + wall.force.cwiseAbs(), cancelled);
  }
  for (const JointGap<Dim>& joint : loads_.joint_gaps) {
    const Eigen::VectorXd local = gather(joint.box, held_back);
    const Eigen::VectorXd given = joint.force(local);
    wall_square += given.squaredNorm();
    scatter(joint.box, -given, internal);
    scatter(joint.box, joint.sizes(local), cancelled);
  }
}

template <int Dim>
Imbalance Equilibrium<Dim>::residual(const Eigen::VectorXd& u) const {
  Eigen::VectorXd internal = Eigen::VectorXd::Zero(system_.unknowns());
  Eigen::VectorXd cancelled = internal;  // sizes of the terms whose sum is the imbalance
  add_internal_force(u, internal, cancelled);
  const double reference = std::max(external_.squaredNorm(), internal.squaredNorm());
  const Eigen::VectorXd held_back = total(u);
  double wall_square = 0.0;
  add_walls(held_back, internal, cancelled, wall_square);
  add_ghosts(held_back, internal, cancelled);
  const double in_play = std::sqrt(std::max(reference, wall_square));
  Imbalance imbalance{external_ - internal, std::max(in_play, loads_.largest_before), 0.0};
  if (loads_.carried.size() > 0) {
    imbalance.force -= loads_.carried;
  }
  for (Index k = 0; k < imbalance.force.size(); ++k) {
    if (system_.is_dropped(k)) {
      imbalance.force[k] = cancelled[k] = 0.0;
    }
  }
  imbalance.rounding = std::numeric_limits<double>::epsilon() * cancelled.norm();
  return imbalance;
}

/// The weights of a point of a surface sum to one: only unknowns that were dropped lose force.
template <int Dim>
double Equilibrium<Dim>::lost_surface_force() const {
  double size = 0.0;
  Vec<Dim> lost = Vec<Dim>::Zero();
  for (const SurfaceForce<Dim>& load : loads_.surface_forces) {
    size += load.force.norm();
    lost -= load.force;
    spread(load, [&](Index row, const Vec<Dim>& force) {
      for (int c = 0; c < Dim; ++c) {
        lost[c] += system_.is_dropped(row + c) ? 0.0 : force[c];
      }
    });
  }
  return size > 0.0 ? lost.norm() / size : 0.0;
}

template <int Dim>
std::vector<Vec<Dim>> Equilibrium<Dim>::support_forces(const Eigen::VectorXd& u, int walls) const {
  std::vector<Vec<Dim>> forces(walls, Vec<Dim>::Zero());
  const Eigen::VectorXd held_back = total(u);
  for (const SupportTerm<Dim>& wall : loads_.walls) {
    Vec<Dim>& force = forces[wall.wall];
    for_each_node(grid_, wall.box, [&](int a, Index node) {
      force -= wall.reaction.template middleCols<Dim>(Dim * a) *
               held_back.segment<Dim>(Dim * system_.row(node));
    });
    force += wall.given;
  }
  for (const JointGap<Dim>& joint : loads_.joint_gaps) {
    forces[joint.wall] += joint.total(gather(joint.box, held_back));
  }
  return forces;
}

template class Equilibrium<2>;
template class Equilibrium<3>;

}  // namespace lapilli
