#include "lapilli/peridynamics/operators.hpp"

#include <Eigen/LU>
#include <atomic>
#include <cmath>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/symmetric_modes.hpp"

namespace lapilli {
namespace {

/// Inverse of a shape matrix in the directions that bonds span, zero in others.
template <int Dim>
Mat<Dim> inverse_along_span(const Mat<Dim>& shape) {
  constexpr double flat = 0.02;  // of the largest eigenvalue
  const SymmetricModes<Dim> solved = symmetric_modes<Dim>(shape);
  Vec<Dim> inverse = Vec<Dim>::Zero();
  for (int d = 0; d < Dim; ++d) {
    if (solved.eigenvalues[d] > flat * solved.eigenvalues[Dim - 1]) {
      inverse[d] = 1.0 / solved.eigenvalues[d];
    }
  }
  return solved.eigenvectors * inverse.asDiagonal() * solved.eigenvectors.transpose();
}

}  // namespace

template <int Dim>
template <class Body>
void NonlocalOperators<Dim>::for_bonds(Index point, const Body& body) const {
  const Vec<Dim> here = points_.position<Dim>(point);
  for (Index bond = families_.begin(point); bond < families_.end(point); ++bond) {
    if (bond_weight_[bond] != 0.0) {
      const Index j = families_.neighbour(bond);
      body(j, Vec<Dim>(points_.position<Dim>(j) - here), bond_weight_[bond]);
    }
  }
}

template <int Dim>
NonlocalOperators<Dim>::NonlocalOperators(const Points& points, const Families& families,
                                          const BondWeight& weight, std::span<const double> volume,
                                          const std::function<bool(Index)>& may_be_flat)
    : points_(points),
      families_(families),
      influence_(weight),
      bond_weight_(static_cast<std::size_t>(families.bonds()), 0.0),
      inverse_shape_(static_cast<std::size_t>(points.size()), Mat<Dim>::Zero()),
      trace_(static_cast<std::size_t>(points.size()), 0.0) {
  std::atomic<Index> flat{-1};
  parallel_for(points.size(), [&](Index i) {
    if (volume[i] == 0.0 || families_.begin(i) == families_.end(i)) {
      return;
    }
    const Vec<Dim> here = points.position<Dim>(i);
    Mat<Dim> shape = Mat<Dim>::Zero();
    for (Index bond = families_.begin(i); bond < families_.end(i); ++bond) {
      const Index j = families_.neighbour(bond);
      const Vec<Dim> y = points.position<Dim>(j) - here;
      bond_weight_[bond] = influence_(y.norm()) * volume[j];
      shape += bond_weight_[bond] * y * y.transpose();
    }
    trace_[i] = shape.trace();
    if (may_be_flat && may_be_flat(i)) {
      inverse_shape_[i] = inverse_along_span<Dim>(shape);
      return;
    }
    if (!(shape.determinant() > 1e-9 * std::pow(trace_[i] / Dim, Dim))) {
      flat = i;
      return;
    }
    inverse_shape_[i] = shape.inverse();
  });
  if (flat >= 0) {
    throw RunError(message("the bonds of point ", points.id()[flat],
                           " do not span the space: its horizon of ", influence_.horizon,
                           " m holds too few points"));
  }
}

template <int Dim>
std::vector<Vec<Dim>> NonlocalOperators<Dim>::gradient(std::span<const double> scalar) const {
  std::vector<Vec<Dim>> result(inverse_shape_.size(), Vec<Dim>::Zero());
  parallel_for(points_.size(), [&](Index i) {
    Vec<Dim> sum = Vec<Dim>::Zero();
    for_bonds(
        i, [&](Index j, const Vec<Dim>& y, double w) { sum += w * (scalar[j] - scalar[i]) * y; });
    result[i] = inverse_shape_[i] * sum;
  });
  return result;
}

template <int Dim>
std::vector<double> NonlocalOperators<Dim>::divergence(std::span<const Vec<Dim>> vector) const {
  std::vector<double> result(inverse_shape_.size(), 0.0);
  parallel_for(points_.size(), [&](Index i) {
    double sum = 0.0;
    for_bonds(i, [&](Index j, const Vec<Dim>& y, double w) {
      sum += w * (vector[j] - vector[i]).dot(inverse_shape_[i] * y);
    });
    result[i] = sum;
  });
  return result;
}

template <int Dim>
std::vector<double> NonlocalOperators<Dim>::flux_divergence(std::span<const Vec<Dim>> flux) const {
  std::vector<double> result(inverse_shape_.size(), 0.0);
  parallel_for(points_.size(), [&](Index i) {
    const Vec<Dim> own = inverse_shape_[i] * flux[i];
    double sum = 0.0;
    for_bonds(i, [&](Index j, const Vec<Dim>& y, double w) {
      sum += w * (own + inverse_shape_[j] * flux[j]).dot(y);
    });
    result[i] = sum;
  });
  return result;
}

template <int Dim>
std::vector<double> NonlocalOperators<Dim>::laplacian(std::span<const double> scalar,
                                                      Laplacian form, double zero_energy) const {
  std::vector<double> result(inverse_shape_.size(), 0.0);
  if (form == Laplacian::compact) {
    const double constant = 2.0 / lattice_moment(Dim, influence_);
    parallel_for(points_.size(), [&](Index i) {
      double sum = 0.0;
      for_bonds(i, [&](Index j, const Vec<Dim>&, double w) { sum += w * (scalar[j] - scalar[i]); });
      result[i] = constant * sum;
    });
    return result;
  }
  const std::vector<Vec<Dim>> slope = gradient(scalar);
  if (form == Laplacian::corrected) {
    parallel_for(points_.size(), [&](Index i) {
      double sum = 0.0;
      for_bonds(i, [&](Index j, const Vec<Dim>& y, double w) {
        sum += w * (scalar[j] - scalar[i] - slope[i].dot(y));
      });
      result[i] = trace_[i] > 0.0 ? 2.0 * Dim / trace_[i] * sum : 0.0;
    });
    return result;
  }
  result = flux_divergence(slope);
  if (form == Laplacian::zero_energy) {
    parallel_for(points_.size(), [&](Index i) {
      double sum = 0.0;
      for_bonds(i, [&](Index j, const Vec<Dim>& y, double w) {
        const double scale = 0.5 * (inverse_shape_[i].trace() + inverse_shape_[j].trace());
        sum += w * scale * (scalar[j] - scalar[i] - 0.5 * (slope[i] + slope[j]).dot(y));
      });
      result[i] += zero_energy * sum;
    });
  }
  return result;
}

template class NonlocalOperators<1>;
template class NonlocalOperators<2>;
template class NonlocalOperators<3>;

}  // namespace lapilli
