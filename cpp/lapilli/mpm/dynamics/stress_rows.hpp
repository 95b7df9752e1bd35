#pragma once

#include <algorithm>

#include "lapilli/mpm/dynamics/deformation.hpp"
#include "lapilli/mpm/dynamics/stress_update.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {

// What the stress update does with one row of a block (double) or four (Double4).

template <class Real>
Real load_rows(const double* from, int stride);
template <>
inline double load_rows<double>(const double* from, int /*stride*/) {
  return *from;
}
template <>
inline Double4 load_rows<Double4>(const double* from, int stride) {
  return Double4{from[0], from[stride], from[2 * stride], from[3 * stride]};
}

inline void store_rows(double* to, int /*stride*/, double value) { *to = value; }
inline void store_rows(double* to, int stride, Double4 value) {
  to[0] = value[0];
  to[stride] = value[1];
  to[2 * stride] = value[2];
  to[3 * stride] = value[3];
}

/// Running sum, least and largest of rows, in a fixed order.
struct Lanes {
  Double4 plastic = all(0.0), strain = all(0.0), ahead = all(0.0), expansion = all(0.0);
  Double4 least = all(1.0), largest = all(0.0), most = all(0.0);

  void add_strain(Double4 square) { most = square > most ? square : most; }
  void add_strain(double square) { most[0] = std::max(square, most[0]); }
  void add(Double4 work, Double4 strain_work, Double4 ahead_work, Double4 volume, Double4 ratio) {
    plastic += work;
    strain += strain_work;
    ahead += ahead_work;
    least = volume < least ? volume : least;
    largest = ratio > largest ? ratio : largest;
  }
  void add(double work, double strain_work, double ahead_work, double volume, double ratio) {
    plastic[0] += work;
    strain[0] += strain_work;
    ahead[0] += ahead_work;
    least[0] = std::min(volume, least[0]);
    largest[0] = std::max(ratio, largest[0]);
  }
  void add_expansion(Double4 work) { expansion += work; }
  void add_expansion(double work) { expansion[0] += work; }
  StressSums total() const {
    StressSums sums;
    sums.plastic = (plastic[0] + plastic[1]) + (plastic[2] + plastic[3]);
    sums.strain_work = (strain[0] + strain[1]) + (strain[2] + strain[3]);
    sums.work_ahead = (ahead[0] + ahead[1]) + (ahead[2] + ahead[3]);
    sums.expansion = (expansion[0] + expansion[1]) + (expansion[2] + expansion[3]);
    sums.least_volume = std::min({least[0], least[1], least[2], least[3]});
    sums.strain = std::max({most[0], most[1], most[2], most[3]});
    sums.wave_ratio = std::max({largest[0], largest[1], largest[2], largest[3]});
    return sums;
  }
};

/// Turned stress plus the elastic stress of the step. `strain` takes what its double contraction
/// with a stress needs: shear twice.
template <class Real>
Real deform(const ElasticConstants& m, const DeformationBlock<2>& block, int row, Real free_strain,
            Real (&s)[4], Real (&strain)[4]) {
  const PlaneDeformation<Real> step(
      load<Real>(&block.gradient[0][row]), load<Real>(&block.gradient[1][row]),
      load<Real>(&block.gradient[2][row]), load<Real>(&block.gradient[3][row]));
  step.rotate(s[0], s[1], s[3]);
  const double twice = 2.0 * m.shear_modulus;
  const Real mean = m.lambda * (step.xx + step.yy) - (3.0 * m.lambda + twice) * free_strain;
  s[0] += mean + twice * step.xx;
  s[1] += mean + twice * step.yy;
  s[2] += mean;
  s[3] += twice * step.xy;
  strain[0] = step.xx;
  strain[1] = step.yy;
  strain[2] = as<Real>(0.0);
  strain[3] = 2.0 * step.xy;
  return step.volume;
}

template <class Real>
Real deform(const ElasticConstants& m, const DeformationBlock<3>& block, int row, Real free_strain,
            Real (&s)[6], Real (&strain)[6]) {
  Real a[9];
  for (int c = 0; c < 9; ++c) {
    a[c] = load<Real>(&block.gradient[c][row]);
  }
  const SpaceDeformation<Real> step(a);
  step.rotate(s);
  const double twice = 2.0 * m.shear_modulus;
  const Real mean = m.lambda * (step.strain[0] + step.strain[1] + step.strain[2]) -
                    (3.0 * m.lambda + twice) * free_strain;
  for (int c = 0; c < 3; ++c) {
    s[c] += mean + twice * step.strain[c];
    s[c + 3] += twice * step.strain[c + 3];
    strain[c] = step.strain[c];
    strain[c + 3] = 2.0 * step.strain[c + 3];
  }
  return step.volume;
}

/// The stress before the step, turned, on the strain of the step: that of the trial stress less
/// what the step added.
template <class Real, int components>
Real contract(const ElasticConstants& m, const Real (&trial)[components],
              const Real (&strain)[components], Real free_strain) {
  const double twice = 2.0 * m.shear_modulus;
  const Real trace = strain[0] + strain[1] + strain[2];
  const Real mean = m.lambda * trace - (3.0 * m.lambda + twice) * free_strain;
  Real sum = as<Real>(0.0);
  for (int c = 0; c < 3; ++c) {
    sum += (trial[c] - mean - twice * strain[c]) * strain[c];
  }
  for (int c = 3; c < components; ++c) {
    sum += (trial[c] - m.shear_modulus * strain[c]) * strain[c];
  }
  return sum;
}

/// The mean stress of the step on the plastic strain that a return from `trial` to `s` means,
/// J/m^3. With what the strain and free strain of the step store elastically it adds up to their
/// work; the stress reached alone would leave out half of what a first or last step of yield turns
/// over.
template <class Real, int components>
Real dissipation(const ElasticConstants& m, const Real (&trial)[components],
                 const Real (&s)[components], const Real (&strain)[components], Real free_strain) {
  const double twice = 2.0 * m.shear_modulus;
  const double share = m.lambda / (3.0 * m.lambda + twice);
  const Real added =
      m.lambda * (strain[0] + strain[1] + strain[2]) - (3.0 * m.lambda + twice) * free_strain;
  Real drop[components], mean[components];
  for (int c = 0; c < components; ++c) {
    const Real elastic = c < 3 ? added + twice * strain[c] : m.shear_modulus * strain[c];
    drop[c] = trial[c] - s[c];
    mean[c] = s[c] - 0.5 * (elastic - drop[c]);
  }
  const Real pressure = share * (drop[0] + drop[1] + drop[2]);
  const Real normal = mean[0] * (drop[0] - pressure) + mean[1] * (drop[1] - pressure) +
                      mean[2] * (drop[2] - pressure);
  Real shear = mean[3] * drop[3];
  for (int c = 4; c < components; ++c) {
    shear += mean[c] * drop[c];
  }
  return (normal + 2.0 * shear) * (0.5 / m.shear_modulus);
}

/// What has come apart closes first, without stress: grains that have flown do not press on each
/// other before they touch. (The volume correction of Tampubolon et al. 2017, ACM TOG 36:105.)
template <class Real, int components>
void close_gap(const ElasticConstants& m, const Real (&strain)[components], Real& opened,
               Real& free_strain, Real (&s)[components]) {
  const Real squeezing = -(strain[0] + strain[1] + strain[2]);
  const Real least = squeezing < opened ? squeezing : opened;
  const Real closing = least > 0.0 ? least : as<Real>(0.0);
  const Real third = closing * (1.0 / 3.0);
  opened -= closing;
  free_strain -= third;
  const Real pressure = (3.0 * m.lambda + 2.0 * m.shear_modulus) * third;
  s[0] += pressure;
  s[1] += pressure;
  s[2] += pressure;
}

/// Volume strain that opens where nothing holds a point together: all of its principal stresses are
/// at what it bears in tension.
template <class Number, class Real, int components>
Real parted(const ElasticConstants& m, Number parts_at, const Real (&trial)[components],
            const Real (&s)[components]) {
  const double bulk = 3.0 * m.lambda + 2.0 * m.shear_modulus;
  const Real trace = s[0] + s[1] + s[2];
  const Real strain = (trial[0] + trial[1] + trial[2] - trace) * (1.0 / bulk);
  const Real opening = strain > 0.0 ? strain : as<Real>(0.0);
  return trace >= 3.0 * parts_at - 1e-12 * bulk ? opening : as<Real>(0.0);
}

}  // namespace lapilli

#pragma GCC diagnostic pop
