#pragma once

#include <vector>

namespace lapilli {

/// The explicit Runge-Kutta-Chebyshev method of second order (Sommeijer, Shampine & Verwer 1997)
/// for dy/dt = F(t, y) whose rates are real: one step of `count` stages is stable up to about .65
/// count^2 over the fastest rate. With y_0 the start and F_0 its rate,
///   y_1 = y_0 + first h F_0,
///   y_j = (1 - mu - nu) y_0 + mu y_{j-1} + nu y_{j-2} + h (rate F_{j-1} + start F_0).
class ChebyshevStages {
 public:
  struct Stage {
    double mu, nu, rate, start;
    double at;  // share of the step at which its result stands
  };

  explicit ChebyshevStages(int count);

  /// The least count that is stable over `product` = step times fastest rate.
  static int needed(double product);

  double first() const { return first_; }
  /// From the second to the last.
  const std::vector<Stage>& later() const { return later_; }

 private:
  double first_;
  std::vector<Stage> later_;
};

}  // namespace lapilli
