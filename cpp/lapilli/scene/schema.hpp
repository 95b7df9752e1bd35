#pragma once

#include <string>

namespace lapilli {

/// The JSON Schema (draft 7) of scene files: what editors complete and check TOML files with.
std::string scene_schema();

}  // namespace lapilli
