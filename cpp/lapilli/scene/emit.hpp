#pragma once

#include <string>

#include "lapilli/scene/tree.hpp"

namespace lapilli {

/// A table as TOML: keys in their order, the shortest digits that give a number back, tables of the
/// first two levels as [sections], deeper ones inline. Its topmost value must be a table.
std::string emit_toml(const Tree& tree);

/// A tree as JSON on indented lines.
std::string emit_json(const Tree& tree);

}  // namespace lapilli
