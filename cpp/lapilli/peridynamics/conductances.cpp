#include "lapilli/peridynamics/conductances.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/peridynamics/bond_tensor.hpp"

namespace lapilli {
namespace {

using lanes::multiply_add;

constexpr Index piece = conductance_piece;
constexpr int sweeps_at_rest = 200;
constexpr double sweep_damping = 0.7;

std::vector<FamilyRole> roles_of(const WallSurface& walls) {
  std::vector<FamilyRole> roles;
  for (Index body = 0; body < walls.bodies(); ++body) {
    const bool wall = walls.wall_of_body(body) >= 0;
    roles.push_back({wall ? Member::neighbour : Member::owner, wall});
  }
  return roles;
}

}  // namespace

template <int Dim>
Conductances<Dim>::Conductances(Points& points, const WallSurface& walls,
                                const PeridynamicHeatSettings& settings, double conductivity)
    : points_(points),
      walls_(walls),
      conductivity_(conductivity),
      weight_{settings.influence, settings.widest_horizon() * walls.spacing(), walls.spacing(),
              true},
      lattice_constant_(2.0 / lattice_moment(Dim, weight_)),
      corrected_(settings.laplacian == Laplacian::corrected),
      families_(points, weight_.horizon, settings.skin * walls.spacing(), roles_of(walls)),
      insulation_(points, walls, families_),
      correction_(points, Dim),
      normaliser_(points, Row::entries),
      rows_(static_cast<std::size_t>(points.size() * Row::size), 0.0),
      images_(static_cast<std::size_t>((points.size() + piece - 1) / piece)),
      image_begin_(static_cast<std::size_t>(points.size()) + 1, 0) {
  for (Index i = 0; i < points.size(); ++i) {
    for (int d = 0; d < Dim; ++d) {
      normaliser_[i * Row::entries + Row::entry(d, d)] = lattice_constant_;
    }
  }
}

template <int Dim>
bool Conductances<Dim>::update() {
  if (version_ == points_.version() && ordering_ == points_.ordering()) {
    return false;
  }
  find_families();
  if (first_ && corrected_) {
    balance(0.0, true);  // no tilt yet: the moments of the bonds
    for (int sweep = 0; sweep < sweeps_at_rest; ++sweep) {
      balance(sweep_damping, true);
    }
  }
  // Points that move keep the correction of the step before and improve it by one sweep.
  const bool improve = corrected_ && !first_ && !keep_correction_;
  balance(improve ? sweep_damping : 0.0, improve);
  version_ = points_.version();
  ordering_ = points_.ordering();
  first_ = keep_correction_ = false;
  return true;
}

template <int Dim>
void Conductances<Dim>::refresh() {
  if (first_ || version_ != points_.version() || ordering_ != points_.ordering()) {
    find_families();
    if (first_ && corrected_) {
      balance(0.0, true);
    }
    balance(0.0, false);
  }
}

template <int Dim>
void Conductances<Dim>::find_families() {
  if (families_.update() || reach_.empty()) {
    conductance_.resize(static_cast<std::size_t>(families_.bonds()));
    reach_ = families_.reach(piece);
  }
}

template <int Dim>
void Conductances<Dim>::balance(double damping, bool normalise) {
  parallel_wave(
      reach_,
      [&](Index task) {
        for (Index i = task * piece; i < std::min(points_.size(), (task + 1) * piece); ++i) {
          gather_row(i);
          if (corrected_) {
            insulation_.find(i);
          }
        }
      },
      [&](Index task) {
        find_images(task);
        for (Index i = task * piece; i < std::min(points_.size(), (task + 1) * piece); ++i) {
          if (families_.owns(i)) {
            balance_point(i, damping, normalise);
          }
        }
      });
}

template <int Dim>
void Conductances<Dim>::gather_row(Index i) {
  double* row = rows_.data() + i * Row::size;
  for (int d = 0; d < Dim; ++d) {
    row[d] = points_.position()[i * Dim + d];
    row[Row::correction + d] = correction_[i * Dim + d];
  }
  for (int e = 0; e < Row::entries; ++e) {
    row[Row::tensor(e)] = normaliser_[i * Row::entries + e];
  }
  const int wall = walls_.wall(i);
  const bool adiabatic = wall >= 0 && walls_.walls()[wall].settings.heat == WallHeat::adiabatic;
  row[Row::volume] = adiabatic ? 0.0 : points_.volume()[i];
}

template <int Dim>
void Conductances<Dim>::balance_point(Index i, double damping, bool normalise) {
  Sums sums = sum_row(i);
  if (corrected_ && insulation_.near(i)) {
    hide_bonds(i, sums);
    add_images(i, sums);
  }
  // The sweep divides by the diagonal block, sum of s Y Y = 4 on a full lattice.
  const double* own = rows_.data() + i * Row::size;
  for (int d = 0; d < Dim; ++d) {
    correction_[i * Dim + d] = own[Row::correction + d] - damping * 0.25 * sums.outward[d];
  }
  if (normalise && sums.moment > 0.0) {
    improve_tensor<Dim>(normaliser_.data() + i * Row::entries,
                        4.0 * Mat<Dim>::Identity() - sums.shape, sums.moment, sweep_damping);
  }
}

template <int Dim>
typename Conductances<Dim>::Sums Conductances<Dim>::sum_row(Index i) {
  const std::int32_t* neighbours = families_.neighbours();
  const lanes::BondWeightLanes weight(weight_);
  const double* own = rows_.data() + i * Row::size;
  const Double4 scale = all(0.5 * conductivity_ * own[Row::volume]);
  const Double4 bound = all(0.8), zero = all(0.0), one = all(1.0);
  const Double4 tiny = all(1e-20 * weight_.horizon * weight_.horizon);
  Double4 outward[Dim], shape[Row::entries], moment = zero;
  std::fill_n(outward, Dim, zero);
  std::fill_n(shape, Row::entries, zero);
  for (Index k = families_.begin(i); k < families_.padded_end(i); k += lanes::width) {
    Double4 row[Row::size];
    for (Index quad = 0; quad < Row::size; quad += lanes::width) {
      for (Index lane = 0; lane < lanes::width; ++lane) {
        row[quad + lane] = load_quad(rows_.data() + neighbours[k + lane] * Row::size + quad);
      }
      lanes::transpose(row[quad], row[quad + 1], row[quad + 2], row[quad + 3]);
    }
    Double4 squared = zero, tilt = zero, along = zero, x[Dim];
    for (int d = 0; d < Dim; ++d) {
      x[d] = row[d] - all(own[d]);
      squared = multiply_add(x[d], x[d], squared);
      tilt = multiply_add(all(own[Row::correction + d]) - row[Row::correction + d], x[d], tilt);
    }
    for (int a = 0; a < Dim; ++a) {
      for (int b = a; b < Dim; ++b) {
        const int at = Row::tensor(Row::entry(a, b));
        along = multiply_add(all(a == b ? 1.0 : 2.0) * x[a] * x[b], row[at] + all(own[at]), along);
      }
    }
    along *= lanes::choose(squared > tiny, one / squared, zero);
    tilt = lanes::choose(tilt > bound, bound, lanes::choose(tilt < -bound, -bound, tilt));
    const Double4 w = weight(squared, square_root(squared)) * row[Row::volume] * (one + tilt);
    moment = multiply_add(w, squared, moment);
    const Double4 s = w * along;
    store_quad(conductance_.data() + k, s * scale);
    for (int a = 0; a < Dim; ++a) {
      const Double4 sa = s * x[a];
      outward[a] += sa;
      for (int b = a; b < Dim; ++b) {
        shape[Row::entry(a, b)] = multiply_add(sa, x[b], shape[Row::entry(a, b)]);
      }
    }
  }
  Sums sums;
  sums.moment = lanes::sum(moment);
  for (int a = 0; a < Dim; ++a) {
    sums.outward[a] = lanes::sum(outward[a]);
    for (int b = a; b < Dim; ++b) {
      sums.shape(a, b) = sums.shape(b, a) = lanes::sum(shape[Row::entry(a, b)]);
    }
  }
  return sums;
}

template <int Dim>
double Conductances<Dim>::imbalance() const {
  double largest = 0.0;
  for (Index i = 0; i < points_.size(); ++i) {
    if (!families_.owns(i) || families_.wall_begin(i) < families_.end(i)) {
      continue;
    }
    Vec<Dim> out = Vec<Dim>::Zero();
    double scale = 0.0;
    for (Index k = families_.begin(i); k < families_.end(i); ++k) {
      const Vec<Dim> bond =
          points_.position<Dim>(families_.neighbour(k)) - points_.position<Dim>(i);
      out += conductance_[k] * bond;
      scale += conductance_[k] * bond.norm();
    }
    if (scale > 0.0) {
      largest = std::max(largest, out.norm() / scale);
    }
  }
  return largest;
}

template <int Dim>
void Conductances<Dim>::save(Archive& archive) const {
  families_.save(archive, "heat/families");
  archive.write("heat/correction", correction_.values());
  archive.write("heat/normaliser", normaliser_.values());
  archive.write("heat/weighed", static_cast<Index>(first_ ? 0 : 1));
  archive.write("heat/at_rest", static_cast<Index>(version_ == points_.version() ? 1 : 0));
}

template <int Dim>
void Conductances<Dim>::load(const Archive& archive) {
  families_.load(archive, "heat/families");
  reach_.clear();
  archive.read("heat/correction", correction_.values());
  archive.read("heat/normaliser", normaliser_.values());
  first_ = archive.read_index("heat/weighed") == 0;
  // Points at rest keep the conductances of their one search.
  keep_correction_ = archive.read_index("heat/at_rest") == 1;
  version_ = -1;
}

template class Conductances<1>;
template class Conductances<2>;
template class Conductances<3>;

}  // namespace lapilli
