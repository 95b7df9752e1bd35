#include "lapilli/peridynamics/bond_balance.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/parallel.hpp"

namespace lapilli {
namespace {

constexpr int sweeps = 40, scaling_sweeps = 10, newton_steps = 8, cg_steps = 400;
constexpr double cg_tolerance = 1e-3, closed = 1e-12, damping = 0.7;

double positive(double t) { return t >= 0.0 ? 1.0 + t : 1.0 / (1.0 - t); }
double positive_slope(double t) { return t >= 0.0 ? 1.0 : 1.0 / ((1.0 - t) * (1.0 - t)); }

template <int Dim>
double dot(const std::vector<Vec<Dim>>& a, const std::vector<Vec<Dim>>& b) {
  return parallel_sum(static_cast<Index>(a.size()), 0.0, [&](Index i) {
    return a[static_cast<std::size_t>(i)].dot(b[static_cast<std::size_t>(i)]);
  });
}

}  // namespace

template <int Dim>
BondBalance<Dim>::BondBalance(const BondGraph<Dim>& graph, const PointSurface<Dim>& surface,
                              std::vector<Vec<Dim>> places)
    : graph_(graph),
      surface_(surface),
      places_(std::move(places)),
      tilt_(places_.size(), Vec<Dim>::Zero()),
      scale_(places_.size(), 0.0) {}

template <int Dim>
std::vector<double> BondBalance<Dim>::solve() {
  start();
  for (int k = 0; k < sweeps; ++k) {
    sweep(k < scaling_sweeps);
  }
  for (int k = 0; k < newton_steps && newton(); ++k) {
  }
  measure();
  std::vector<double> result(graph_.neighbour.size());
  parallel_for(graph_.points(), [&](Index i) {
    for (Index b = graph_.begin[i]; b < graph_.begin[i + 1]; ++b) {
      result[b] = weight(i, b, tilt_);
    }
  });
  return result;
}

template <int Dim>
void BondBalance<Dim>::start() {
  parallel_for(graph_.points(), [&](Index i) {
    double moment = 0.0;
    for (Index b = graph_.begin[i]; b < graph_.begin[i + 1]; ++b) {
      moment += graph_.weight[b] * graph_.bond[b].squaredNorm();
    }
    scale_[i] = moment > 0.0 ? 2.0 * surface_.moment[i] / moment : 0.0;
  });
}

template <int Dim>
double BondBalance<Dim>::tilt_of(Index i, Index b, const Vectors& tilt) const {
  return (tilt[i] - tilt[graph_.neighbour[b]]).dot(graph_.bond[b]);
}

template <int Dim>
double BondBalance<Dim>::weight(Index i, Index b, const Vectors& tilt) const {
  return 0.5 * graph_.weight[b] * (scale_[i] + scale_[graph_.neighbour[b]]) *
         positive(tilt_of(i, b, tilt));
}

template <int Dim>
double BondBalance<Dim>::stiffness(Index i, Index b) const {
  return 0.5 * graph_.weight[b] * (scale_[i] + scale_[graph_.neighbour[b]]) *
         positive_slope(tilt_of(i, b, tilt_));
}

template <int Dim>
Vec<Dim> BondBalance<Dim>::load(Index i, const Vectors& tilt) const {
  Vec<Dim> sum = surface_.area[i];
  for (Index b = graph_.begin[i]; b < graph_.begin[i + 1]; ++b) {
    sum += weight(i, b, tilt) * graph_.bond[b];
  }
  return sum;
}

template <int Dim>
typename BondBalance<Dim>::Vectors BondBalance<Dim>::loads(const Vectors& tilt) const {
  Vectors result(tilt.size());
  parallel_for(graph_.points(), [&](Index i) { result[i] = load(i, tilt); });
  return result;
}

template <int Dim>
void BondBalance<Dim>::sweep(bool scale) {
  Vectors next(tilt_.size());
  std::vector<double> next_scale = scale_;
  parallel_for(graph_.points(), [&](Index i) {
    Vec<Dim> out = surface_.area[i];
    double moment = 0.0;
    for (Index b = graph_.begin[i]; b < graph_.begin[i + 1]; ++b) {
      const double g = weight(i, b, tilt_);
      out += g * graph_.bond[b];
      moment += g * graph_.bond[b].squaredNorm();
    }
    // The diagonal block, sum of g Y Y, is about its trace over Dim.
    next[i] = tilt_[i];
    if (moment > 0.0) {
      next[i] -= damping * 0.5 * Dim / moment * out;
      if (scale) {
        next_scale[i] *= std::sqrt(2.0 * surface_.moment[i] / moment);
      }
    }
  });
  tilt_.swap(next);
  scale_.swap(next_scale);
}

template <int Dim>
bool BondBalance<Dim>::newton() {
  Vectors out = loads(tilt_);
  remove_rigid(out);
  const double before = std::sqrt(dot<Dim>(out, out));
  const double whole = std::sqrt(dot<Dim>(surface_.area, surface_.area));
  if (!(before > closed * whole)) {
    return false;
  }
  const Vectors step = displacements(out);
  for (double share = 1.0; share > 0.01; share *= 0.5) {
    Vectors tried = tilt_;
    parallel_for(graph_.points(), [&](Index i) { tried[i] -= share * step[i]; });
    Vectors now = loads(tried);
    remove_rigid(now);
    const double after = std::sqrt(dot<Dim>(now, now));
    if (after < before) {
      tilt_.swap(tried);
      return after < 0.7 * before;
    }
  }
  return false;
}

template <int Dim>
void BondBalance<Dim>::remove_rigid(Vectors& loads) const {
  constexpr int turns = Dim * (Dim - 1) / 2, modes = Dim + turns;
  using Small = Eigen::Matrix<double, modes, 1>;
  using Square = Eigen::Matrix<double, modes, modes>;
  const Index points = graph_.points();
  Vec<Dim> middle = Vec<Dim>::Zero();
  for (const Vec<Dim>& place : places_) {
    middle += place / static_cast<double>(points);
  }
  const auto modes_at = [&](Index i) {
    Eigen::Matrix<double, Dim, modes> at = Eigen::Matrix<double, Dim, modes>::Zero();
    const Vec<Dim> arm = places_[i] - middle;
    int column = Dim;
    for (int a = 0; a < Dim; ++a) {
      at(a, a) = 1.0;
      for (int b = 0; b < a; ++b, ++column) {
        at(a, column) = arm[b];
        at(b, column) = -arm[a];
      }
    }
    return at;
  };
  Square gram = Square::Zero();
  Small right = Small::Zero();
  for (Index i = 0; i < points; ++i) {
    if (graph_.begin[i] < graph_.begin[i + 1]) {
      const auto at = modes_at(i);
      gram += at.transpose() * at;
      right += at.transpose() * loads[i];
    }
  }
  const Small share = gram.colPivHouseholderQr().solve(right);
  parallel_for(points, [&](Index i) {
    loads[i] = graph_.begin[i] < graph_.begin[i + 1] ? Vec<Dim>(loads[i] - modes_at(i) * share)
                                                     : Vec<Dim>(Vec<Dim>::Zero());
  });
}

template <int Dim>
typename BondBalance<Dim>::Vectors BondBalance<Dim>::displacements(const Vectors& loads) const {
  const Index points = graph_.points();
  std::vector<double> stiff(graph_.neighbour.size()), inverse(tilt_.size(), 0.0);
  parallel_for(points, [&](Index i) {
    double trace = 0.0;
    for (Index b = graph_.begin[i]; b < graph_.begin[i + 1]; ++b) {
      stiff[b] = stiffness(i, b);
      trace += stiff[b] * graph_.bond[b].squaredNorm();
    }
    inverse[i] = trace > 0.0 ? Dim / trace : 0.0;
  });
  Vectors x(tilt_.size(), Vec<Dim>::Zero()), r = loads, z(r.size()), p, q(r.size());
  const auto precondition = [&] {
    parallel_for(points, [&](Index i) { z[i] = inverse[i] * r[i]; });
  };
  precondition();
  p = z;
  double rz = dot<Dim>(r, z);
  const double enough = cg_tolerance * cg_tolerance * rz;
  for (int step = 0; step < cg_steps && rz > enough; ++step) {
    parallel_for(points, [&](Index i) {
      q[i].setZero();
      for (Index b = graph_.begin[i]; b < graph_.begin[i + 1]; ++b) {
        q[i] += stiff[b] * (p[i] - p[graph_.neighbour[b]]).dot(graph_.bond[b]) * graph_.bond[b];
      }
    });
    const double alpha = rz / dot<Dim>(p, q);
    if (!std::isfinite(alpha)) {
      break;
    }
    parallel_for(points, [&](Index i) {
      x[i] += alpha * p[i];
      r[i] -= alpha * q[i];
    });
    precondition();
    const double next = dot<Dim>(r, z);
    parallel_for(points, [&](Index i) { p[i] = z[i] + next / rz * p[i]; });
    rz = next;
  }
  return x;
}

template <int Dim>
void BondBalance<Dim>::measure() {
  open_.assign(tilt_.size(), 0.0);
  parallel_for(graph_.points(), [&](Index i) {
    double size = surface_.area[i].norm();
    for (Index b = graph_.begin[i]; b < graph_.begin[i + 1]; ++b) {
      size += weight(i, b, tilt_) * graph_.bond[b].norm();
    }
    open_[i] = size > 0.0 ? load(i, tilt_).norm() / size : 0.0;
  });
}

template class BondBalance<1>;
template class BondBalance<2>;
template class BondBalance<3>;

}  // namespace lapilli
