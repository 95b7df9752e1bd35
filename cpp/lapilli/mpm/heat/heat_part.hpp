#pragma once

#include <memory>
#include <span>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/mpm/heat/followers.hpp"
#include "lapilli/mpm/heat/heat_problem.hpp"
#include "lapilli/mpm/heat/shared_stencil.hpp"
#include "lapilli/mpm/heat/surface_term.hpp"

namespace lapilli {

/// One body, or several that touch, as nodal operators integrated over the shapes: nothing passes
/// between parts, however close they lie.
template <int Dim>
struct HeatPart {
  /// The volume that nodes have of one body, for its source.
  struct BodyVolume {
    std::size_t body;
    std::vector<Index> place;
    std::vector<Vec3> position;  // m, in the body
    std::vector<double> volume;  // m^dim
  };

  /// The surface by nodes, those that follow among them.
  struct NodalSurface {
    std::vector<Index> node, place;         // of the grid; of the rows
    std::vector<SurfaceTerm::Trace> trace;  // by law, temperatures at sites from these nodes
  };

  std::vector<std::size_t> bodies;
  std::unique_ptr<NodeRows<Dim>> rows;
  std::unique_ptr<SharedStencil<Dim>> conduction;  // K = integral of grad S . k grad S, W/K
  Followers<Dim> followers;
  std::vector<double> capacity;     // C' by place, J/K; zero for nodes that follow
  std::vector<double> temperature;  // by place, K; followers are kept up to date
  std::vector<BodyVolume> sources;
  std::vector<SurfaceTerm::Part> surface;  // by law, then by resisting contact; columns by unknown
  std::vector<Index> unknown_place;        // nodes near the surface that lead
  NodalSurface nodal;

  // Where properties of a body of the part depend on the temperature or bodies resist each other;
  // empty otherwise. Conduction and capacity above are those of the largest conductivities and the
  // least specific heats.
  std::vector<std::vector<double>> volume;  // by body of the part and place, m^dim, followers' too
  std::vector<std::unique_ptr<SharedStencil<Dim>>> own_conduction;  // by body, of several
};

/// What the assembly found, for the record.
struct SurfaceFound {
  /// Another body that touches this one or lies hardly apart.
  struct NearBody {
    std::size_t other;
    bool touches = false;
    double width = 0.0;          // m, of the widest gap that is hardly one
    double flat = 0.0;           // m^(dim-1), of flat surface before such gaps
    Vec3 middle = Vec3::Zero();  // m, where it is widest
  };

  double area = 0.0;    // m^(dim-1), of all free surface of a body
  double volume = 0.0;  // m^dim
  Index followers = 0, nodes = 0;
  double better = 1.0;   // times that a body it touches conducts better, at most
  double slanted = 0.0;  // m^(dim-1), where it touches such bodies at an angle to the grid
  std::vector<NearBody> near;

  /// Of a condition that comes near to holding the surface.
  struct Ends {
    double area = 0.0;                // m^(dim-1), as drawn
    double lost = 0.0;                // of it, at ends within a face
    double beyond = 0.0;              // of it, outside of the region of the condition
    int held_beside = -1;             // another that holds the surface up to an end of this one
    std::vector<double> lost_beside;  // of what is lost, by the condition beside it, m^(dim-1)
  };
  std::vector<Ends> ends;  // by condition

  /// Where two conditions that hold the surface, or exchange with it, meet.
  struct Meeting {
    int first = 0, second = 0;
    double length = 0.0;                                       // m^(dim-2)
    double first_coefficient = 0.0, second_coefficient = 0.0;  // W/(m^2 K)
  };
  std::vector<Meeting> meetings;
};

/// Of a condition on all bodies, m^(dim-1).
inline double on_all_bodies(std::span<const SurfaceFound> found, std::size_t law,
                            double SurfaceFound::Ends::*part) {
  double sum = 0.0;
  for (const SurfaceFound& body : found) {
    sum += law < body.ends.size() ? body.ends[law].*part : 0.0;
  }
  return sum;
}

/// Two bodies that touch with a resistance.
struct ResistingContact {
  std::size_t first, second;  // bodies
  std::size_t entry;          // of the settings
};

/// Make the parts of a problem whose bodies all have shapes. Throws std::invalid_argument when a
/// law selects no surface, a contact none between its bodies, or an initial temperature is not
/// finite. `contacts` may be null where the problem has none.
template <int Dim>
std::vector<HeatPart<Dim>> make_parts(const Points& points, const HeatProblem<Dim>& problem,
                                      std::vector<SurfaceFound>& found,
                                      std::vector<ResistingContact>* contacts = nullptr);

}  // namespace lapilli
