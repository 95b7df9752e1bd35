#pragma once

#include <stdexcept>

namespace lapilli {

/// A file could not be written or read for a reason outside the scene: a full disk, a missing
/// folder, no permission. The message names the file and the reason.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace lapilli
