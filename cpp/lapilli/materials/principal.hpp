#pragma once

#include "lapilli/core/simd.hpp"

namespace lapilli {

// Isotropic functions of symmetric tensors through their principal values, without branches; Real
// is double or Double4. A function takes sorted values t1 >= t2 >= t3 and returns sorted
// values with the members s1, s2, s3.

/// f of a tensor with components xx, yy, xy and the principal value zz.
/// The plane is exact at equal values: its deviator is scaled, never divided by a gap.
template <class Real, class Function>
inline void apply_plane(const Function& f, Real& xx, Real& yy, Real& zz, Real& xy) {
  const Real mean = 0.5 * (xx + yy), half = 0.5 * (xx - yy);
  const Real radius = square_root(half * half + xy * xy);
  const Real high = mean + radius, low = mean - radius;
  const auto first = zz > high, last = zz < low;
  const Real t1 = first ? zz : high, t3 = last ? zz : low;
  const Real middle = first ? high : zz;
  const Real t2 = last ? low : middle;
  const auto r = f(t1, t2, t3);
  const Real new_high = first ? r.s2 : r.s1, new_low = last ? r.s2 : r.s3;
  const Real outer = first ? r.s1 : r.s2;
  const Real divisor = radius > 0.0 ? radius : as<Real>(1.0);
  const Real scale = 0.5 * (new_high - new_low) / divisor;
  const Real new_mean = 0.5 * (new_high + new_low);
  xx = new_mean + scale * half;
  yy = new_mean - scale * half;
  xy = scale * xy;
  zz = last ? r.s3 : outer;
}

/// The best separated principal value of a deviator of unit size, from the cubic: two Newton steps
/// on a root that is always simple.
template <class Real>
inline Real best_separated(Real ax, Real ay, Real az, Real bx, Real by, Real bz) {
  const Real half_det =
      0.5 * (ax * (ay * az - by * by) - bx * (bx * az - by * bz) + bz * (bx * by - ay * bz));
  const Real sign = half_det < 0.0 ? as<Real>(-1.0) : as<Real>(1.0);
  const Real absolute = sign * half_det;
  const Real r = absolute < 1.0 ? absolute : as<Real>(1.0);
  // Root of x^3 - 3 x = 2 r in [sqrt(3), 2]; the cubic guess is good to 7e-5.
  Real root = 1.7321237 + r * (0.33080867 + r * (-0.08176246 + r * 0.01888723));
  root -= (root * (root * root - 3.0) - 2.0 * r) / (3.0 * (root * root - 1.0));
  root -= (root * (root * root - 3.0) - 2.0 * r) / (3.0 * (root * root - 1.0));
  return sign * root;
}

/// f of a full tensor. The axis of the best separated principal value comes from a cross product;
/// the plane across it is solved as above (Eberly 2014, "A robust eigensolver for 3 x 3 symmetric
/// matrices").
template <class Real, class Function>
inline void apply_full(const Function& f, Real& xx, Real& yy, Real& zz, Real& xy, Real& yz,
                       Real& xz) {
  const Real mean = (xx + yy + zz) * (1.0 / 3.0);
  const Real dx = xx - mean, dy = yy - mean, dz = zz - mean;
  const Real size2 =
      (dx * dx + dy * dy + dz * dz + 2.0 * (xy * xy + yz * yz + xz * xz)) * (1.0 / 6.0);
  const Real size = square_root(size2);
  const Real inverse = 1.0 / (size > 0.0 ? size : as<Real>(1.0));
  const Real ax = dx * inverse, ay = dy * inverse, az = dz * inverse;
  const Real bx = xy * inverse, by = yz * inverse, bz = xz * inverse;
  const Real value = best_separated(ax, ay, az, bx, by, bz);

  // Its axis: the longest cross product of two rows of the deviator minus that value.
  const Real rx = ax - value, ry = ay - value, rz = az - value;
  const Real p0 = ry * rz - by * by, p1 = by * bz - bx * rz, p2 = bx * by - ry * bz;
  const Real q1 = rx * rz - bz * bz, q2 = bz * bx - rx * by, w2 = rx * ry - bx * bx;
  const Real np = p0 * p0 + p1 * p1 + p2 * p2;
  const Real nq = p1 * p1 + q1 * q1 + q2 * q2;
  const Real nw = p2 * p2 + q2 * q2 + w2 * w2;
  const auto take_q = nq > np;
  const Real npq = take_q ? nq : np;
  const auto take_w = nw > npq;
  const Real u0 = take_q ? p1 : p0, u1 = take_q ? q1 : p1, u2 = take_q ? q2 : p2;
  const Real v0 = take_w ? p2 : u0, v1 = take_w ? q2 : u1, v2 = take_w ? w2 : u2;
  const Real norm2 = take_w ? nw : npq;
  const Real scale = 1.0 / square_root(norm2);
  const Real sgn = v0 < 0.0 ? -scale : scale;
  const Real n0 = v0 * sgn, n1 = v1 * sgn, n2 = v2 * sgn;  // n0 >= 0

  // Two axes across it, by the reflection that takes the first axis to -n.
  const Real beta = 1.0 / (1.0 + n0);
  const Real g0 = -n1, g1 = 1.0 - beta * n1 * n1, g2 = -beta * n1 * n2;
  const Real h0 = -n2, h1 = g2, h2 = 1.0 - beta * n2 * n2;
  const Real tn0 = dx * n0 + xy * n1 + xz * n2, tn1 = xy * n0 + dy * n1 + yz * n2,
             tn2 = xz * n0 + yz * n1 + dz * n2;
  const Real tg0 = dx * g0 + xy * g1 + xz * g2, tg1 = xy * g0 + dy * g1 + yz * g2,
             tg2 = xz * g0 + yz * g1 + dz * g2;
  const Real th0 = dx * h0 + xy * h1 + xz * h2, th1 = xy * h0 + dy * h1 + yz * h2,
             th2 = xz * h0 + yz * h1 + dz * h2;
  Real nn = mean + (n0 * tn0 + n1 * tn1 + n2 * tn2);
  Real gg = mean + (g0 * tg0 + g1 * tg1 + g2 * tg2);
  Real hh = mean + (h0 * th0 + h1 * th1 + h2 * th2);
  Real gh = g0 * th0 + g1 * th1 + g2 * th2;
  apply_plane(f, gg, hh, nn, gh);

  xx = nn * n0 * n0 + gg * g0 * g0 + hh * h0 * h0 + 2.0 * gh * g0 * h0;
  yy = nn * n1 * n1 + gg * g1 * g1 + hh * h1 * h1 + 2.0 * gh * g1 * h1;
  zz = nn * n2 * n2 + gg * g2 * g2 + hh * h2 * h2 + 2.0 * gh * g2 * h2;
  xy = nn * n0 * n1 + gg * g0 * g1 + hh * h0 * h1 + gh * (g0 * h1 + g1 * h0);
  yz = nn * n1 * n2 + gg * g1 * g2 + hh * h1 * h2 + gh * (g1 * h2 + g2 * h1);
  xz = nn * n0 * n2 + gg * g0 * g2 + hh * h0 * h2 + gh * (g0 * h2 + g2 * h0);
}

}  // namespace lapilli
