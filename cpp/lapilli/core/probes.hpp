#pragma once

#include <string>
#include <vector>

#include "lapilli/core/diagnostics.hpp"
#include "lapilli/core/simulation.hpp"

namespace lapilli {

/// A field that is watched at one position, or at one material point.
struct Probe {
  std::string name;
  Vec3 position = Vec3::Zero();  // m, at the start
  std::string field;             // one of Simulation::fields(), or "position"
  bool material_point = false;   // the nearest one at the start
};

/// Reads probes. At a fixed position the field is fitted linearly to the nearest 3^dimension points
/// of the body that is there, so that linear fields come out exactly; where no material is, and of
/// a material point that has left the simulation, the value is NaN. A scalar has one number, "mid";
/// vectors and tensors one for each component, "mid_x", "mid_xy".
class Probes {
 public:
  /// Chooses the material points, of the first `bodies` bodies only.
  Probes(const Simulation& simulation, std::vector<Probe> probes, int bodies);

  bool empty() const { return probes_.empty(); }
  /// The values now. Throws std::invalid_argument, naming the probe, for a field that does not
  /// exist and for a fixed position that no material is at when `at_start`.
  std::vector<Scalar> read(Simulation& simulation, bool at_start = false) const;

 private:
  std::vector<Probe> probes_;
  std::vector<Index> ids_;  // of material points; -1 for fixed positions
  int bodies_;
};

}  // namespace lapilli
