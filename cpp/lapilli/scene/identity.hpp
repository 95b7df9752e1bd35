#pragma once

#include <string>
#include <vector>

#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// What makes a scene the same problem: every setting that shapes the state, one by one.
struct SceneIdentity {
  std::string lines;                      // "key<tab>value", one a line
  std::vector<std::string> not_compared;  // keys given as functions, which nothing can compare
};

/// Settings with defaults filled in, arrays and input files by their checksums, and the version. A
/// later end, other output, another title make no other problem.
SceneIdentity identity_of(const Scene& scene);

}  // namespace lapilli
