#pragma once

#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/mpm/dynamics/dynamics_data.hpp"

namespace lapilli {

/// What the frictional faces of the grid bear along themselves at every node that they hold:
/// Coulomb's law with the force across that friction feels late (see friction_lag). A node that
/// meets a face anew starts from the force of the step, and one that loses its mass forgets.
template <int Dim>
class WallFriction {
 public:
  explicit WallFriction(const DynamicsData<Dim>& data);

  /// Begin a step: nodes come in ascending order of face, layer and number within each field.
  void begin_step(double step);
  /// The next node, of a field, `number` in the nodal arrays, in layer 0 (on the face) or 1
  /// (outside of it), which the face pushes by `push` N s. Returns what the face may bear along
  /// itself, N s.
  double bear(const DynamicsData<Dim>& data, int field, int face, int layer, Index number,
              double push);

  void save(Archive& archive, const std::string& name) const;
  /// A state without it (of an older version) starts from the forces of the next step.
  void load(const Archive& archive, const std::string& name);

 private:
  std::vector<double> lags_;          // s, by field: of the slowest wave in its bodies
  std::vector<Index> known_, nodes_;  // of the last step and of this one, ascending
  std::vector<double> past_, felt_;   // N, of each: the force across that friction feels
  std::size_t next_ = 0;              // in `known_`
  double step_ = 0.0;                 // s
};

/// Null where no face has friction.
template <int Dim>
std::unique_ptr<WallFriction<Dim>> make_wall_friction(const DynamicsData<Dim>& data);

}  // namespace lapilli
