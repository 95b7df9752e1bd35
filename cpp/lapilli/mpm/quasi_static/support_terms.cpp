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
std::array<Vec<Dim>, Dim - 1> tangents(const Vec<Dim>& normal) {
  if constexpr (Dim == 2) {
    return {Vec<2>(-normal[1], normal[0])};
  } else {
    int least = 0;
    normal.cwiseAbs().minCoeff(&least);
    const Vec<3> first = normal.cross(Vec<3>::Unit(least)).normalized();
    return {first, Vec<3>(normal.cross(first))};
  }
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
      const auto both = tangents<Dim>(normal);
      for (auto one = both.rbegin(); one != both.rend(); ++one) {
        directions.push_back({*one, shear});
      }
    }
  }
};

/// The integrals of Nitsche's method over one facet, point by point.
template <int Dim>
class FacetSums {
  static constexpr int nodes = SupportTerm<Dim>::nodes, width = nodes * Dim;
  using Rows = Eigen::Matrix<double, Dim, width>;

 public:
  FacetSums(const Grid<Dim>& grid, const CellState<Dim>& state, const Facet<Dim>& facet,
            HeldMotion kind, const SupportScheme& scheme)
      : grid_(grid),
        facet_(facet),
        kind_(kind),
        scheme_(scheme),
        lame_(state.lame[grid.cell_index(facet.cell)]),
        shear_(state.shear[grid.cell_index(facet.cell)]),
        consistency_(state.occupied[grid.cell_index(facet.cell)] ? scheme.consistency : 0.0),
        mean_gradient_(state.mean.of_cell(grid.cell_index(facet.cell))) {}

  void add(const SurfacePoint<Dim>& point, const Vec<Dim>& motion) {
    // Nearly incompressible material would lock if every point of the wall were held as stiffly as
    // its volume is: where mean gaps carry that part, points do so as at a Poisson ratio of 0.4.
    const double constrained = lame_ + 2.0 * shear_;
    const double across_point =
        scheme_.spares_volume ? std::min(constrained, 6.0 * shear_) : constrained;
    const Constraint<Dim> hold(kind_, point.normal, constrained, across_point, shear_);
    double value[nodes];
    Vec<Dim> gradient[nodes];
    cell_shape<Dim>(grid_, facet_.cell, point.position, value, gradient);
    Rows shape = Rows::Zero();
    for (int a = 0; a < nodes; ++a) {
      shape.template middleCols<Dim>(a * Dim) = value[a] * Mat<Dim>::Identity();
    }
    const Rows traction = traction_rows(hold.projector, point.normal, gradient);
    const Mat<Dim> pointwise = scheme_.pointwise * grid_.inverse_cell_size() * hold.stiffness;
    traction_part_ += point.weight * traction.transpose() * shape;
    stiff_part_ += point.weight * shape.transpose() * pointwise * shape;
    force_ += point.weight * traction.transpose() * motion;
    stiff_force_ += point.weight * shape.transpose() * pointwise * motion;
    moduli_.resize(hold.directions.size());
    for (std::size_t c = 0; c < hold.directions.size(); ++c) {
      const auto& [direction, modulus] = hold.directions[c];
      mean_.col(c) += point.weight * shape.transpose() * direction;
      mean_motion_[c] += point.weight * direction.dot(motion);
      moduli_[c] = modulus;
    }
  }

  SupportTerm<Dim> term() {
    add_mean_gaps();
    SupportTerm<Dim> term;
    term.box.first = facet_.cell;
    term.box.cells.fill(1);
    term.wall = facet_.surface;
    term.force = force_ + stiff_force_;
    term.matrix = traction_part_ + traction_part_.transpose() + stiff_part_;
    term.reaction.setZero();
    term.given.setZero();
    for (int a = 0; a < nodes; ++a) {
      term.reaction += (traction_part_.transpose() + stiff_part_).template middleRows<Dim>(a * Dim);
      term.given += stiff_force_.template segment<Dim>(a * Dim);
    }
    return term;
  }

 private:
  /// The held part of sigma(N_a e_j) n, row i: lambda n_i g_j + mu (delta_ij g.n + g_i n_j).
  Rows traction_rows(const Mat<Dim>& projector, const Vec<Dim>& n, const Vec<Dim>* gradient) const {
    Rows traction;
    for (int a = 0; a < nodes; ++a) {
      const Vec<Dim>& g = gradient[a];
      const Vec<Dim> dilatation = mean_gradient_ ? mean_gradient_[a] : g;
      const Mat<Dim> stress_on_wall =
          n * (lame_ * dilatation + 2.0 / Dim * shear_ * (dilatation - g)).transpose() +
          shear_ * g * n.transpose() + shear_ * g.dot(n) * Mat<Dim>::Identity();
      traction.template middleCols<Dim>(a * Dim) = projector * stress_on_wall;
    }
    traction *= consistency_;
    return traction;
  }

  /// By the means over the facet of each constrained direction: q_c = int N^T c ds.
  void add_mean_gaps() {
    if (!(scheme_.stiff > 0.0)) {
      return;
    }
    const double area = facet_.area();
    for (std::size_t c = 0; c < moduli_.size(); ++c) {
      const double stiffness = scheme_.stiff * grid_.inverse_cell_size() * moduli_[c] / area;
      stiff_part_ += stiffness * mean_.col(c) * mean_.col(c).transpose();
      stiff_force_ += stiffness * mean_motion_[c] * mean_.col(c);
    }
  }

  const Grid<Dim>& grid_;
  const Facet<Dim>& facet_;
  HeldMotion kind_;
  const SupportScheme& scheme_;
  double lame_, shear_, consistency_;
  const Vec<Dim>* mean_gradient_;  // at the nodes, or none

  using LocalMatrix = typename SupportTerm<Dim>::LocalMatrix;
  using LocalVector = typename SupportTerm<Dim>::LocalVector;
  LocalMatrix traction_part_ = LocalMatrix::Zero(), stiff_part_ = LocalMatrix::Zero();
  LocalVector force_ = LocalVector::Zero(), stiff_force_ = LocalVector::Zero();
  Eigen::Matrix<double, width, Dim> mean_ = Eigen::Matrix<double, width, Dim>::Zero();
  Vec<Dim> mean_motion_ = Vec<Dim>::Zero();
  std::vector<double> moduli_;
};

}  // namespace

template <int Dim>
SupportTerm<Dim> support_term(const Grid<Dim>& grid, const CellState<Dim>& state,
                              const Facet<Dim>& facet, HeldMotion kind,
                              std::span<const Vec<Dim>> motion, const SupportScheme& scheme) {
  FacetSums<Dim> sums(grid, state, facet, kind, scheme);
  for (std::size_t q = 0; q < facet.points.size(); ++q) {
    sums.add(facet.points[q], motion[q]);
  }
  return sums.term();
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

template std::array<Vec<2>, 1> tangents<2>(const Vec<2>&);
template std::array<Vec<3>, 2> tangents<3>(const Vec<3>&);
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
