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
/// template over the number type serves one point (double) and four (Double4). Never part of a
/// stored type: load and store go through memory without alignment.
using Double4 = double __attribute__((vector_size(32)));

inline Double4 load_quad(const double* from) {
  Double4 quad;
  std::memcpy(&quad, from, sizeof(Double4));
  return quad;
}

inline void store_quad(double* to, Double4 quad) { std::memcpy(to, &quad, sizeof(Double4)); }

inline Double4 all(double value) { return Double4{value, value, value, value}; }

/// The sums of four quads, each added in the order (0 + 1) + (2 + 3).
inline Double4 sums(Double4 a, Double4 b, Double4 c, Double4 d) {
#ifdef __AVX__
  const Double4 ab = _mm256_hadd_pd(a, b), cd = _mm256_hadd_pd(c, d);
  const Double4 low = _mm256_blend_pd(ab, cd, 0b1100),
                crossed = _mm256_permute2f128_pd(ab, cd, 0x21);
  return low + crossed;
#else
  const auto sum = [](Double4 q) { return (q[0] + q[1]) + (q[2] + q[3]); };
  return Double4{sum(a), sum(b), sum(c), sum(d)};
#endif
}

inline Double4 square_root(Double4 quad) {
#ifdef __AVX__
  return _mm256_sqrt_pd(quad);
#else
  return Double4{std::sqrt(quad[0]), std::sqrt(quad[1]), std::sqrt(quad[2]), std::sqrt(quad[3])};
#endif
}
inline double square_root(double value) { return std::sqrt(value); }

/// A number as `Real`, which is double or Double4.
template <class Real>
inline Real as(double value);
template <>
inline double as<double>(double value) {
  return value;
}
template <>
inline Double4 as<Double4>(double value) {
  return all(value);
}

/// Call body.template operator()<Real>(row) over [begin, end): whole quads first, then the rest one
/// by one.
template <class Body>
void for_quads(int begin, int end, const Body& body) {
  int row = begin;
  for (; row + 4 <= end; row += 4) {
    body.template operator()<Double4>(row);
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
inline Double4 load<Double4>(const double* from) {
  return load_quad(from);
}

inline void store(double* to, double value) { *to = value; }
inline void store(double* to, Double4 value) { store_quad(to, value); }

}  // namespace lapilli

#pragma GCC diagnostic pop
