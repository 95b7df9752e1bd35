#pragma once

#include <string>
#include <vector>

namespace lapilli {

/// A physics that says which bodies are in contact and which are bonded.
class DescribesContacts {
 public:
  virtual ~DescribesContacts() = default;
  /// A few words each; empty with one body.
  virtual std::vector<std::string> contacts() const = 0;
};

}  // namespace lapilli
