#pragma once

#include <string>
#include <string_view>

#include "lapilli/scene/tree.hpp"

namespace lapilli {

/// The tree of a TOML text; `name` is the file's name in messages.
/// Throws std::invalid_argument with name, line and column where the text is no TOML.
Tree parse_toml(std::string_view text, const std::string& name);

/// The whole of a file. Throws std::invalid_argument when it is missing, no regular file, or
/// unreadable.
std::string read_text(const std::string& path);

}  // namespace lapilli
