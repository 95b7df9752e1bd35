#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#ifdef __AVX__
#include <immintrin.h>
#endif

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {

/// Four doubles worked on at once: arithmetic, comparisons and `mask ? a : b` as for numbers, so a
/// template over the number type serves one point (double) and four (Quad). Never part of a stored
/// type: load and store go through memory without alignment.
using Quad = double __attribute__((vector_size(32)));

inline Quad load_quad(const double* from) {
  Quad quad;
  std::memcpy(&quad, from, sizeof(Quad));
  return quad;
}

inline void store_quad(double* to, Quad quad) { std::memcpy(to, &quad, sizeof(Quad)); }

inline Quad all(double value) { return Quad{value, value, value, value}; }

/// The sums of four quads, each added in the order (0 + 1) + (2 + 3).
inline Quad sums(Quad a, Quad b, Quad c, Quad d) {
#ifdef __AVX__
  const Quad ab = _mm256_hadd_pd(a, b), cd = _mm256_hadd_pd(c, d);
  const Quad low = _mm256_blend_pd(ab, cd, 0b1100), crossed = _mm256_permute2f128_pd(ab, cd, 0x21);
  return low + crossed;
#else
  const auto sum = [](Quad q) { return (q[0] + q[1]) + (q[2] + q[3]); };
  return Quad{sum(a), sum(b), sum(c), sum(d)};
#endif
}

inline Quad square_root(Quad quad) {
#ifdef __AVX__
  return _mm256_sqrt_pd(quad);
#else
  return Quad{std::sqrt(quad[0]), std::sqrt(quad[1]), std::sqrt(quad[2]), std::sqrt(quad[3])};
#endif
}
inline double square_root(double value) { return std::sqrt(value); }

/// A number as `Real`, which is double or Quad.
template <class Real>
inline Real as(double value);
template <>
inline double as<double>(double value) {
  return value;
}
template <>
inline Quad as<Quad>(double value) {
  return all(value);
}

/// Call body.template operator()<Real>(row) over [begin, end): whole quads first, then the rest one
/// by one.
template <class Body>
void for_quads(int begin, int end, const Body& body) {
  int row = begin;
  for (; row + 4 <= end; row += 4) {
    body.template operator()<Quad>(row);
  }
  for (; row < end; ++row) {
    body.template operator()<double>(row);
  }
}

template <class Real>
inline Real load(const double* from);
template <>
inline double load<double>(const double* from) {
  return *from;
}
template <>
inline Quad load<Quad>(const double* from) {
  return load_quad(from);
}

inline void store(double* to, double value) { *to = value; }
inline void store(double* to, Quad value) { store_quad(to, value); }

}  // namespace lapilli

#pragma GCC diagnostic pop
