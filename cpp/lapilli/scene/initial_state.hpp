#pragma once

#include <memory>
#include <vector>

#include "lapilli/geometry/fill.hpp"
#include "lapilli/mpm/dynamics/point_start.hpp"
#include "lapilli/scene/scene.hpp"

namespace lapilli {

/// The checkpoint of another run that a scene starts from: bodies of the same name go on with the
/// points of that run, others start as the scene says, and what the scene does not name is gone.
class InitialState {
 public:
  /// Reads the checkpoint that the scene names. Throws std::invalid_argument where it cannot be
  /// used, or no body of the scene is in it.
  explicit InitialState(const Scene& scene);

  bool continues(std::size_t body) const { return !rows_[body].empty(); }
  /// Replace the points of the bodies that go on.
  void replace(std::vector<FilledPoints>& filled) const;
  /// What these points carry, for ids counted over the bodies of `filled`.
  std::shared_ptr<const PointStart> points(const std::vector<FilledPoints>& filled) const;

 private:
  std::shared_ptr<const Archive> state_;
  int dimension_;
  bool same_transfer_ = false;
  std::vector<std::vector<Index>> rows_;  // of the other run, by body, in the order of their ids
};

}  // namespace lapilli
