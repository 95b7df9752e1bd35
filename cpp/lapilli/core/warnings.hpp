#pragma once

#include <vector>

#include "lapilli/core/note.hpp"

namespace lapilli {

/// A physics that can say of its state that it is not wrong but not right either.
class Warnings {
 public:
  virtual ~Warnings() = default;
  /// One sentence each; empty: nothing to say.
  virtual std::vector<Note> warnings() const = 0;
};

}  // namespace lapilli
