#include "lapilli/peridynamics/conductances.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

using lanes::multiply_add;

constexpr Index piece = 128;   // points worked on as one piece
constexpr Index row_size = 8;  // doubles
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
      normaliser_(points, 1, lattice_constant_),
      rows_(static_cast<std::size_t>(points.size()) * row_size, 0.0),
      images_(static_cast<std::size_t>((points.size() + piece - 1) / piece)),
      image_begin_(static_cast<std::size_t>(points.size()) + 1, 0) {}

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
  double* row = rows_.data() + i * row_size;
  for (int d = 0; d < Dim; ++d) {
    row[d] = points_.position()[i * Dim + d];
    row[4 + d] = correction_[i * Dim + d];
  }
  const int wall = walls_.wall(i);
  const bool adiabatic = wall >= 0 && walls_.walls()[wall].settings.heat == WallHeat::adiabatic;
  row[3] = adiabatic ? 0.0 : points_.volume()[i];
  row[7] = normaliser_[i];
}

template <int Dim>
void Conductances<Dim>::find_images(Index task) {
  if (!corrected_) {
    return;
  }
  std::vector<Image>& found = images_[static_cast<std::size_t>(task)];
  found.clear();
  for (Index i = task * piece; i < std::min(points_.size(), (task + 1) * piece); ++i) {
    image_begin_[static_cast<std::size_t>(i)] = static_cast<Index>(found.size());
    if (families_.owns(i) && insulation_.near(i)) {
      insulation_.images(i, weight_.horizon, found);
    }
  }
}

template <int Dim>
std::span<const typename Insulation<Dim>::Image> Conductances<Dim>::images(Index point) const {
  const auto& found = images_[static_cast<std::size_t>(point / piece)];
  const bool last = point + 1 == points_.size() || (point + 1) % piece == 0;
  const auto begin = static_cast<std::size_t>(image_begin_[static_cast<std::size_t>(point)]);
  const auto end =
      last ? found.size()
           : static_cast<std::size_t>(image_begin_[static_cast<std::size_t>(point) + 1]);
  return std::span(found).subspan(begin, end - begin);
}

template <int Dim>
void Conductances<Dim>::balance_point(Index i, double damping, bool normalise) {
  const std::int32_t* neighbours = families_.neighbours();
  const lanes::BondWeightLanes weight(weight_);
  const double* own = rows_.data() + i * row_size;
  const Double4 c_own = all(own[7]);
  const Double4 scale = all(0.5 * conductivity_ * own[3]);
  const Double4 bound = all(0.8), zero = all(0.0), one = all(1.0);
  Double4 outward[Dim], moment = zero;
  std::fill_n(outward, Dim, zero);
  for (Index k = families_.begin(i); k < families_.padded_end(i); k += lanes::width) {
    const double* r0 = rows_.data() + neighbours[k] * row_size;
    const double* r1 = rows_.data() + neighbours[k + 1] * row_size;
    const double* r2 = rows_.data() + neighbours[k + 2] * row_size;
    const double* r3 = rows_.data() + neighbours[k + 3] * row_size;
    Double4 x[4] = {load_quad(r0), load_quad(r1), load_quad(r2), load_quad(r3)};
    Double4 l[4] = {load_quad(r0 + 4), load_quad(r1 + 4), load_quad(r2 + 4), load_quad(r3 + 4)};
    lanes::transpose(x[0], x[1], x[2], x[3]);
    lanes::transpose(l[0], l[1], l[2], l[3]);
    Double4 squared = zero, tilt = zero;
    for (int d = 0; d < Dim; ++d) {
      x[d] -= all(own[d]);
      squared = multiply_add(x[d], x[d], squared);
      tilt = multiply_add(all(own[4 + d]) - l[d], x[d], tilt);
    }
    tilt = lanes::choose(tilt > bound, bound, lanes::choose(tilt < -bound, -bound, tilt));
    const Double4 w = weight(squared, square_root(squared)) * x[3] * (one + tilt);
    moment = multiply_add(w, squared, moment);
    const Double4 s = w * (c_own + l[3]);
    store_quad(conductance_.data() + k, s * scale);
    for (int d = 0; d < Dim; ++d) {
      outward[d] = multiply_add(s, x[d], outward[d]);
    }
  }
  double out[Dim];
  for (int d = 0; d < Dim; ++d) {
    out[d] = lanes::sum(outward[d]);
  }
  double total = lanes::sum(moment);
  if (corrected_ && insulation_.near(i)) {
    total += hide_bonds(i, out);
    total += add_images(i, out);
  }
  // The sweep divides by the diagonal block, sum of s Y Y = 4 on a full lattice.
  for (int d = 0; d < Dim; ++d) {
    correction_[i * Dim + d] = own[4 + d] - damping * 0.25 * out[d];
  }
  if (normalise && total > 0.0) {
    normaliser_[i] = 2.0 * Dim / total;
  }
}

template <int Dim>
double Conductances<Dim>::hide_bonds(Index i, double* out) {
  const double* own = rows_.data() + i * row_size;
  double moment = 0.0;
  for (Index k = families_.wall_begin(i); k < families_.end(i); ++k) {
    const Index j = families_.neighbour(k);
    if (conductance_[k] == 0.0 || !insulation_.hides(i, j)) {
      continue;
    }
    const double* other = rows_.data() + j * row_size;
    const double s = conductance_[k] / (0.5 * conductivity_ * own[3]);
    double squared = 0.0;
    for (int d = 0; d < Dim; ++d) {
      squared += (other[d] - own[d]) * (other[d] - own[d]);
      out[d] -= s * (other[d] - own[d]);
    }
    moment -= s / (own[7] + other[7]) * squared;
    conductance_[k] = 0.0;
  }
  return moment;
}

template <int Dim>
double Conductances<Dim>::image_weight(const Image& image, Index owner) const {
  const Index of = image.bond < 0 ? owner : families_.neighbour(image.bond);
  return weight_(std::sqrt(image.squared)) * rows_[of * row_size + 3];
}

template <int Dim>
double Conductances<Dim>::add_images(Index i, double* out) {
  const double* own = rows_.data() + i * row_size;
  double moment = 0.0;
  for (const Image& image : images(i)) {
    const Index j = image.bond < 0 ? i : families_.neighbour(image.bond);
    const double w = image_weight(image, i);
    const double s = w * (own[7] + rows_[j * row_size + 7]);
    if (image.bond >= 0) {
      conductance_[image.bond] += 0.5 * conductivity_ * s * own[3];
    }
    for (int d = 0; d < Dim; ++d) {
      out[d] += s * image.to[d];
    }
    moment += w * image.squared;
  }
  return moment;
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
