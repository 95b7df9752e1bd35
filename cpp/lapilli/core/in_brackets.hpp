#pragma once

#include <string>

namespace lapilli {

/// " (name)" behind the key of what may have a name, nothing where it has none.
inline std::string in_brackets(const std::string& name) {
  return name.empty() ? std::string() : " (" + name + ")";
}

}  // namespace lapilli
