#include <algorithm>
#include <cmath>
#include <limits>

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
    full.topLeftCorner<3, 3>().setConstant(-2.0 / 3.0 * material.shear_modulus());
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

}  // namespace

template <int Dim>
PivotReport Equilibrium<Dim>::factorise() {
  system_.clear();
  assemble_points();
  assemble_surfaces();
  constexpr double least_share = 1e-10;  // of a node inside the softest material
  constexpr double rounding = 1e-15;     // of one inside the stiffest
  double stiffest = 0.0, softest = std::numeric_limits<double>::infinity();
  for (const LinearElastic& material : materials_) {
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
  for (const LinearElastic& material : materials_) {
    whole.push_back(tangent_of<Dim>(material, false));
    deviators.push_back(tangent_of<Dim>(material, true));
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
      const Vec<Dim>* gradient = weights_.gradient(p);
      const Vec<Dim>* mean = state_.mean.of_point(p);
      const Tangent<Dim> tangent =
          volume_[p] * (mean != nullptr ? deviators[body_[p]] : whole[body_[p]]);
      const double bulk = mean != nullptr ? volume_[p] * materials_[body_[p]].bulk_modulus() : 0.0;
      for (int b = 0; b < nodes; ++b) {
        const StrainRows<Dim> stress_b = tangent * strain_rows<Dim>(gradient[b]);
        for (int a = 0; a <= b; ++a) {
          Mat<Dim> block = strain_rows<Dim>(gradient[a]).transpose() * stress_b;
          if (mean != nullptr) {
            block += bulk * mean[a] * mean[b].transpose();
          }
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
  for (const SupportTerm<Dim>& wall : loads_.walls) {
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

#define LAPILLI_INSTANTIATE(Dim)                       \
  template PivotReport Equilibrium<Dim>::factorise();  \
  template void Equilibrium<Dim>::assemble_points();   \
  template void Equilibrium<Dim>::assemble_surfaces(); \
  template double Equilibrium<Dim>::ghost_stiffness(const CellBox<Dim>& pair, int axis) const;
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
