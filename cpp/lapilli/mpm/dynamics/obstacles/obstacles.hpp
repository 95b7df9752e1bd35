#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lapilli/core/balance.hpp"
#include "lapilli/core/note.hpp"
#include "lapilli/mpm/dynamics/obstacles/obstacle_contacts.hpp"
#include "lapilli/mpm/dynamics/solve_nodes.hpp"

namespace lapilli {

/// All obstacles of a scene, in the order of a momentum step.
template <int Dim>
class Obstacles {
 public:
  Obstacles(const DynamicsData<Dim>& data, const DynamicsProblem<Dim>& problem);

  /// Push what the forces accelerated out of the obstacles. Points must be where the nodes act on
  /// them; none is faster than `speed`. Changes velocity and increment of the nodes, and the sums.
  void push(DynamicsData<Dim>& data, const Step& step, double speed, NodeSums& sums);
  /// What faces of the grid let go of in this step.
  const FreedNodes<Dim>& freed() const { return freed_; }
  /// What that means for the velocity projected again (MUSL): its strain is that of the solved
  /// nodes, or confined bodies would gain energy.
  void push_second(DynamicsData<Dim>& data);
  /// Where points touch one of them.
  std::vector<SurfaceFoot<Dim>> feet(const DynamicsData<Dim>& data, std::size_t obstacle) const {
    return each_[obstacle]->feet(data, travelled_);
  }
  /// Move the obstacles to the end of the step, in which points moved at most `moved`; `ahead`:
  /// from the middle of it. `damping`: share of local damping.
  void finish_step(const Step& step, double moved, bool ahead, double damping);

  double speed() const;                    // m/s, largest of any surface
  double given() const { return given_; }  // J, by the motion of all since the start
  Vec3 impulse() const;                    // N s, given to the bodies since the start
  /// Of material that has passed into them.
  std::vector<Note> warnings(const DynamicsData<Dim>& data) const;
  std::vector<std::pair<std::string, double>> diagnostics() const;
  std::vector<Balance::Entry> work_entries() const;
  std::vector<Balance::Entry> impulse_entries(int axis) const;

  void save(Archive& archive, const std::string& prefix) const;
  void load(const Archive& archive, const std::string& prefix);

 private:
  void solve(DynamicsData<Dim>& data, double step);

  PointSkins skins_;
  std::vector<std::unique_ptr<ObstacleContacts<Dim>>> each_;
  FreedNodes<Dim> freed_;
  std::vector<double> crowd_;        // scratch over the nodes
  std::vector<double> before_[Dim];  // nodal velocity before the impulses
  double travelled_ = 0.0;           // m, a bound for every point and surface since the start
  double given_ = 0.0;
};

}  // namespace lapilli
