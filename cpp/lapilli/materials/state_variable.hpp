#pragma once

#include <string>

namespace lapilli {

/// A number that a solid keeps at every point beside its stress: what it is called in the output,
/// and its unit ("1" without one). It starts at zero.
struct StateVariable {
  std::string name;
  std::string unit;

  bool operator==(const StateVariable&) const = default;
};

/// Most state variables that one solid may have.
inline constexpr int most_state_variables = 8;

}  // namespace lapilli
