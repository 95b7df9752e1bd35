#pragma once

#include <vector>

#include "lapilli/core/note.hpp"
#include "lapilli/core/physics.hpp"

namespace lapilli {

/// A physics that can say of its state that it is not wrong but not right either.
class Warnings {
 public:
  virtual ~Warnings() = default;
  /// One sentence each; empty: nothing to say.
  virtual std::vector<Note> warnings() const = 0;
};

/// What any physics says; nothing where it cannot.
inline std::vector<Note> warnings_of(const Physics& physics) {
  const auto* warner = dynamic_cast<const Warnings*>(&physics);
  return warner != nullptr ? warner->warnings() : std::vector<Note>();
}

}  // namespace lapilli
