#pragma once

#include <memory>
#include <vector>

#include "lapilli/geometry/fill.hpp"
#include "lapilli/mpm/transfer/point_start.hpp"
#include "lapilli/scene/stage_scenes.hpp"

namespace lapilli {

/// The state that a scene starts from: bodies go on with the points that they had there, others
/// start as the scene says, and what the scene does not have is gone.
class InitialState {
 public:
  /// Reads the checkpoint of another run that the scene names: bodies of the same name go on.
  /// Throws std::invalid_argument where it cannot be used, or no body of the scene is in it.
  explicit InitialState(const Scene& scene);
  /// The state at the end of the stage before: bodies, obstacles and ids go on.
  InitialState(const StageScene& stage, std::shared_ptr<const Archive> before);

  bool continues(std::size_t body) const { return body_before_[body] >= 0; }
  /// Replace the points of the bodies that go on.
  void replace(std::vector<FilledPoints>& filled) const;
  /// Points of the bodies, with their ids.
  std::unique_ptr<Points> points(const std::vector<FilledPoints>& filled) const;
  /// What these points carry.
  PointStart start(const std::vector<FilledPoints>& filled) const;

 private:
  /// Rows of every body there, in the order of their ids.
  std::vector<std::vector<Index>> rows_by_body() const;
  std::vector<double> spacings() const;
  void find_rows();
  std::vector<Index> ids_of(std::size_t body, const std::vector<FilledPoints>& filled) const;

  std::shared_ptr<const Archive> state_;
  int dimension_;
  bool keeps_ids_ = false;
  bool same_transfer_ = false, at_rest_ = false;
  std::vector<int> body_before_;  // by body here, its number there; -1: none
  std::vector<int> obstacle_before_, load_before_;
  bool same_heat_laws_ = false;
  std::vector<std::vector<Index>>
      rows_;  // of the other run, by body here, in the order of their ids
};

}  // namespace lapilli
