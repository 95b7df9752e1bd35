#pragma once

#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>

namespace lapilli {

/// One message out of parts, each printed as a stream prints it (17 digits kept short).
template <class... Parts>
std::string message(const Parts&... parts) {
  std::ostringstream text;
  text.precision(9);
  (text << ... << parts);
  return text.str();
}

/// Throw std::invalid_argument made of `parts` unless `condition` holds: the caller's mistake.
/// Say what was given, what is allowed and where.
template <class... Parts>
void require(bool condition, const Parts&... parts) {
  if (!condition) [[unlikely]] {
    throw std::invalid_argument(message(parts...));
  }
}

/// A run that went wrong: a point left the grid, a value stopped being finite, an iteration
/// stalled. The simulation adds step and time; the message names point, field and likely cause.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace lapilli
