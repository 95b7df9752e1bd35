#pragma once

#include <string>

#include "lapilli/core/require.hpp"
#include "lapilli/scene/scene.hpp"
#include "lapilli/scene/tree_reader.hpp"

namespace lapilli {

/// As require(), with file, line and path of the key before the message.
template <class... Parts>
void require_at(bool condition, const Scene& scene, const std::string& path,
                const Parts&... parts) {
  if (!condition) [[unlikely]] {
    require(false, place_text(scene.places.get(), path), path, path.empty() ? "" : " ", parts...);
  }
}

/// Run an action whose messages name the key themselves; put the place in the file before them.
template <class Action>
decltype(auto) in_file(const Scene& scene, const std::string& path, const Action& action) {
  try {
    return action();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(place_text(scene.places.get(), path) + error.what());
  }
}

/// Run an action; put file, line and path before the message of a std::invalid_argument it throws.
template <class Action>
decltype(auto) at_place(const Scene& scene, const std::string& path, const Action& action) {
  try {
    return action();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(
        message(place_text(scene.places.get(), path), path, ": ", error.what()));
  }
}

}  // namespace lapilli
