#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lapilli {

/// The present name of a key, word or class that earlier versions called `old`; the one that is
/// among `candidates`, empty when `old` never was a name of any of them.
std::string new_name(std::string_view old, const std::vector<std::string>& candidates);

}  // namespace lapilli
