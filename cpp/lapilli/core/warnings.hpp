#pragma once

#include <string>
#include <vector>

namespace lapilli {

/// A physics that can say of its state that it is not wrong but not right either.
class Warnings {
 public:
  virtual ~Warnings() = default;
  /// One sentence each; empty: nothing to say.
  virtual std::vector<std::string> warnings() const = 0;
};

}  // namespace lapilli
