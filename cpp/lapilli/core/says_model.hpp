#pragma once

#include <string>
#include <vector>

namespace lapilli {

/// A physics that says what it chose to model where the settings leave it open: which bodies are in
/// contact, which share the dilatation of a cell.
class SaysModel {
 public:
  virtual ~SaysModel() = default;
  /// A few words each.
  virtual std::vector<std::string> modelled() const = 0;
};

}  // namespace lapilli
