#pragma once

#include <functional>
#include <optional>

#include "lapilli/materials/solid.hpp"

namespace lapilli {

/// Which ratios of lateral to vertical stress the strength of a solid bears.
class BearableK0 {
 public:
  /// The stress at one place by k0, Pa.
  using Stress = std::function<SymmetricTensor(double)>;
  struct Range {
    double lower, upper;  // about the ratio that is borne best
  };

  explicit BearableK0(const Solid& solid) : law_(law_of(solid)) {}

  /// The given ratio where it is borne, to a thousandth of the stress; else the nearest that is;
  /// none where no ratio is borne.
  std::optional<double> nearest(const Stress& stress, double k0) const;
  /// Those that are borne; none where no ratio is.
  std::optional<Range> range(const Stress& stress) const;

 private:
  bool bears(const SymmetricTensor& stress, double slack) const;
  std::optional<double> borne(const Stress& stress) const;
  double edge(const Stress& stress, double inside, double outside) const;

  SolidLaw law_;
};

}  // namespace lapilli
