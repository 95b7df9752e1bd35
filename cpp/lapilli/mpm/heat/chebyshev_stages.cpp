#include "lapilli/mpm/heat/chebyshev_stages.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {
namespace {

constexpr double damping = 2.0 / 13.0;

// Of the interval of stability, 2/3 (1 - 2/15 damping) count^2, what rounding of rates may take.
constexpr double used = 0.95;

}  // namespace

int ChebyshevStages::needed(double product) {
  const double per_square = used * 2.0 / 3.0 * (1.0 - 2.0 / 15.0 * damping);
  return std::max(2, static_cast<int>(std::ceil(std::sqrt(1.0 + product / per_square))));
}

ChebyshevStages::ChebyshevStages(int count) {
  const double w0 = 1.0 + damping / (static_cast<double>(count) * count);
  // Chebyshev's polynomials at w0 and their first two derivatives.
  std::vector<double> t{1.0, w0}, slope{0.0, 1.0}, bend{0.0, 0.0};
  for (int j = 2; j <= count; ++j) {
    t.push_back(2.0 * w0 * t[j - 1] - t[j - 2]);
    slope.push_back(2.0 * t[j - 1] + 2.0 * w0 * slope[j - 1] - slope[j - 2]);
    bend.push_back(4.0 * slope[j - 1] + 2.0 * w0 * bend[j - 1] - bend[j - 2]);
  }
  const double w1 = slope[count] / bend[count];
  std::vector<double> b;
  for (int j = 0; j <= count; ++j) {
    const int k = std::max(j, 2);
    b.push_back(bend[k] / (slope[k] * slope[k]));
  }
  first_ = b[1] * w1;
  double before = 0.0, at = first_;
  for (int j = 2; j <= count; ++j) {
    const double mu = 2.0 * b[j] * w0 / b[j - 1], nu = -b[j] / b[j - 2];
    const double rate = 2.0 * b[j] * w1 / b[j - 1];
    const double start = -(1.0 - b[j - 1] * t[j - 1]) * rate;
    const double next = mu * at + nu * before + rate + start;
    later_.push_back({mu, nu, rate, start, next});
    before = at;
    at = next;
  }
}

}  // namespace lapilli
