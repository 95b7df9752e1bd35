#include "lapilli/core/ledger.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"

namespace lapilli {

double Ledger::taken_in() const {
  double sum = 0.0;
  for (const Entry& entry : entries) {
    sum += entry.in;
  }
  return sum;
}

double Ledger::turnover() const {
  double sum = 0.0;
  for (const Entry& entry : entries) {
    sum += std::abs(entry.in);
  }
  return sum;
}

double Ledger::residual() const {
  constexpr double least_share = 1e-9;
  const double store = std::max(std::abs(stored), std::abs(initial));
  const double reference = std::max({turnover(), scale, largest, least_share * store});
  return reference > 0.0 ? gap() / reference : 0.0;
}

std::string open_balances(std::span<const Ledger> ledgers) {
  constexpr double rounding = 1e-10;  // of the store, over millions of steps
  std::string wrong;
  for (const Ledger& ledger : ledgers) {
    const double store = std::max(std::abs(ledger.stored), std::abs(ledger.initial));
    const bool closes =
        std::abs(ledger.residual()) <= ledger.bar || std::abs(ledger.gap()) <= rounding * store;
    if (!closes) {
      wrong += message(wrong.empty() ? "" : "\n", "the balance of ", ledger.quantity,
                       " does not close: ", ledger.gap(), " ", ledger.unit, " of ",
                       std::max({ledger.turnover(), ledger.scale, ledger.largest}), " ",
                       ledger.unit, " are unaccounted for (residual ", ledger.residual(),
                       ", at most ", ledger.bar, " is allowed)");
    }
  }
  return wrong;
}

}  // namespace lapilli
