#pragma once

#include <span>
#include <vector>

#include "lapilli/geometry/grid.hpp"
#include "lapilli/geometry/shape.hpp"
#include "lapilli/mpm/surface/wall_contact.hpp"
#include "lapilli/mpm/transfer/shape_function.hpp"

namespace lapilli {

/// The free surface that each boundary condition has of bodies of known shape, m^(Dim-1); what
/// rests on another body or a wall of the grid is none. `regions` by condition, null for what is
/// left.
template <int Dim>
std::vector<double> areas_of_shapes(const Grid<Dim>& grid, ShapeFunction function,
                                    std::span<const Shape> bodies,
                                    const std::vector<const Shape*>& regions,
                                    const ContactFaces& walls);

/// Nodal areas of a few cells lose surface at corners: 12 % of a square of four cells, half of a
/// plate of one. The ratio of the area of the shape to what the nodes find at the start makes up
/// for it, by condition, and stays as the body moves and deforms.
class AreaRatios {
 public:
  AreaRatios() = default;
  explicit AreaRatios(std::vector<double> of_shapes) : wanted_(std::move(of_shapes)) {}

  /// Whether the start has been looked at, or there is nothing to compare it with.
  bool are_known() const { return wanted_.empty() || !ratio_.empty(); }
  /// Compare with the areas found at the start, by condition, and scale these.
  template <class Nodes>
  void match(std::vector<Nodes>& nodes) {
    for (std::size_t condition = 0; condition < wanted_.size(); ++condition) {
      std::vector<double>& areas = nodes[condition].area;
      ratio_.push_back(ratio_to(wanted_[condition], areas));
      for (double& area : areas) {
        area *= ratio_.back();
      }
    }
  }
  double of(std::size_t condition) const { return ratio_.empty() ? 1.0 : ratio_[condition]; }
  /// The farthest ratio from 1.
  double farthest() const;

  const std::vector<double>& values() const { return ratio_; }
  void restore(std::vector<double> ratios) { ratio_ = std::move(ratios); }

 private:
  static double ratio_to(double wanted, std::span<const double> areas);

  std::vector<double> wanted_, ratio_;
};

}  // namespace lapilli
