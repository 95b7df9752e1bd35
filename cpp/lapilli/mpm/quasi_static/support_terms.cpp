#include "lapilli/mpm/quasi_static/support_terms.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace lapilli {

SupportScheme SupportScheme::of(Enforcement form, double bandwidth, double gap_bandwidth) {
  const double stiff = 4.0 / (3.0 * bandwidth), moderate = 4.0 / (3.0 * gap_bandwidth);
  switch (form) {
    case Enforcement::pointwise:
    case Enforcement::literal:
      return {0.0, stiff, 1.0};
    case Enforcement::nitsche:
      return {0.0, moderate, 1.0};
    case Enforcement::penalty:
      return {0.0, stiff, 0.0};
    case Enforcement::mean_gap:
      break;
  }
  return {stiff, moderate, 1.0, true};
}

SupportScheme SupportScheme::at_end(bool averaged) const {
  constexpr double firmer = 3.0;  // 2 is the best for drawn domes, and near to letting go
  return {0.0, firmer * pointwise, averaged ? 0.0 : consistency, spares_volume};
}

template <int Dim>
void cell_shape(const Grid<Dim>& grid, const typename Grid<Dim>::Cell& cell,
                const Vec<Dim>& position, double* value, Vec<Dim>* gradient) {
  const Vec<Dim> at = grid.local(position);
  for (int node = 0; node < (1 << Dim); ++node) {
    double factor[Dim], slope[Dim];
    value[node] = 1.0;
    for (int axis = 0; axis < Dim; ++axis) {
      const double xi = at[axis] - cell[axis];
      const bool upper = (node >> axis) & 1;
      factor[axis] = upper ? xi : 1.0 - xi;
      slope[axis] = (upper ? 1.0 : -1.0) * grid.inverse_cell_size();
      value[node] *= factor[axis];
    }
    for (int axis = 0; axis < Dim; ++axis) {
      gradient[node][axis] = slope[axis];
      for (int other = 0; other < Dim; ++other) {
        if (other != axis) {
          gradient[node][axis] *= factor[other];
        }
      }
    }
  }
}

namespace {

/// The directions a wall constrains: their projector, and the stiffness matrix of the constraint.
template <int Dim>
struct Constraint {
  Mat<Dim> projector;
  Mat<Dim> stiffness;
  std::vector<std::pair<Vec<Dim>, double>> directions;  // with the modulus of each

  /// `constrained` modulus across the wall, `across_point` the same where single points are held.
  Constraint(HeldMotion kind, const Vec<Dim>& normal, double constrained, double across_point,
             double shear) {
    const Mat<Dim> across = normal * normal.transpose();
    const Mat<Dim> along = Mat<Dim>::Identity() - across;
    projector.setZero();
    stiffness.setZero();
    if (kind != HeldMotion::tangent) {
      projector += across;
      stiffness += across_point * across;
      directions.push_back({normal, constrained});
    }
    if (kind != HeldMotion::roller) {
      projector += along;
      stiffness += shear * along;
      Vec<Dim> first;
      if constexpr (Dim == 2) {
        first = Vec<Dim>(-normal[1], normal[0]);
      } else {
        int least = 0;
        normal.cwiseAbs().minCoeff(&least);
        first = Vec<Dim>(normal.cross(Vec<Dim>::Unit(least))).normalized();
        directions.push_back({normal.cross(first), shear});
      }
      directions.push_back({first, shear});
    }
  }
};

}  // namespace

template <int Dim>
SupportTerm<Dim> support_term(const Grid<Dim>& grid, const CellState<Dim>& state,
                              const Facet<Dim>& facet, HeldMotion kind,
                              std::span<const Vec<Dim>> motion, const SupportScheme& scheme) {
  constexpr int nodes = SupportTerm<Dim>::nodes, width = nodes * Dim;
  using Rows = Eigen::Matrix<double, Dim, width>;
  const Index cell = grid.cell_index(facet.cell);
  const double lame = state.lame[cell], shear = state.shear[cell];
  // Nearly incompressible material would lock if every point of the wall were held as stiffly as
  // its volume is: where mean gaps carry that part, points do so as at a Poisson ratio of 0.4.
  const double constrained = lame + 2.0 * shear;
  const double across_point =
      scheme.spares_volume ? std::min(constrained, 6.0 * shear) : constrained;
  const Vec<Dim>* mean_gradient = state.mean.of_cell(cell);
  const double inverse_cell = grid.inverse_cell_size();
  const double consistency = state.occupied[cell] ? scheme.consistency : 0.0;

  SupportTerm<Dim> term;
  term.box.first = facet.cell;
  term.box.cells.fill(1);
  term.wall = facet.surface;
  typename SupportTerm<Dim>::LocalMatrix traction_part = SupportTerm<Dim>::LocalMatrix::Zero();
  typename SupportTerm<Dim>::LocalMatrix stiff_part = SupportTerm<Dim>::LocalMatrix::Zero();
  typename SupportTerm<Dim>::LocalVector stiff_force = SupportTerm<Dim>::LocalVector::Zero();
  term.force.setZero();

  // Means over the facet of each constrained direction: q_c = int N^T c ds.
  constexpr int most_directions = Dim;
  Eigen::Matrix<double, width, most_directions> mean =
      Eigen::Matrix<double, width, most_directions>::Zero();
  Eigen::Matrix<double, most_directions, 1> mean_motion =
      Eigen::Matrix<double, most_directions, 1>::Zero();
  std::vector<double> moduli;

  for (std::size_t q = 0; q < facet.points.size(); ++q) {
    const SurfacePoint<Dim>& point = facet.points[q];
    const Vec<Dim>& n = point.normal;
    const Constraint<Dim> hold(kind, n, constrained, across_point, shear);
    double value[nodes];
    Vec<Dim> gradient[nodes];
    cell_shape<Dim>(grid, facet.cell, point.position, value, gradient);
    Rows shape = Rows::Zero(), traction;
    for (int a = 0; a < nodes; ++a) {
      // sigma(N_a e_j) n, row i: lambda n_i g_j + mu (delta_ij g.n + g_i n_j)
      const Vec<Dim>& g = gradient[a];
      const Vec<Dim> dilatation = mean_gradient ? mean_gradient[a] : g;
      const Mat<Dim> stress_on_wall =
          n * (lame * dilatation + 2.0 / Dim * shear * (dilatation - g)).transpose() +
          shear * g * n.transpose() + shear * g.dot(n) * Mat<Dim>::Identity();
      traction.template middleCols<Dim>(a * Dim) = hold.projector * stress_on_wall;
      shape.template middleCols<Dim>(a * Dim) = value[a] * Mat<Dim>::Identity();
    }
    traction *= consistency;
    const Mat<Dim> pointwise = scheme.pointwise * inverse_cell * hold.stiffness;
    traction_part += point.weight * traction.transpose() * shape;
    stiff_part += point.weight * shape.transpose() * pointwise * shape;
    term.force += point.weight * traction.transpose() * motion[q];
    stiff_force += point.weight * shape.transpose() * pointwise * motion[q];
    moduli.resize(hold.directions.size());
    for (std::size_t c = 0; c < hold.directions.size(); ++c) {
      const auto& [direction, modulus] = hold.directions[c];
      mean.col(c) += point.weight * shape.transpose() * direction;
      mean_motion[c] += point.weight * direction.dot(motion[q]);
      moduli[c] = modulus;
    }
  }
  if (scheme.stiff > 0.0) {
    const double area = facet.area();
    for (std::size_t c = 0; c < moduli.size(); ++c) {
      const double stiffness = scheme.stiff * inverse_cell * moduli[c] / area;
      stiff_part += stiffness * mean.col(c) * mean.col(c).transpose();
      stiff_force += stiffness * mean_motion[c] * mean.col(c);
    }
  }
  term.force += stiff_force;
  term.matrix = traction_part + traction_part.transpose() + stiff_part;
  term.reaction.setZero();
  term.given.setZero();
  for (int a = 0; a < nodes; ++a) {
    term.reaction += (traction_part.transpose() + stiff_part).template middleRows<Dim>(a * Dim);
    term.given += stiff_force.template segment<Dim>(a * Dim);
  }
  return term;
}

template <int Dim>
void SupportTerm<Dim>::let_go() {
  matrix.setZero();
  force.setZero();
  reaction.setZero();
  given.setZero();
}

template <int Dim>
void SupportTerm<Dim>::push(const Grid<Dim>& grid, const SurfacePoint<Dim>& point,
                            const Vec<Dim>& by) {
  double value[nodes];
  Vec<Dim> gradient[nodes];
  cell_shape<Dim>(grid, box.first, point.position, value, gradient);
  for (int a = 0; a < nodes; ++a) {
    force.template segment<Dim>(a * Dim) += value[a] * by;
  }
}

template <int Dim>
Eigen::MatrixXd ghost_matrix(int axis, double cell_size) {
  CellBox<Dim> box{};
  box.cells.fill(1);
  box.cells[axis] = 2;
  const int count = box.node_count();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count, count);
  const double gauss[2] = {0.5 - std::sqrt(1.0 / 12.0), 0.5 + std::sqrt(1.0 / 12.0)};
  for (int q = 0; q < (1 << (Dim - 1)); ++q) {
    Eigen::VectorXd jump = Eigen::VectorXd::Zero(count);
    for (int k = 0; k < count; ++k) {
      // Node k of the pair: its place along the axis, and its hat across.
      int rest = k, across = 0;
      double hat = 1.0;
      int place = 0;
      for (int direction = 0; direction < Dim; ++direction) {
        const int nodes = box.cells[direction] + 1;
        const int at = rest % nodes;
        rest /= nodes;
        if (direction == axis) {
          place = at;
        } else {
          const double xi = gauss[(q >> across++) & 1];
          hat *= at == 0 ? 1.0 - xi : xi;
        }
      }
      jump[k] = (place == 1 ? 2.0 : -1.0) * hat / cell_size;
    }
    matrix += jump * jump.transpose();
  }
  const double face_area = std::pow(cell_size, Dim - 1);
  return matrix * (face_area / (1 << (Dim - 1))) * cell_size / 3.0;
}

template void cell_shape<2>(const Grid<2>&, const Grid<2>::Cell&, const Vec<2>&, double*, Vec<2>*);
template void cell_shape<3>(const Grid<3>&, const Grid<3>::Cell&, const Vec<3>&, double*, Vec<3>*);
template SupportTerm<2> support_term(const Grid<2>&, const CellState<2>&, const Facet<2>&,
                                     HeldMotion, std::span<const Vec<2>>, const SupportScheme&);
template SupportTerm<3> support_term(const Grid<3>&, const CellState<3>&, const Facet<3>&,
                                     HeldMotion, std::span<const Vec<3>>, const SupportScheme&);
template struct SupportTerm<2>;
template struct SupportTerm<3>;
template Eigen::MatrixXd ghost_matrix<2>(int, double);
template Eigen::MatrixXd ghost_matrix<3>(int, double);

}  // namespace lapilli
