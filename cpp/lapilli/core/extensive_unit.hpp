#pragma once

#include <string>

namespace lapilli {

/// The unit of an extensive quantity, "J" in space: per metre of depth, "J/m", in two dimensions;
/// per area of the cross-section, "J/m^2", in one.
std::string extensive_unit(const std::string& in_space, int dimension);

}  // namespace lapilli
