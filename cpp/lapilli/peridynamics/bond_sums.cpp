#include "lapilli/peridynamics/bond_sums.hpp"

#include <algorithm>

#include "lapilli/peridynamics/lanes.hpp"

namespace lapilli {

template <int Dim>
BondSums<Dim> sum_bonds(const double* rows, const Families& families, const BondWeight& influence,
                        Index point, double* weights) {
  using lanes::multiply_add;
  constexpr Index row_size = flow_row_size;
  const lanes::BondWeightLanes weight(influence);
  const std::int32_t* neighbours = families.neighbours();
  const double* own = rows + point * row_size;
  const Double4 zero = all(0.0), one = all(1.0);
  const Double4 within = all(influence.horizon * influence.horizon);
  const Double4 tiny = all(1e-20 * influence.horizon * influence.horizon);
  Double4 shape[Dim][Dim], gradient[Dim][Dim], bond[Dim], velocity[Dim], crowding[Dim];
  for (int a = 0; a < Dim; ++a) {
    bond[a] = velocity[a] = crowding[a] = zero;
    for (int b = 0; b < Dim; ++b) {
      shape[a][b] = gradient[a][b] = zero;
    }
  }
  Double4 density = zero, length = zero, count = zero, closest = all(1e200);
  const Index begin = families.begin(point);
  for (Index k = begin; k < families.padded_end(point); k += lanes::width) {
    const double* r0 = rows + neighbours[k] * row_size;
    const double* r1 = rows + neighbours[k + 1] * row_size;
    const double* r2 = rows + neighbours[k + 2] * row_size;
    const double* r3 = rows + neighbours[k + 3] * row_size;
    Double4 x[4] = {load_quad(r0), load_quad(r1), load_quad(r2), load_quad(r3)};
    Double4 u[4] = {load_quad(r0 + 4), load_quad(r1 + 4), load_quad(r2 + 4), load_quad(r3 + 4)};
    lanes::transpose(x[0], x[1], x[2], x[3]);
    lanes::transpose(u[0], u[1], u[2], u[3]);
    Double4 squared = zero;
    for (int d = 0; d < Dim; ++d) {
      x[d] -= all(own[d]);
      u[d] -= all(own[4 + d]);
      squared = multiply_add(x[d], x[d], squared);
    }
    const Double4 r = square_root(squared);
    const Double4 w = weight(squared, r) * x[3];
    store_quad(weights + (k - begin), w);
    density = multiply_add(w, u[3] - all(own[7]), density);
    const lanes::LaneMask counts = (squared < within) & (squared > tiny);
    const Double4 inverse = lanes::choose(counts, one / squared, zero);
    const Double4 present = lanes::choose(counts, one, zero);
    const Double4 push = inverse * inverse * r;
    count += present;
    length = multiply_add(present, r, length);
    const Double4 candidate = lanes::choose(squared > tiny, squared, all(1e200));
    closest = lanes::choose(candidate < closest, candidate, closest);
    for (int a = 0; a < Dim; ++a) {
      const Double4 wa = w * x[a];
      bond[a] += wa;
      velocity[a] = multiply_add(w, u[a], velocity[a]);
      crowding[a] = multiply_add(push, x[a], crowding[a]);
      for (int b = 0; b < Dim; ++b) {
        if (b >= a) {
          shape[a][b] = multiply_add(wa, x[b], shape[a][b]);
        }
        gradient[b][a] = multiply_add(wa, u[b], gradient[b][a]);
      }
    }
  }
  BondSums<Dim> sums;
  for (int a = 0; a < Dim; ++a) {
    sums.bond[a] = lanes::sum(bond[a]);
    sums.velocity[a] = lanes::sum(velocity[a]);
    sums.crowding[a] = lanes::sum(crowding[a]);
    for (int b = 0; b < Dim; ++b) {
      sums.shape(a, b) = lanes::sum(b >= a ? shape[a][b] : shape[b][a]);
      sums.gradient(a, b) = lanes::sum(gradient[a][b]);
    }
  }
  sums.density = lanes::sum(density);
  sums.length = lanes::sum(length);
  sums.count = lanes::sum(count);
  sums.least_squared = std::min(std::min(closest[0], closest[1]), std::min(closest[2], closest[3]));
  return sums;
}

template BondSums<1> sum_bonds<1>(const double*, const Families&, const BondWeight&, Index,
                                  double*);
template BondSums<2> sum_bonds<2>(const double*, const Families&, const BondWeight&, Index,
                                  double*);
template BondSums<3> sum_bonds<3>(const double*, const Families&, const BondWeight&, Index,
                                  double*);

}  // namespace lapilli
