#pragma once

#include "lapilli/core/require.hpp"

namespace lapilli {

/// A step that failed and changed nothing: the state before it stands, and is worth writing.
class StepRefused : public RunError {
 public:
  using RunError::RunError;
};

}  // namespace lapilli
