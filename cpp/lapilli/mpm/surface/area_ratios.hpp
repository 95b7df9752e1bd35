#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lapilli/mpm/surface/nodal_surface.hpp"
#include "lapilli/mpm/surface/shape_areas.hpp"

namespace lapilli {

/// Nodal areas of a few cells lose surface at corners (12 % of a square of four cells, half of a
/// plate of one), and the edge of a region is found to a fraction of a cell. The areas of the
/// shapes at the start make up for both. What bodies lose belongs to them and goes with them: the
/// whole surface of bodies that touch, looked at without the others, is scaled to that of their
/// shapes. What is then still missing of a boundary condition belongs to the place where its region
/// begins, and fades with the square of the share that the surface there at the start has of that
/// of now: a body that has just entered a region does not carry the error of that moment along.
class AreaRatios {
 public:
  /// What the nodes find of some bodies without the others, m^(dim-1).
  struct Found {
    double whole = 0.0;
    std::vector<double> by_condition;
  };

  AreaRatios() = default;
  AreaRatios(const ShapeAreas& wanted,
             const std::function<Found(const std::vector<std::size_t>&)>& found_of);

  /// Scale areas by what the bodies beside them lose.
  template <int Dim>
  void scale(NodalAreas<Dim>& areas, const OutsideCells<Dim>& cells) const;
  /// Scale what a condition finds of those areas now.
  void scale(std::size_t condition, std::span<double> area) const;
  /// The farthest ratio from 1 of area at the start, of shapes over what nodes found.
  double farthest() const;

  void save(Archive& archive, const std::string& name) const;
  void load(const Archive& archive, const std::string& name);
  /// Take over what was saved, of bodies and conditions of these numbers there; -1 for new ones.
  static AreaRatios of_before(const Archive& archive, const std::string& name,
                              const std::vector<int>& body, const std::vector<int>& condition);

 private:
  std::vector<double> of_body_;                   // by body; empty where nothing is known
  std::vector<double> patch_, found_, at_start_;  // by condition
};

/// The points of some bodies.
std::unique_ptr<Points> points_of(const Points& points, const std::vector<std::size_t>& bodies);

}  // namespace lapilli
