#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "lapilli/peridynamics/heat.hpp"
#include "lapilli/peridynamics/peridynamic_flow.hpp"
#include "lapilli/peridynamics/wall_velocity.hpp"

// What the two passes over the bonds of a step do with a piece of points.

namespace lapilli {
namespace {

constexpr Index piece = flow_piece;

}  // namespace

template <int Dim>
void PeridynamicFlow<Dim>::update_density(Index task, double step_size) {
  const Index begin = task * piece, end = std::min(points_.size(), begin + piece);
  const Index first = families_.begin(begin);
  bond_weights_.take(task, families_.begin(end) - first);
  double least = most_density_, most = 0.0, closest = 1e200;
  for (Index i = begin; i < end; ++i) {
    double* weights = bond_weights_.of(task) + (families_.begin(i) - first);
    BondSums<Dim> sums = sum_bonds<Dim>(rows_.data(), families_, weight_, i, weights);
    if (fluid(i)) {
      add_wall_velocity(*walls_, families_, rows_.data(), weights, i, sums);
      closest = std::min(closest, sums.least_squared);
    } else if (walls_slide_) {
      // The two fields need the shear along a surface that runs.
      const bool stays = !two_field_ && !walls_->walls()[walls_->wall(i)].settings.moves;
      leave_out_walls(families_, rows_.data(), weights, i, stays, sums);
    }
    if (borne_) {
      // What bears the weight does not diffuse: the fluid would creep after it without end.
      sums.density -= borne_->of_point(i, weights) * fluid_.density / (sound_speed_ * sound_speed_);
    }
    update_point(i, sums, step_size);
    if (dissipation_ && fluid(i)) {
      (*dissipation_)[i] =
          viscous_heating(*walls_, families_, rows_.data(), weights, i, sums, fluid_.viscosity);
    }
    if (fluid(i)) {
      least = std::min(least, density_[i]);
      most = std::max(most, density_[i]);
    }
  }
  piece_least_[task] = least;
  piece_most_[task] = most > 0.0 ? most : least;
  piece_spacing_[task] = std::sqrt(closest);
}

template <int Dim>
void PeridynamicFlow<Dim>::update_point(Index point, const BondSums<Dim>& sums, double step_size) {
  const Mat<Dim> inverse = sums.shape.inverse();
  const Mat<Dim> gradient = sums.gradient * inverse;
  const double old = density_[point];
  const double per_trace = 1.0 / sums.shape.trace();
  // Eq. 26, and the diffusion that smooths sound.
  const double diffusion = settings_.density_diffusion * sound_speed_ * walls_->spacing() * 2.0 *
                           Dim * per_trace * sums.density;
  density_[point] = old + step_size * (diffusion - old * gradient.trace());
  const double p = pressure_(printed_.old_stress ? old : density_[point]);

  Mat<Dim> stress = -p * inverse;
  Vec<Dim> viscous = Vec<Dim>::Zero();
  if (two_field_) {
    stress += fluid_.viscosity * (gradient + gradient.transpose()) * inverse;
    gradient_[point] = gradient;
    inverse_shape_[point] = inverse;
  } else {
    const bool compact = settings_.laplacian == Laplacian::compact;
    const double per_sum = compact ? lattice_constant_ : 2.0 * Dim * per_trace;
    const Vec<Dim> sum = compact ? sums.velocity : Vec<Dim>(sums.velocity - gradient * sums.bond);
    viscous = fluid_.viscosity * per_sum * viscous_share(per_sum, sums.curved) * sum;
  }
  force_.set(point, stress, rows_.data() + point * row_size, viscous, sums.bond);
  if (fluid(point)) {
    // A point that is shifted takes the velocity of the place it comes to, with the second half of
    // the kick; until then the acceleration is free.
    Eigen::Map<Vec<Dim>>(acceleration_.data() + point * Dim) =
        gradient * Eigen::Map<const Vec<Dim>>(shifted_.data() + point * Dim);
    const double mean = sums.count > 0.0 ? sums.length / sums.count : 0.0;
    for (int d = 0; d < Dim; ++d) {
      shift_[point * Dim + d] = mean * mean * sums.crowding[d];
    }
  }
}

template <int Dim>
Vec<Dim> PeridynamicFlow<Dim>::zero_energy(Index point, const double* weights) const {
  const double* own = rows_.data() + point * row_size;
  Vec<Dim> sum = Vec<Dim>::Zero();
  for (Index k = families_.begin(point); k < families_.end(point); ++k) {
    const Index j = families_.neighbour(k);
    const double* other = rows_.data() + j * row_size;
    Vec<Dim> bond, relative;
    for (int d = 0; d < Dim; ++d) {
      bond[d] = other[d] - own[d];
      relative[d] = other[4 + d] - own[4 + d];
    }
    const double scale = 0.5 * weights[k - families_.begin(point)] *
                         (inverse_shape_[point].trace() + inverse_shape_[j].trace());
    sum += scale * (relative - 0.5 * (gradient_[point] + gradient_[j]) * bond);
  }
  return settings_.zero_energy * fluid_.viscosity * sum;
}

template <int Dim>
void PeridynamicFlow<Dim>::accelerate_and_kick(Index task, double step_size) {
  const Index begin = task * piece, end = std::min(points_.size(), begin + piece);
  const Index first = families_.begin(begin);
  for (Index i = begin; i < end; ++i) {
    points_.volume()[i] = mass_[i] / density_[i];
    if (!fluid(i)) {
      continue;
    }
    const double* weights = bond_weights_.of(task) + (families_.begin(i) - first);
    if (settings_.laplacian == Laplacian::zero_energy) {
      force_.add(i, zero_energy(i, weights));
    }
    const Vec<Dim> a = force_(i, families_, weights) / density_[i] + body_force(i);
    for (int d = 0; d < Dim; ++d) {
      velocity_[i * Dim + d] += step_size * a[d] + acceleration_[i * Dim + d];
      acceleration_[i * Dim + d] = a[d];
    }
  }
  piece_fastest_[task] = fastest_squared(begin, end);
  bond_weights_.give_back(task);
}

template void PeridynamicFlow<1>::update_density(Index, double);
template void PeridynamicFlow<1>::accelerate_and_kick(Index, double);
template void PeridynamicFlow<2>::update_density(Index, double);
template void PeridynamicFlow<2>::accelerate_and_kick(Index, double);
template void PeridynamicFlow<3>::update_density(Index, double);
template void PeridynamicFlow<3>::accelerate_and_kick(Index, double);

}  // namespace lapilli
