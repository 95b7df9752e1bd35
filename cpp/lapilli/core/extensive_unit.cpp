#include "lapilli/core/extensive_unit.hpp"

namespace lapilli {

std::string extensive_unit(const std::string& in_space, int dimension) {
  if (dimension == 3) {
    return in_space;
  }
  if (in_space == "m^2") {
    return dimension == 2 ? "m" : "";
  }
  if (in_space == "m^3") {
    return dimension == 2 ? "m^2" : "m";
  }
  return in_space + (dimension == 2 ? "/m" : "/m^2");
}

}  // namespace lapilli
