#pragma once

#include <string>

namespace lapilli {

/// All bytes of a file. Throws std::invalid_argument naming the file if it cannot be read.
std::string read_bytes(const std::string& path);

}  // namespace lapilli
