#pragma once

#include <string>

namespace lapilli {

/// Letters and digits kept, everything else one underscore: "force of wall 'a' along x" becomes
/// "force_of_wall_a_along_x".
std::string snake_case(const std::string& words);

}  // namespace lapilli
