#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#ifdef __AVX__
#include <immintrin.h>
#else
#pragma GCC diagnostic ignored "-Wpsabi"  // every function below is inlined: no call passes lanes
#endif

namespace lapilli::lanes {

/// Four doubles worked on at once; families are padded to whole lanes.
using Lanes = double __attribute__((vector_size(32)));
using LaneMask = std::int64_t __attribute__((vector_size(32)));
inline constexpr std::int64_t width = 4;

[[gnu::always_inline]] inline Lanes load(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes, from, sizeof lanes);
  return lanes;
}

[[gnu::always_inline]] inline void store(double* to, const Lanes& lanes) {
  std::memcpy(to, &lanes, sizeof lanes);
}

[[gnu::always_inline]] inline Lanes spread(double value) {
  return Lanes{value, value, value, value};
}

/// a b + c, fused where the processor can.
[[gnu::always_inline]] inline Lanes multiply_add(const Lanes& a, const Lanes& b, const Lanes& c) {
#ifdef __FMA__
  return Lanes(_mm256_fmadd_pd(__m256d(a), __m256d(b), __m256d(c)));
#else
  return a * b + c;
#endif
}

[[gnu::always_inline]] inline Lanes square_root(const Lanes& a) {
#ifdef __AVX__
  return Lanes(_mm256_sqrt_pd(__m256d(a)));
#else
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

/// Where `mask` holds `a`, elsewhere `b`.
[[gnu::always_inline]] inline Lanes choose(const LaneMask& mask, const Lanes& a, const Lanes& b) {
  return mask ? a : b;
}

[[gnu::always_inline]] inline double sum(const Lanes& a) { return (a[0] + a[2]) + (a[1] + a[3]); }

/// exp(x) for x <= 0, to 1e-15 relative; 0 lanes below -700 come out as 1e-304.
[[gnu::always_inline]] inline Lanes exp_negative(const Lanes& argument) {
  const Lanes x = choose(argument < spread(-700.0), spread(-700.0), argument);
  // x = n ln 2 + f; adding 1.5 2^52 leaves n in the last bits of the sum.
  const Lanes shifted = multiply_add(x, spread(1.4426950408889634), spread(6755399441055744.0));
  const Lanes n = shifted - spread(6755399441055744.0);
  Lanes f = multiply_add(n, spread(-6.93147180369123816490e-01), x);
  f = multiply_add(n, spread(-1.90821492927058770002e-10), f);
  Lanes p = spread(1.0 / 39916800.0);
  for (const double coefficient :
       {1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0, 1.0 / 120.0,
        1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0}) {
    p = multiply_add(p, f, spread(coefficient));
  }
  LaneMask bits, exponent;
  std::memcpy(&bits, &p, sizeof bits);
  std::memcpy(&exponent, &shifted, sizeof exponent);
  bits += exponent << 52;
  Lanes result;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

/// Four rows of four become four columns of four.
[[gnu::always_inline]] inline void transpose(Lanes& a, Lanes& b, Lanes& c, Lanes& d) {
  const Lanes ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Lanes ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Lanes cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Lanes cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

}  // namespace lapilli::lanes
