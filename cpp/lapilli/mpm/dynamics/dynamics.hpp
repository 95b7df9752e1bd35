#pragma once

#include <memory>
#include <vector>

#include "lapilli/core/says_model.hpp"
#include "lapilli/core/stores_in_points.hpp"
#include "lapilli/core/warnings.hpp"
#include "lapilli/mpm/dynamics/contacts/body_contacts.hpp"
#include "lapilli/mpm/dynamics/dynamics_data.hpp"
#include "lapilli/mpm/dynamics/energy_watch.hpp"
#include "lapilli/mpm/dynamics/obstacles/obstacles.hpp"
#include "lapilli/mpm/dynamics/open_energy.hpp"
#include "lapilli/mpm/dynamics/solve_nodes.hpp"
#include "lapilli/mpm/dynamics/surface_loads.hpp"

namespace lapilli {

/// Explicit dynamics balance of material points in plane strain (Dim = 2, per metre of depth) or
/// space. Owns velocity and stress, and moves the points.
template <int Dim>
class Dynamics final : public Physics,
                       public HasSurface,
                       public Warnings,
                       public SaysModel,
                       public StoresInPoints {
 public:
  /// Throws std::invalid_argument for settings, materials or points out of range.
  Dynamics(Points& points, const DynamicsProblem<Dim>& problem);

  std::string name() const override { return "dynamics"; }
  StepLimit step_limit() const override;
  StepReport advance(const Step& step) override;
  void refresh_output() override;
  std::vector<Field> fields() override;
  std::vector<Balance> balances() const override;
  std::vector<double> stored_in(std::span<const Index> rows) const override;
  void release(std::span<const Index> rows) override;
  SurfaceView surface() const override;
  void save(Archive& archive) const override;
  void load(const Archive& archive) override;
  std::vector<std::pair<std::string, double>> diagnostics() const override;
  /// Settings that make the answer depend on the numerics, and points that are gone.
  std::vector<Note> warnings() const override;
  std::vector<std::string> modelled() const override;

  // Handles for other physics. Asking for one allocates it; call before the first step.

  /// Incremental deformation gradient of the last step minus one, Dim x Dim a row.
  const PointArray& incremental_deformation();
  /// Let a gradient of another physics, Dim a row, turn and stretch with the points: the only one
  /// they carry.
  void turn(PointArray& gradient) { data_.turned = &gradient; }
  /// Heat that plastic work left in each point since its owner last set it to zero, J.
  PointArray& plastic_work();
  /// Isotropic free strain (of heat, of moisture) that the next step shall contain; taken as it is
  /// and left for its owner to set again.
  PointArray& free_strain();

  /// Whether bodies have nodes of their own where they meet.
  bool has_contacts() const { return contacts_ != nullptr; }
  const NodeFields<Dim>& node_fields() const { return data_.fields; }
  /// Where bodies touch, kept from here on.
  FindTouches touches();
  /// Where points touch an obstacle of this number.
  std::vector<SurfaceFoot<Dim>> feet(std::size_t obstacle) const {
    return obstacles_->feet(data_, obstacle);
  }

  const PointArray& velocity() const { return data_.velocity; }  // m/s
  const PointArray& stress() const { return data_.stress; }      // Pa; xx yy zz xy (yz xz)
  const PointArray& mass() const { return data_.mass; }          // kg
  double speed() const { return speed_; }                        // m/s, of the fastest point

  /// Angular momentum about the origin, affine part included, kg m2/s.
  Vec3 angular_momentum() const;

 private:
  /// Everything that has passed through an account since the start.
  struct Flows {
    double plastic = 0.0, friction = 0.0, impact = 0.0, transfer = 0.0;  // J, taken out
    double strain = 0.0;           // J, taken from the nodes and not given to the points
    double expansion = 0.0;        // J, given by free strain
    double damping = 0.0;          // J, by local damping
    double gravity_changes = 0.0;  // J, given by a gravity that varies in time
    Vec3 gravity = Vec3::Zero(), walls = Vec3::Zero(), damped = Vec3::Zero();  // N s, given
  };

  /// What points that left the grid took along since the start.
  struct Removed {
    double points = 0.0, mass = 0.0;  // kg
    double energy = 0.0;              // J
    Vec3 momentum = Vec3::Zero();     // N s
  };

  void start_affine(const DynamicsProblem<Dim>& problem);
  void keep_order(double step);
  void turn_gravity(const Step& step);
  NodeSums solve_nodes(const Step& step);
  PointSums move_points(double step);
  /// Enter what a step did into the accounts.
  void book(double step, const NodeSums& nodes, const PointSums& sums, double load_work);
  double local_damping(double time) const;
  const FreedNodes<Dim>* freed_nodes() const { return obstacles_ ? &obstacles_->freed() : nullptr; }
  void carry_points();
  void stop_if_broken(const PointSums& sums) const;
  void find_outside();
  void book_waiting(double step);
  // What a checkpoint keeps, in its order; Self is const to save.
  template <class Self, class Visit>
  static void for_each_point_array(Self& self, const Visit& visit);
  template <class Self, class Visit>
  static void for_each_part(Self& self, const Visit& visit);
  template <class Self, class Visit>
  static void for_each_number(Self& self, const Visit& visit);
  void save_removed(Archive& archive) const;
  void save_setting(Archive& archive) const;
  void load_removed(const Archive& archive);
  Balance energy_balance() const;
  double kinetic_energy_of(Index row) const;
  double elastic_energy_of(Index row) const;
  void watch_energy(const PointSums& sums);
  /// J, that are no gain of energy: what strains of 1e-8 store.
  double rounding() const { return 1e-16 * total_mass_ * wave_speed_ * wave_speed_; }
  double energy_gained() const;
  double shaking_step() const;
  double kinetic_energy() const;
  double potential_energy() const;
  double elastic_energy_stored() const;
  double elastic_strain() const;
  void look_at_energy(OpenEnergy& open) const;
  OpenEnergy energy_looked_at() const;
  Vec3 linear_momentum() const;

  DynamicsData<Dim> data_;
  std::unique_ptr<SurfaceLoads<Dim>> loads_;          // null without boundaries
  std::unique_ptr<Obstacles<Dim>> obstacles_;         // null without any
  std::unique_ptr<BodyContacts<Dim>> contacts_;       // null where all bodies are one
  std::unique_ptr<WallFriction<Dim>> wall_friction_;  // null where no wall has any
  std::vector<std::string> described_contacts_;
  std::vector<Note> start_notes_;  // of bodies that start anew
  std::vector<double> spacing_;    // m, of the points of each body
  Flows flows_;
  Removed removed_;
  EnergyWatch watch_;
  OpenEnergy open_energy_;
  double total_mass_ = 0.0;
  double initial_energy_ = 0.0, kinetic_ = 0.0;  // J
  Vec3 initial_momentum_ = Vec3::Zero();
  double speed_ = 0.0, wave_speed_ = 0.0;  // m/s, largest
  double ahead_ = 0.0;                     // J, of the strain before the force that answers it
  double strain_rate_ = 0.0;               // 1/s, largest of a point
  double drift_ = 0.0;                     // m, since the points were sorted
  Index ordering_ = -1;
  std::vector<double> output_stress_, output_density_;
};

/// The momentum solver of a problem.
template <int Dim>
std::unique_ptr<Dynamics<Dim>> make_dynamics(Points& points, const DynamicsProblem<Dim>& problem);

}  // namespace lapilli
