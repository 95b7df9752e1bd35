#pragma once

#include <cstdint>
#include <cstring>

#include "lapilli/core/simd.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli::lanes {

using LaneMask = std::int64_t __attribute__((vector_size(32)));
/// Families are padded to whole quads.
inline constexpr std::int64_t width = 4;

/// a b + c, fused where the processor can.
[[gnu::always_inline]] inline Double4 multiply_add(const Double4& a, const Double4& b,
                                                   const Double4& c) {
#ifdef __FMA__
  return Double4(_mm256_fmadd_pd(__m256d(a), __m256d(b), __m256d(c)));
#else
  return a * b + c;
#endif
}

/// Where `mask` holds `a`, elsewhere `b`.
[[gnu::always_inline]] inline Double4 choose(const LaneMask& mask, const Double4& a,
                                             const Double4& b) {
  return mask ? a : b;
}

[[gnu::always_inline]] inline double sum(const Double4& a) { return (a[0] + a[2]) + (a[1] + a[3]); }

/// exp(x) for x <= 0; lanes below -700 come out as 1e-304. The Taylor polynomial of degree 12 on
/// |f| <= ln(2)/2 leaves 2e-16 of the value, rounding a few units in the last place.
[[gnu::always_inline]] inline Double4 exp_negative(const Double4& argument) {
  const Double4 x = choose(argument < all(-700.0), all(-700.0), argument);
  // x = n ln 2 + f; adding 1.5 2^52 leaves n in the last bits of the sum.
  const Double4 shifted = multiply_add(x, all(1.4426950408889634), all(6755399441055744.0));
  const Double4 n = shifted - all(6755399441055744.0);
  Double4 f = multiply_add(n, all(-6.93147180369123816490e-01), x);
  f = multiply_add(n, all(-1.90821492927058770002e-10), f);
  Double4 p = all(1.0 / 479001600.0);
  for (const double coefficient :
       {1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0,
        1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0}) {
    p = multiply_add(p, f, all(coefficient));
  }
  LaneMask bits, exponent;
  std::memcpy(&bits, &p, sizeof bits);
  std::memcpy(&exponent, &shifted, sizeof exponent);
  bits += exponent << 52;
  Double4 result;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

/// Four rows of four become four columns of four.
[[gnu::always_inline]] inline void transpose(Double4& a, Double4& b, Double4& c, Double4& d) {
  const Double4 ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Double4 ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Double4 cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Double4 cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

}  // namespace lapilli::lanes

#pragma GCC diagnostic pop
