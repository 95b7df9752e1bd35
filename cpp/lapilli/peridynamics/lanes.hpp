#pragma once

#include <cstdint>
#include <cstring>

#include "lapilli/core/quad.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli::lanes {

using LaneMask = std::int64_t __attribute__((vector_size(32)));
/// Families are padded to whole quads.
inline constexpr std::int64_t width = 4;

/// a b + c, fused where the processor can.
[[gnu::always_inline]] inline Quad multiply_add(const Quad& a, const Quad& b, const Quad& c) {
#ifdef __FMA__
  return Quad(_mm256_fmadd_pd(__m256d(a), __m256d(b), __m256d(c)));
#else
  return a * b + c;
#endif
}

/// Where `mask` holds `a`, elsewhere `b`.
[[gnu::always_inline]] inline Quad choose(const LaneMask& mask, const Quad& a, const Quad& b) {
  return mask ? a : b;
}

[[gnu::always_inline]] inline double sum(const Quad& a) { return (a[0] + a[2]) + (a[1] + a[3]); }

/// exp(x) for x <= 0; lanes below -700 come out as 1e-304. The Taylor polynomial of degree 12 on
/// |f| <= ln(2)/2 leaves 2e-16 of the value, rounding a few units in the last place.
[[gnu::always_inline]] inline Quad exp_negative(const Quad& argument) {
  const Quad x = choose(argument < all(-700.0), all(-700.0), argument);
  // x = n ln 2 + f; adding 1.5 2^52 leaves n in the last bits of the sum.
  const Quad shifted = multiply_add(x, all(1.4426950408889634), all(6755399441055744.0));
  const Quad n = shifted - all(6755399441055744.0);
  Quad f = multiply_add(n, all(-6.93147180369123816490e-01), x);
  f = multiply_add(n, all(-1.90821492927058770002e-10), f);
  Quad p = all(1.0 / 479001600.0);
  for (const double coefficient :
       {1.0 / 39916800.0, 1.0 / 3628800.0, 1.0 / 362880.0, 1.0 / 40320.0, 1.0 / 5040.0, 1.0 / 720.0,
        1.0 / 120.0, 1.0 / 24.0, 1.0 / 6.0, 0.5, 1.0, 1.0}) {
    p = multiply_add(p, f, all(coefficient));
  }
  LaneMask bits, exponent;
  std::memcpy(&bits, &p, sizeof bits);
  std::memcpy(&exponent, &shifted, sizeof exponent);
  bits += exponent << 52;
  Quad result;
  std::memcpy(&result, &bits, sizeof result);
  return result;
}

/// Four rows of four become four columns of four.
[[gnu::always_inline]] inline void transpose(Quad& a, Quad& b, Quad& c, Quad& d) {
  const Quad ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Quad ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Quad cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Quad cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
  b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
  c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
  d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

}  // namespace lapilli::lanes

#pragma GCC diagnostic pop
