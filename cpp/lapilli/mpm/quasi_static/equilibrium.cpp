#include "lapilli/mpm/quasi_static/equilibrium.hpp"

#include <algorithm>

#include "lapilli/core/parallel.hpp"

namespace lapilli {
namespace {

/// Components of stress and strain that matter: xx, yy, xy in plane strain, all six in space.
template <int Dim>
inline constexpr int components = Dim == 2 ? 3 : 6;
template <int Dim>
using StrainRows = Eigen::Matrix<double, components<Dim>, Dim>;
template <int Dim>
using Tangent = Eigen::Matrix<double, components<Dim>, components<Dim>>;

/// Engineering strains of a node's displacement, given the gradient of its shape function.
template <int Dim>
StrainRows<Dim> strain_rows(const Vec<Dim>& g) {
  StrainRows<Dim> rows;
  if constexpr (Dim == 2) {
    rows << g[0], 0.0, 0.0, g[1], g[1], g[0];
  } else {
    rows << g[0], 0.0, 0.0, 0.0, g[1], 0.0, 0.0, 0.0, g[2],  //
        g[1], g[0], 0.0, 0.0, g[2], g[1], g[2], 0.0, g[0];
  }
  return rows;
}

template <int Dim>
Tangent<Dim> tangent_of(const LinearElastic& material) {
  const Stiffness full = stiffness_of(material);
  if constexpr (Dim == 2) {
    const int kept[3] = {0, 1, 3};
    Tangent<2> plane;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        plane(i, j) = full(kept[i], kept[j]);
      }
    }
    return plane;
  } else {
    return full;
  }
}

}  // namespace

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
PivotReport Equilibrium<Dim>::factorise() {
  system_.clear();
  assemble_points();
  assemble_surfaces();
  constexpr double least_share = 1e-10;  // of a node inside the material
  double modulus = 0.0;
  for (const LinearElastic& material : materials_) {
    modulus = std::max(modulus, material.youngs_modulus);
  }
  const double inside = modulus * std::pow(grid_.cell_size(), Dim - 2);
  system_.drop_unknowns(least_share * inside, inside);
  return solver_.factorise(system_.lower());
}

template <int Dim>
void Equilibrium<Dim>::assemble_points() {
  std::vector<Tangent<Dim>> tangents;
  for (const LinearElastic& material : materials_) {
    tangents.push_back(tangent_of<Dim>(material));
  }
  weights_.for_each_group([&](const typename PointWeights<Dim>::Group& group) {
    const int nodes = group.box.node_count(), width = nodes * Dim;
    static thread_local std::vector<double> matrix;
    static thread_local std::vector<int> rows;
    matrix.assign(static_cast<std::size_t>(width) * width, 0.0);
    rows.resize(nodes);
    system_.rows(grid_, group.box, rows.data());
    for (Index k = group.begin; k < group.end; ++k) {
      const Index p = weights_.order()[k];
      const Tangent<Dim> tangent = points_.volume()[p] * tangents[points_.body()[p]];
      const Vec<Dim>* gradient = weights_.gradient(p);
      for (int b = 0; b < nodes; ++b) {
        const StrainRows<Dim> stress_b = tangent * strain_rows<Dim>(gradient[b]);
        for (int a = 0; a <= b; ++a) {
          const Mat<Dim> block = strain_rows<Dim>(gradient[a]).transpose() * stress_b;
          for (int r = 0; r < Dim; ++r) {
            for (int c = 0; c < Dim; ++c) {
              matrix[(a * Dim + r) * width + b * Dim + c] += block(r, c);
            }
          }
        }
      }
    }
    for (int i = 0; i < width; ++i) {
      for (int j = 0; j < i; ++j) {
        if (i / Dim != j / Dim) {
          matrix[i * width + j] = matrix[j * width + i];
        }
      }
    }
    system_.add(rows.data(), nodes, matrix.data());
  });
}

template <int Dim>
void Equilibrium<Dim>::assemble_surfaces() {
  std::vector<int> rows;
  for (const WallTerm<Dim>& wall : loads_.walls) {
    rows.resize(wall.box.node_count());
    system_.rows(grid_, wall.box, rows.data());
    system_.add(rows.data(), static_cast<int>(rows.size()), wall.matrix.data());
  }
  if (loads_.ghost <= 0.0) {
    return;
  }
  for (int axis = 0; axis < Dim; ++axis) {
    const Eigen::MatrixXd& one = ghost_matrix_[axis];
    const auto nodes = static_cast<int>(one.rows());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(nodes * Dim, nodes * Dim);
    for (int a = 0; a < nodes; ++a) {
      for (int b = 0; b < nodes; ++b) {
        for (int c = 0; c < Dim; ++c) {
          matrix(a * Dim + c, b * Dim + c) = one(a, b);
        }
      }
    }
    rows.resize(nodes);
    for (const CellBox<Dim>& pair : loads_.ghost_pairs[axis]) {
      const Eigen::MatrixXd scaled = ghost_stiffness(pair, axis) * matrix;
      system_.rows(grid_, pair, rows.data());
      system_.add(rows.data(), nodes, scaled.data());
    }
  }
}

template <int Dim>
double Equilibrium<Dim>::ghost_stiffness(const CellBox<Dim>& pair, int axis) const {
  const Index cell = grid_.cell_index(pair.first);
  return loads_.ghost * 0.5 * (state_.youngs[cell] + state_.youngs[cell + grid_.cell_stride(axis)]);
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
  double wall_square = 0.0;
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
    const Eigen::VectorXd held = wall.matrix * gather(wall.box);
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
  Imbalance imbalance{external_ - internal, std::sqrt(std::max(reference, wall_square))};
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
      force -=
          wall.reaction.template middleCols<Dim>(Dim * a) * u.segment<Dim>(Dim * system_.row(node));
    });
    force += wall.given;
  }
  return forces;
}

template class Equilibrium<2>;
template class Equilibrium<3>;

}  // namespace lapilli
