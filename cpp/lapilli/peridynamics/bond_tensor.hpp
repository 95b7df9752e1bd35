#pragma once

#include <algorithm>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Where the row of a point holds what its conductances need: x y z V | l C, with C symmetric, its
/// entries 11 12 13 22 23 33.
template <int Dim>
struct ConductanceRow {
  static constexpr Index size = Dim == 3 ? 16 : 8;  // doubles
  static constexpr int entries = Dim * (Dim + 1) / 2;
  static constexpr int volume = 3, correction = 4;

  static constexpr int tensor(int entry) {
    constexpr int plane[] = {7, 2, 6};
    return Dim == 3 ? 7 + entry : plane[entry];
  }
  static constexpr int entry(int a, int b) { return a * Dim - a * (a + 1) / 2 + b; }  // a <= b

  /// C where it is the same along all directions.
  static double mean(const double* row) {
    double sum = 0.0;
    for (int d = 0; d < Dim; ++d) {
      sum += row[tensor(entry(d, d))];
    }
    return sum / Dim;
  }
};

/// Improve the entries `c` of a point so that its bonds come nearer to sum of s Y Y = 4 1, s = w V
/// (y . (C_i + C_j) y)(1 + tilt) with y = Y/|Y|; `lacking` is what they miss, `moment` the sum of w
/// V Y^2 (1 + tilt). The block of a point is that of weights which know no direction, under which
/// sum of w (y . A y) Y Y = moment (2 A + tr A 1)/(Dim (Dim + 2)). C stays positive.
template <int Dim>
void improve_tensor(double* c, const Mat<Dim>& lacking, double moment, double damping) {
  using Row = ConductanceRow<Dim>;
  const double scale = damping * Dim / moment, trace = lacking.trace();
  Mat<Dim> tensor;
  for (int a = 0; a < Dim; ++a) {
    for (int b = a; b < Dim; ++b) {
      const double more = 0.5 * (Dim + 2) * lacking(a, b) - (a == b ? 0.5 * trace : 0.0);
      tensor(a, b) = tensor(b, a) = c[Row::entry(a, b)] + scale * more;
    }
  }
  const double whole = 2.0 * Dim / moment;  // of bonds in all directions
  const double mean = tensor.trace() / Dim;
  const Mat<Dim> uneven = tensor - mean * Mat<Dim>::Identity();
  const double kept = std::clamp(mean, 0.5 * whole, 2.0 * whole);
  const double most = 0.5 * kept, size = uneven.norm();
  for (int a = 0; a < Dim; ++a) {
    for (int b = a; b < Dim; ++b) {
      c[Row::entry(a, b)] =
          (a == b ? kept : 0.0) + (size > most ? most / size : 1.0) * uneven(a, b);
    }
  }
}

}  // namespace lapilli
