#include "lapilli/core/balance.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {

double Balance::supplied() const {
  double sum = 0.0;
  for (const Entry& entry : entries) {
    sum += entry.in;
  }
  return sum;
}

double Balance::turnover() const {
  double sum = 0.0;
  for (const Entry& entry : entries) {
    sum += std::abs(entry.in);
  }
  return sum;
}

double Balance::residual() const {
  constexpr double least_share = 1e-9;
  const double store = std::max(std::abs(stored), std::abs(initial));
  const double reference = std::max({turnover(), scale, largest, least_share * store});
  return reference > 0.0 ? gap() / reference : 0.0;
}

std::string open_balances(std::span<const Balance> balances) {
  constexpr double rounding = 1e-10;  // of the store, over millions of steps
  std::string wrong;
  for (const Balance& balance : balances) {
    const double store = std::max(std::abs(balance.stored), std::abs(balance.initial));
    const bool closes =
        std::abs(balance.residual()) <= balance.bar || std::abs(balance.gap()) <= rounding * store;
    if (!closes) {
      wrong += message(wrong.empty() ? "" : "\n", "the balance of ", balance.quantity,
                       " does not close: ", balance.gap(), " ", balance.unit, " of ",
                       std::max({balance.turnover(), balance.scale, balance.largest}), " ",
                       balance.unit, " are unaccounted for (residual ", balance.residual(),
                       ", at most ", balance.bar, " is allowed)");
    }
  }
  return wrong;
}

}  // namespace lapilli
