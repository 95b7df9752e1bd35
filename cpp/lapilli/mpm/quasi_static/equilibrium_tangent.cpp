#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/interruption.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/mpm/quasi_static/equilibrium.hpp"

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

/// Of the whole stress, or of its deviator alone.
template <int Dim>
Tangent<Dim> tangent_of(const LinearElastic& material, bool deviator) {
  Stiffness full = stiffness_of(material);
  if (deviator) {
    full.topLeftCorner<3, 3>().setConstant(-2.0 / Dim * material.shear_modulus());
    full.diagonal().head<3>().array() += 2.0 * material.shear_modulus();
  }
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

template <int Dim>
using FullStrainRows = Eigen::Matrix<double, 6, Dim>;

template <int Dim>
Vec<Dim> zero() {
  return Vec<Dim>::Zero();
}

/// Engineering strains xx, yy, zz, xy, yz, xz of a node's displacement, with a dilatation that is
/// `added` to that of the gradient, evenly along the axes of the scene.
template <int Dim>
FullStrainRows<Dim> full_strain_rows(const Vec<Dim>& g, const Vec<Dim>& added) {
  FullStrainRows<Dim> rows = FullStrainRows<Dim>::Zero();
  for (int axis = 0; axis < Dim; ++axis) {
    rows(axis, axis) = g[axis];
  }
  rows(3, 0) = g[1];
  rows(3, 1) = g[0];
  if constexpr (Dim == 3) {
    rows(4, 1) = g[2];
    rows(4, 2) = g[1];
    rows(5, 0) = g[2];
    rows(5, 2) = g[0];
  }
  rows.template topRows<Dim>().rowwise() += (added / Dim).transpose();
  return rows;
}

/// The upper blocks of the matrix of a group of nodes.
template <int Dim>
struct GroupMatrix {
  double* values;
  int width;

  void add(int a, int b, const Mat<Dim>& block) const {
    for (int r = 0; r < Dim; ++r) {
      for (int c = 0; c < Dim; ++c) {
        values[(a * Dim + r) * width + b * Dim + c] += block(r, c);
      }
    }
  }
};

}  // namespace

template <int Dim>
PivotReport Equilibrium<Dim>::factorise() {
  system_.clear();
  assemble_points();
  return factorise_assembled();
}

template <int Dim>
PivotReport Equilibrium<Dim>::factorise_at(const Eigen::VectorXd& u, double elastic_share) {
  system_.clear();
  assemble_yielding(u, elastic_share);
  return factorise_assembled();
}

template <int Dim>
PivotReport Equilibrium<Dim>::factorise_assembled() {
  assemble_surfaces();
  constexpr double least_share = 1e-10;  // of a node inside the softest material
  constexpr double rounding = 1e-15;     // of one inside the stiffest
  double stiffest = 0.0, softest = std::numeric_limits<double>::infinity();
  for (const LinearElastic& material : solids_.elastic()) {
    stiffest = std::max(stiffest, material.youngs_modulus);
    softest = std::min(softest, material.youngs_modulus);
  }
  const double size = std::pow(grid_.cell_size(), Dim - 2);
  system_.drop_unknowns(std::max(least_share * softest, rounding * stiffest) * size,
                        stiffest * size);
  return solver_.factorise(system_.lower());
}

template <int Dim>
void Equilibrium<Dim>::assemble_points() {
  std::vector<Tangent<Dim>> whole, deviators;
  for (const LinearElastic& material : solids_.elastic()) {
    whole.push_back(tangent_of<Dim>(material, false));
    deviators.push_back(tangent_of<Dim>(material, true));
  }
  const auto add_point = [&](Index p, int nodes, auto& matrix) {
    const Vec<Dim>* gradient = weights_.gradient(p);
    const Vec<Dim>* mean = state_.mean.of_point(p);
    const Tangent<Dim> tangent =
        volume_[p] * (mean != nullptr ? deviators[body_[p]] : whole[body_[p]]);
    const LinearElastic& material = solids_.elastic(body_[p]);
    const double bulk =
        mean != nullptr ? volume_[p] * (material.lambda() + 2.0 / Dim * material.shear_modulus())
                        : 0.0;
    for (int b = 0; b < nodes; ++b) {
      const StrainRows<Dim> stress_b = tangent * strain_rows<Dim>(gradient[b]);
      for (int a = 0; a <= b; ++a) {
        Mat<Dim> block = strain_rows<Dim>(gradient[a]).transpose() * stress_b;
        if (mean != nullptr) {
          block += bulk * mean[a] * mean[b].transpose();
        }
        matrix.add(a, b, block);
      }
    }
  };
  weights_.for_each_group([&](const auto& group) { assemble_group(group, add_point); });
}

template <int Dim>
void Equilibrium<Dim>::assemble_yielding(const Eigen::VectorXd& u, double elastic_share) {
  const auto add_point = [&](Index p, int nodes, auto& matrix) {
    const Stiffness tangent =
        volume_[p] * solids_.tangent_after(p, body_[p], strain(p, u), elastic_share);
    const Vec<Dim>* gradient = weights_.gradient(p);
    const Vec<Dim>* mean = state_.mean.of_point(p);
    const auto rows = [&](int a) {
      return full_strain_rows<Dim>(gradient[a],
                                   mean != nullptr ? Vec<Dim>(mean[a] - gradient[a]) : zero<Dim>());
    };
    for (int b = 0; b < nodes; ++b) {
      const FullStrainRows<Dim> stress_b = tangent * rows(b);
      for (int a = 0; a <= b; ++a) {
        matrix.add(a, b, Mat<Dim>(rows(a).transpose() * stress_b));
      }
    }
  };
  weights_.for_each_group([&](const auto& group) { assemble_group(group, add_point); });
}

/// The small matrix of the nodes of a group, from the upper blocks of its points.
template <int Dim>
void Equilibrium<Dim>::assemble_group(const typename PointWeights<Dim>::Group& group,
                                      const auto& add_point) {
  allow_interruption();
  const int nodes = group.box.node_count(), width = nodes * Dim;
  static thread_local std::vector<double> values;
  static thread_local std::vector<int> rows;
  values.assign(static_cast<std::size_t>(width) * width, 0.0);
  rows.resize(nodes);
  system_.rows(grid_, group.box, rows.data());
  GroupMatrix<Dim> matrix{values.data(), width};
  for (Index k = group.begin; k < group.end; ++k) {
    add_point(weights_.order()[k], nodes, matrix);
  }
  for (int i = 0; i < width; ++i) {
    for (int j = 0; j < i; ++j) {
      if (i / Dim != j / Dim) {
        values[i * width + j] = values[j * width + i];
      }
    }
  }
  system_.add(rows.data(), nodes, values.data());
}

template <int Dim>
void Equilibrium<Dim>::assemble_surfaces() {
  std::vector<int> rows;
  for (const SupportTerm<Dim>& wall : loads_.walls) {
    rows.resize(wall.box.node_count());
    system_.rows(grid_, wall.box, rows.data());
    system_.add(rows.data(), static_cast<int>(rows.size()), wall.matrix.data());
  }
  for (const JointGap<Dim>& joint : loads_.joint_gaps) {
    rows.resize(joint.box.node_count());
    system_.rows(grid_, joint.box, rows.data());
    system_.add(rows.data(), static_cast<int>(rows.size()), joint.matrix().eval().data());
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
      allow_interruption();
      const Eigen::MatrixXd scaled = ghost_stiffness(pair, axis) * matrix;
      system_.rows(grid_, pair, rows.data());
      system_.add(rows.data(), nodes, scaled.data());
    }
  }
}

template <int Dim>
bool Equilibrium<Dim>::yields_at(const Eigen::VectorXd& u) const {
  return solids_.can_yield() && parallel_sum(volume_.size(), Index{0}, [&](Index p) -> Index {
                                  return solids_.yields_after(p, body_[p], strain(p, u)) ? 1 : 0;
                                }) > 0;
}

#define LAPILLI_INSTANTIATE(Dim)                                                       \
  template PivotReport Equilibrium<Dim>::factorise();                                  \
  template PivotReport Equilibrium<Dim>::factorise_at(const Eigen::VectorXd&, double); \
  template bool Equilibrium<Dim>::yields_at(const Eigen::VectorXd&) const;             \
  template void Equilibrium<Dim>::assemble_points();                                   \
  template void Equilibrium<Dim>::assemble_surfaces();
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
