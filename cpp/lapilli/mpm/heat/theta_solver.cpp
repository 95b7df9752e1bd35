#include "lapilli/mpm/heat/theta_solver.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseLU>

#include "lapilli/algebra/symmetric_factor.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {

// Above this many unknowns a factor costs more memory and time than iterating.
template <int Dim>
constexpr Index direct_limit = Dim == 3 ? 30'000 : 400'000;

template <int Dim>
struct ThetaSolver<Dim>::Backend {
  using Matrix = Eigen::SparseMatrix<double>;
  bool direct = true;
  bool symmetric = true;
  Matrix matrix;
  std::vector<std::array<int, 3>> place;  // of the unknowns on the grid
  SymmetricFactor factor;
  Eigen::SparseLU<Matrix> lu;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower> cg;
  Eigen::BiCGSTAB<Matrix> bicgstab;

  void factorise() {
    Eigen::ComputationInfo info = Eigen::Success;
    if (direct && symmetric) {
      factor.analyse(matrix, place);
      info = factor.factorise(matrix).not_positive == 0 ? info : Eigen::NumericalIssue;
    } else if (direct) {
      lu.compute(matrix);
      info = lu.info();
    } else if (symmetric) {
      cg.setTolerance(1e-14);
      cg.compute(matrix);
    } else {
      bicgstab.setTolerance(1e-14);
      bicgstab.compute(matrix);
    }
    if (info != Eigen::Success) {
      throw RunError("heat: the matrix of the theta scheme could not be factorised");
    }
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) {
    if (direct) {
      return symmetric ? factor.solve(right) : Eigen::VectorXd(lu.solve(right));
    }
    return symmetric ? Eigen::VectorXd(cg.solve(right)) : Eigen::VectorXd(bicgstab.solve(right));
  }
};

template <int Dim>
ThetaSolver<Dim>::ThetaSolver(const NodeRows<Dim>& rows, const StencilMatrix<Dim>& conduction,
                              std::span<const double> lumped, HeatSolver choice)
    : conduction_(conduction),
      lumped_(lumped),
      number_(static_cast<std::size_t>(rows.size()), -1),
      backend_(std::make_unique<Backend>()) {
  for (const auto& row : rows.rows()) {
    for (Index place = row.shift + row.begin; place < row.shift + row.end; ++place) {
      if (lumped[place] > 0.0) {
        number_[place] = static_cast<Index>(place_.size());
        place_.push_back(place);
      }
    }
  }
  backend_->place = rows.coordinates(place_);
  backend_->direct =
      choice == HeatSolver::direct ||
      (choice == HeatSolver::automatic && static_cast<Index>(place_.size()) <= direct_limit<Dim>);
}

template <int Dim>
ThetaSolver<Dim>::~ThetaSolver() = default;

template <int Dim>
void ThetaSolver<Dim>::prepare(double scale, const BoundaryConditions<Dim>& laws) {
  std::vector<double> slopes;
  for (const auto& nodes : laws.nodes()) {
    slopes.insert(slopes.end(), nodes.slope.begin(), nodes.slope.end());
  }
  if (scale == scale_ && slopes == slopes_) {
    return;
  }
  std::vector<Eigen::Triplet<double>> triplets;
  conduction_.append_triplets(number_, scale, triplets);
  for (std::size_t k = 0; k < place_.size(); ++k) {
    triplets.emplace_back(static_cast<int>(k), static_cast<int>(k), lumped_[place_[k]]);
  }
  backend_->symmetric = !laws.has_held_temperature();
  const std::size_t count = triplets.size();
  for (std::size_t k = 0; k < count; ++k) {
    if (triplets[k].row() != triplets[k].col()) {
      triplets.emplace_back(triplets[k].col(), triplets[k].row(), triplets[k].value());
    }
  }
  constexpr std::size_t corners = 1 << Dim;
  for (const auto& nodes : laws.nodes()) {
    for (std::size_t k = 0; k < nodes.node.size(); ++k) {
      const auto row = static_cast<int>(number_[nodes.node[k]]);
      if (nodes.probe.empty()) {
        triplets.emplace_back(row, row, scale * nodes.slope[k]);
        continue;
      }
      for (std::size_t c = k * corners; c < (k + 1) * corners; ++c) {
        const auto [place, weight] = nodes.probe[c];
        if (number_[place] >= 0) {
          triplets.emplace_back(row, static_cast<int>(number_[place]),
                                scale * nodes.area[k] * nodes.conductance[k] * weight);
        }
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(place_.size());
  backend_->matrix.resize(size, size);
  backend_->matrix.setFromTriplets(triplets.begin(), triplets.end());
  backend_->factorise();
  scale_ = scale;
  slopes_ = std::move(slopes);
}

template <int Dim>
void ThetaSolver<Dim>::solve(std::span<const double> residual, std::span<double> increment) {
  Eigen::VectorXd right(static_cast<Eigen::Index>(place_.size()));
  for (std::size_t k = 0; k < place_.size(); ++k) {
    right[static_cast<Eigen::Index>(k)] = residual[place_[k]];
  }
  const Eigen::VectorXd solution = backend_->solve(right);
  if (!solution.allFinite()) {
    throw RunError("heat: the theta scheme's linear solve gave values that are not finite");
  }
  for (std::size_t k = 0; k < place_.size(); ++k) {
    increment[place_[k]] = solution[static_cast<Eigen::Index>(k)];
  }
}

template class ThetaSolver<1>;
template class ThetaSolver<2>;
template class ThetaSolver<3>;

}  // namespace lapilli
