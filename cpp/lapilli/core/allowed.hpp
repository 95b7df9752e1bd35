#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/vector.hpp"

namespace lapilli {

/// What a number of this key may be, in words: "above 0 (W/(m K))", "from 0 to 1".
/// Empty where every finite number may stand.
std::string allowed_range(const Key& key);

/// What is wrong with a number of this key: "must be above 0 (m), got -1". Empty when it is finite
/// and in the key's range. The one place where the range of a number is checked.
std::string range_mistake(const Key& key, double value);

/// Throws std::invalid_argument unless `value` is allowed: "<where>: <key> must be above 0 (m), got
/// -1".
void check_range(const Key& key, double value, std::string_view where);

/// How many entries a list of this key holds, in words: "1 to 3 entries", "at least 1 entry".
std::string allowed_length(const Key& key);

/// Throws std::invalid_argument unless a list of `count` entries is allowed.
void check_length(const Key& key, Index count, std::string_view where);

/// The candidate that a user most likely meant by `given`; empty when none is near.
std::string nearest_name(std::string_view given, const std::vector<std::string>& candidates);

/// "unknown key 'celll'; did you mean 'cell'?", or the list of what there is.
std::string unknown_name(std::string_view what, std::string_view given,
                         const std::vector<std::string>& candidates);

}  // namespace lapilli
