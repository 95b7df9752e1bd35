#pragma once

#include <utility>

#include "lapilli/core/describe.hpp"
#include "lapilli/peridynamics/lanes.hpp"

namespace lapilli {

/// How much a bond counts, by its length r within the horizon.
enum class Influence {
  gaussian,  // exp(-(r / (horizon / 2))^2)
  unity,     // 1
  spline     // cubic B-spline whose support is the horizon
};

template <>
struct Names<Influence> {
  static constexpr std::pair<Influence, const char*> values[] = {{Influence::gaussian, "gaussian"},
                                                                 {Influence::unity, "unity"},
                                                                 {Influence::spline, "spline"}};
};

/// The weight of a bond: influence times the share of the neighbour that lies in the horizon.
///
/// The share is min(1, (horizon + spacing/2 - r) / spacing): 1 within, 1/2 at the horizon. The
/// paper prints (horizon - spacing/2 - r) / spacing (Eq. 30), which is negative wherever it
/// applies.
struct BondWeight {
  Influence influence = Influence::gaussian;
  double horizon = 0.0;  // m
  double spacing = 0.0;  // m
  bool volume_correction = true;

  double operator()(double length) const;
};

namespace lanes {

/// `BondWeight` on four bonds: squared lengths and lengths in, weights out (0 beyond the horizon).
class BondWeightLanes {
 public:
  explicit BondWeightLanes(const BondWeight& weight)
      : influence_(weight.influence),
        horizon_squared_(all(weight.horizon * weight.horizon)),
        rate_(all(-4.0 / (weight.horizon * weight.horizon))),
        share_offset_(all(weight.volume_correction ? weight.horizon / weight.spacing + 0.5 : 1.0)),
        share_slope_(all(weight.volume_correction ? -1.0 / weight.spacing : 0.0)),
        half_inverse_(all(2.0 / weight.horizon)) {}

  [[gnu::always_inline]] Double4 operator()(const Double4& squared, const Double4& length) const {
    const Double4 one = all(1.0);
    Double4 share = multiply_add(length, share_slope_, share_offset_);
    share = choose(share > one, one, share);
    Double4 value = one;
    if (influence_ == Influence::gaussian) [[likely]] {
      value = exp_negative(squared * rate_);
    } else if (influence_ == Influence::spline) {
      const Double4 q = length * half_inverse_;
      const Double4 far = all(2.0) - q;
      const Double4 near = multiply_add(q * q, multiply_add(q, all(0.75), all(-1.5)), one);
      value = choose(q < one, near, all(0.25) * far * far * far);
    }
    return choose(squared < horizon_squared_, value * share, all(0.0));
  }

 private:
  Influence influence_;
  Double4 horizon_squared_, rate_, share_offset_, share_slope_, half_inverse_;
};

}  // namespace lanes

/// The m of the shape matrix m I on a full square (cubic) lattice: sum of w r^2 V / dimension,
/// m^(dim+2).
double lattice_moment(int dimension, const BondWeight& weight);

}  // namespace lapilli
