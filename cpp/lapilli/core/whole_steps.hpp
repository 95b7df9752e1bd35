#pragma once

namespace lapilli {

/// A physics whose result depends on the size of its steps beyond their accuracy (load steps):
/// times at which somebody looks do not cut them.
class WholeSteps {
 public:
  virtual ~WholeSteps() = default;
};

}  // namespace lapilli
