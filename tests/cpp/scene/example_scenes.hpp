#pragma once

#include <string>

#include "lapilli/core/require.hpp"

namespace lapilli {

/// A coarse ring heated by convection, as a scene file.
inline const std::string ring_scene = R"(
title = "ring"
[grid]
lower = [-5.6, -5.6]
upper = [5.6, 5.6]
cell = 0.4
[[bodies]]
name = "ring"
shape = {kind = "annulus", inner = 1, outer = 5}
material = {kind = "thermal", density = 1, specific_heat = 1, conductivity = 1}
[heat]
[[heat.boundaries]]
kind = "convection"
coefficient = 1
ambient = 1
[time]
end = 1
)";

/// `text` with the first `from` replaced; `from` must be there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  require(at != std::string::npos, "the scene of the test has no ", from);
  return text.replace(at, from.size(), to);
}

/// The message of the std::invalid_argument that action() throws; "no error" without one.
template <class Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace lapilli
