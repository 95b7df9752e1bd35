#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "lapilli/mpm/dynamics/dynamics_data.hpp"
#include "lapilli/mpm/dynamics/obstacles/contact.hpp"
#include "lapilli/mpm/dynamics/obstacles/freed_nodes.hpp"
#include "lapilli/mpm/dynamics/obstacles/obstacle_surface.hpp"
#include "lapilli/mpm/dynamics/obstacles/point_skins.hpp"
#include "lapilli/mpm/dynamics/obstacles/rigid_motion.hpp"
#include "lapilli/mpm/surface/surface_foot.hpp"

namespace lapilli {

/// One obstacle, the contacts it has in this step and what it has given.
///
/// Contacts are the points nearer than half a cell and their own skin; each acts at its foot
/// on the surface through linear functions, so that the wall is where it is drawn and the lowest
/// row of points carries stress (nodes inside the obstacle take their share of the reaction).
template <int Dim>
class ObstacleContacts {
 public:
  /// `earlier`: which it goes on from in the state of `problem.start`; below 0: none. Throws
  /// std::invalid_argument naming the deepest point that starts inside an obstacle that does not go
  /// on.
  ObstacleContacts(const DynamicsData<Dim>& data, const Obstacle& obstacle, std::string name,
                   const PointSkins& skins, const DynamicsProblem<Dim>& problem, int earlier);

  /// Where points touch it, where they are. None has moved farther than `travelled` (m, since the
  /// start).
  std::vector<SurfaceFoot<Dim>> feet(const DynamicsData<Dim>& data, double travelled) const;
  /// Contacts of the points where they are. No point has moved farther than `travelled` (m, since
  /// the start) plus `reach`.
  void find(const DynamicsData<Dim>& data, double step, double travelled, double reach);
  /// Which of them bear one traction. `is_held`: whether another obstacle is at a place.
  void join_ends(const DynamicsData<Dim>& data, double step, double travelled,
                 const std::function<bool(const Vec3&)>& is_held);
  /// Then, for all obstacles in turn: what they meet at the solved velocity, before any of them has
  /// pushed; ...
  void meet(DynamicsData<Dim>& data);
  /// ... the impulses of the step before; ...
  void begin(DynamicsData<Dim>& data, double step, std::vector<double>& crowd);
  /// ... `contact_sweeps` times better ones; ...
  void sweep(DynamicsData<Dim>& data);
  /// ... and the end: books what the obstacle gave, and returns what became of the energy.
  struct Work {
    double kinetic = 0.0;   // J, added to the nodes after the forces
    double given = 0.0;     // J, by the motion of the obstacle
    double friction = 0.0;  // J, lost along the surface (negative)
    double impact = 0.0;    // J, lost across it
  };
  Work finish(DynamicsData<Dim>& data, double step);
  /// What faces of the grid let go of for its sake.
  void free_nodes(const DynamicsData<Dim>& data, FreedNodes<Dim>& nodes) const;
  /// What they mean for the velocity projected again (MUSL), which only strains: sweeps of all
  /// obstacles, and the end.
  void sweep_second(DynamicsData<Dim>& data);
  void finish_second(DynamicsData<Dim>& data);
  /// After it: the next step starts from the impulses of the present contacts.
  void finish_step();

  RigidMotion& motion() { return motion_; }
  const RigidMotion& motion() const { return motion_; }
  /// Largest speed of the surface at present, m/s.
  double speed() const { return motion_.speed(reach_); }
  /// Whether its surface is at a place.
  bool is_at(const Vec3& x, double size) const { return clearance(x) < 0.25 * size; }

  void save(Archive& archive, const std::string& prefix) const;
  void load(const Archive& archive, const std::string& prefix);

  const std::string& name() const { return name_; }
  const Vec3& force() const { return force_; }      // N, on the obstacle, of the last step
  const Vec3& torque() const { return torque_; }    // N m, about its centre
  const Vec3& impulse() const { return impulse_; }  // N s, given to the bodies since the start
  double work() const { return work_; }             // J, the same
  Index touching() const;                           // contacts that push
  /// Points deeper inside than `depth` (m): how many, and the deepest (row -1: none). No point has
  /// moved farther than `travelled` (m, since the start).
  struct Inside {
    Index count, row;
    double depth;
  };
  Inside inside(const DynamicsData<Dim>& data, double depth, double travelled) const;

 private:
  // Of a point: clearance, the step it belongs to, its impulse (push, drag, felt), and the way
  // until an edge may be near.
  static constexpr int stamp = 1, held = 2, edgeless = 4 + Dim, kept = 5 + Dim;
  static constexpr double bond = 0.5;  // on top of the step, of one that cannot part

  void set_skins(const DynamicsData<Dim>& data, const PointSkins& skins,
                 const DynamicsProblem<Dim>& problem, int earlier);
  void require_nothing_inside(const DynamicsData<Dim>& data) const;
  template <class Found, class Take>
  std::vector<Found> near(const DynamicsData<Dim>& data, const Take& take) const;
  double face_of(const DynamicsData<Dim>& data, Index row) const;
  double skin(const DynamicsData<Dim>& data, Index row) const;
  ObstacleSurface surface() const { return {obstacle_.shape, motion_}; }
  double clearance(const Vec3& x) const { return surface().gap(x); }
  Vec3 normal_at(const Vec3& x) const { return surface().normal(x); }
  bool may_be_near_edge(const DynamicsData<Dim>& data, const Contact<Dim>& contact,
                        double travelled);
  bool place_on_nodes(const DynamicsData<Dim>& data, const Vec<Dim>& place,
                      Contact<Dim>& contact) const;
  Contact<Dim> contact_at(const DynamicsData<Dim>& data, Index row, const Vec3& x, double gap,
                          double step) const;
  void book(std::vector<Contact<Dim>>& contacts, const AxisArrays<Dim>& velocity, double step,
            Work& work);
  void start_from(double scale);
  void keep();

  Obstacle obstacle_;
  std::string name_;
  PointArray skin_;  // m, of the material of points towards it at the start, and their volume then
  std::vector<double> lags_;  // s, by body: what friction needs to feel a change of the push
  RigidMotion motion_;
  double reach_ = 0.0;     // m, from the centre of turning to the farthest surface
  double friction_ = 0.0;  // infinite without slip
  PointArray memory_;
  std::vector<Contact<Dim>> contacts_, light_;
  JointContacts joint_;
  double steps_ = 0.0, last_step_ = 0.0;
  Vec3 force_ = Vec3::Zero(), torque_ = Vec3::Zero(), impulse_ = Vec3::Zero();
  double work_ = 0.0;
};

}  // namespace lapilli
