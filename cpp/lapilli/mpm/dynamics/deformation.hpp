#pragma once

#include "lapilli/core/simd.hpp"

namespace lapilli {

// Mid-step strain and rotation of a displacement gradient A = dt grad v, for Real = double or
// Double4.

/// In the plane: strain xx, yy, xy, determinant of 1 + A, cosine and sine of the rotation.
template <class Real>
struct PlaneDeformation {
  Real xx, yy, xy, volume, cosine, sine;

  PlaneDeformation(Real axx, Real axy, Real ayx, Real ayy) {
    const Real cross = axy * ayx, product = axx * ayy;
    volume = 1.0 + (axx + ayy) + (product - cross);
    // (1 + A/2)^-1 in closed form; G = A (1 + A/2)^-1.
    const Real middle = 1.0 / (1.0 + 0.5 * (axx + ayy) + 0.25 * (product - cross));
    const Real half = 0.5 * (product - cross);
    xx = (axx + half) * middle;
    yy = (ayy + half) * middle;
    xy = 0.5 * (axy + ayx) * middle;
    const Real t = 0.25 * (ayx - axy) * middle;  // tangent of half the angle
    const Real scale = 1.0 / (1.0 + t * t);
    cosine = (1.0 - t * t) * scale;
    sine = 2.0 * t * scale;
  }

  /// Turn a symmetric tensor.
  void rotate(Real& sxx, Real& syy, Real& sxy) const {
    const Real cc = cosine * cosine, ss = sine * sine, cs = cosine * sine;
    const Real shear = 2.0 * cs * sxy;
    const Real x = cc * sxx - shear + ss * syy;
    const Real y = ss * sxx + shear + cc * syy;
    sxy = cs * (sxx - syy) + (cc - ss) * sxy;
    sxx = x;
    syy = y;
  }
};

/// In space: strain xx, yy, zz, xy, yz, xz, determinant of 1 + A, and the rotation.
template <class Real>
struct SpaceDeformation {
  Real strain[6];
  Real volume;
  Real q[3][3];

  explicit SpaceDeformation(const Real (&a)[9]) {
    // Invariants of A, then G = ((1 + tr/2) A - A A / 2 + det/4 1) / det(1 + A/2).
    const Real m0 = a[4] * a[8] - a[5] * a[7], m1 = a[3] * a[8] - a[5] * a[6],
               m2 = a[3] * a[7] - a[4] * a[6];
    const Real trace = a[0] + a[4] + a[8];
    const Real second = m0 + (a[0] * a[8] - a[2] * a[6]) + (a[0] * a[4] - a[1] * a[3]);
    const Real det = a[0] * m0 - a[1] * m1 + a[2] * m2;
    volume = 1.0 + trace + second + det;
    const Real middle = 1.0 / (1.0 + 0.5 * trace + 0.25 * second + 0.125 * det);
    const Real first = 1.0 + 0.5 * trace, quarter = 0.25 * det;
    Real g[9];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Real square = a[3 * i] * a[j] + a[3 * i + 1] * a[3 + j] + a[3 * i + 2] * a[6 + j];
        g[3 * i + j] = (first * a[3 * i + j] - 0.5 * square) * middle;
      }
      g[4 * i] += quarter * middle;
      strain[i] = g[4 * i];
    }
    strain[3] = 0.5 * (g[1] + g[3]);
    strain[4] = 0.5 * (g[5] + g[7]);
    strain[5] = 0.5 * (g[2] + g[6]);
    // Cayley transform of the spin: Q = 1 + s ([t] + [t][t]), s = 2 / (1 + t.t).
    const Real x = 0.25 * (g[7] - g[5]), y = 0.25 * (g[2] - g[6]), z = 0.25 * (g[3] - g[1]);
    const Real s = 2.0 / (1.0 + x * x + y * y + z * z);
    q[0][0] = 1.0 - s * (y * y + z * z);
    q[1][1] = 1.0 - s * (x * x + z * z);
    q[2][2] = 1.0 - s * (x * x + y * y);
    q[0][1] = s * (x * y - z);
    q[1][0] = s * (x * y + z);
    q[0][2] = s * (x * z + y);
    q[2][0] = s * (x * z - y);
    q[1][2] = s * (y * z - x);
    q[2][1] = s * (y * z + x);
  }

  /// Turn a symmetric tensor xx, yy, zz, xy, yz, xz.
  void rotate(Real (&s)[6]) const {
    Real p[3][3];
    for (int i = 0; i < 3; ++i) {
      p[i][0] = q[i][0] * s[0] + q[i][1] * s[3] + q[i][2] * s[5];
      p[i][1] = q[i][0] * s[3] + q[i][1] * s[1] + q[i][2] * s[4];
      p[i][2] = q[i][0] * s[5] + q[i][1] * s[4] + q[i][2] * s[2];
    }
    const auto turned = [&](int i, int j) {
      return p[i][0] * q[j][0] + p[i][1] * q[j][1] + p[i][2] * q[j][2];
    };
    s[0] = turned(0, 0);
    s[1] = turned(1, 1);
    s[2] = turned(2, 2);
    s[3] = turned(0, 1);
    s[4] = turned(1, 2);
    s[5] = turned(0, 2);
  }
};

}  // namespace lapilli
