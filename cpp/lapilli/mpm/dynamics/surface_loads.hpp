#pragma once

#include <string>
#include <vector>

#include "lapilli/core/balance.hpp"
#include "lapilli/core/note.hpp"
#include "lapilli/mpm/dynamics/dynamics_data.hpp"
#include "lapilli/mpm/dynamics/load_shares.hpp"
#include "lapilli/mpm/surface/area_ratios.hpp"
#include "lapilli/mpm/surface/nodal_surface.hpp"
#include "lapilli/mpm/surface/surface_conditions.hpp"
#include "lapilli/mpm/surface/surface_view.hpp"
#include "lapilli/mpm/surface/wall_contact.hpp"

namespace lapilli {

/// SurfaceLoads on free surfaces by the virtual flux of Yu & Zhao (2026), section 3.3.2, with nodal
/// areas: a traction gives a node the force A_I t, a pressure -p a_I with the area vector a_I = sum
/// V grad S, so that an even pressure and the even stress it causes balance to rounding at every
/// node, whatever the surface. What rests against a wall is no free surface.
template <int Dim>
class SurfaceLoads {
 public:
  /// Finds the surface at the points' present places. Throws std::invalid_argument when the region
  /// of a law selects none of it.
  SurfaceLoads(const DynamicsData<Dim>& data, const DynamicsProblem<Dim>& problem);

  /// Find the surface and add the force of every law, its mean over a step from `time` on, to the
  /// nodal forces (`increment` before the nodes are solved): a pulse has its impulse in any step.
  void add_forces(DynamicsData<Dim>& data, double time, double step);
  /// Book the work and impulse of the forces over a step, after the nodes are solved.
  void book(const DynamicsData<Dim>& data, double step);

  double work() const;                                          // J, of all laws
  std::vector<Balance::Entry> work_entries() const;             // J, by law
  std::vector<Balance::Entry> impulse_entries(int axis) const;  // N s, by law
  SurfaceView surface() const;
  /// Loads whose region the surface has left.
  std::vector<Note> warnings() const;
  /// What the areas of tractions are scaled by, the farthest from 1.
  double area_ratio() const { return ratios_.farthest(); }

  void save(Archive& archive, const std::string& name) const;
  void load(const Archive& archive, const std::string& name);

 private:
  /// What a law acts on.
  struct Nodes {
    std::vector<Index> node;
    std::vector<Vec<Dim>> area_vector;  // m^(dim-1), outward
    std::vector<double> area;           // m^(dim-1), signed
    std::vector<Vec<Dim>> normal;
    std::vector<Vec3> position;    // on the surface, m
    std::vector<double> value;     // of the law there
    std::vector<Vec<Dim>> force;   // N
    std::vector<Vec<Dim>> shares;  // of the velocity fields, by axis; where there are several
  };

  void go_on(const PointStart& start);
  void compare_with_shapes(const DynamicsData<Dim>& data, const DynamicsProblem<Dim>& problem);
  void project_surface(const DynamicsData<Dim>& data);
  AreaRatios::Found areas_without_others(const DynamicsData<Dim>& data,
                                         const DistanceFunction& distance,
                                         const std::vector<std::size_t>& bodies) const;
  NodalAreas<Dim> free_areas(const Grid<Dim>& grid, const NodalSums<Dim>& sums,
                             const OutsideCells<Dim>& cells) const;
  void find_surface(const DynamicsData<Dim>& data);
  double area_of(std::size_t law) const;
  FieldAreas<Dim> areas_of_fields() const;
  template <class Action>
  void for_each_share(const DynamicsData<Dim>& data, const Nodes& nodes, std::size_t k,
                      const Action& action) const;

  std::vector<DynamicsBoundary> laws_;
  std::vector<Nodes> nodes_;
  std::vector<double> start_area_;  // m^(dim-1), by law
  std::vector<double> work_;        // J, by law
  std::vector<Vec3> impulse_;       // N s, by law
  WallContact<Dim> contact_;
  OutsideCells<Dim> outside_;
  Index version_;  // of the points that outside_ belongs to
  NodalSums<Dim> sums_;
  std::vector<double> scratch_[1 + Dim];  // fraction and area vector, by velocity field
  AreaRatios ratios_;                     // of tractions
};

/// What of the faces of the grid is a wall.
ContactFaces contact_faces(const Walls& walls);

}  // namespace lapilli
