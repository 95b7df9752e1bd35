#pragma once

#include <span>
#include <vector>

#include "lapilli/mpm/quasi_static/point_weights.hpp"

namespace lapilli {

/// The gradients that give nearly incompressible points the dilatation of their cell, the mean over
/// the material in it, instead of their own (B-bar: Hughes 1980). One constraint on the volume a
/// cell is what linear shape functions can meet; one a point locks them. Domains of GIMP take the
/// means of the cells they overlap, by their shares.
template <int Dim>
class MeanDilatation {
 public:
  /// Of the points whose entry in `averaged` (by body) is set. `half_width` as for `PointWeights`,
  /// `volume` in m^Dim, one a point.
  void build(const Grid<Dim>& grid, std::span<const double> position,
             std::span<const double> half_width, std::span<const double> volume,
             std::span<const Index> body, std::span<const char> averaged,
             const PointWeights<Dim>& weights);

  /// At the nodes of the box of a point; null where its own gradients count.
  const Vec<Dim>* of_point(Index point) const {
    return start_.empty() || start_[point] < 0 ? nullptr : of_point_.data() + start_[point];
  }
  /// Where the mean of an averaged point or cell is that of a linear function, m.
  const Vec<Dim>& middle(Index point) const { return middle_of_point_[point]; }
  const Vec<Dim>& middle_of_cell(Index cell) const { return middle_[row_[cell]]; }
  /// From there to a point, m; zero where nothing is averaged. A body force b leaves the linear
  /// part b . arm of the pressure in the cell, which the mean does not see.
  Vec<Dim> arm(Index point) const {
    return arm_.empty() ? Vec<Dim>(Vec<Dim>::Zero()) : arm_[point];
  }
  Vec<Dim> arm(Index cell, const Vec<Dim>& place) const {
    return row_.empty() || row_[cell] < 0 ? Vec<Dim>(Vec<Dim>::Zero())
                                          : Vec<Dim>(place - middle_[row_[cell]]);
  }
  /// At the nodes of a cell; null without averaged material.
  const Vec<Dim>* of_cell(Index cell) const {
    return row_.empty() || row_[cell] < 0 ? nullptr : of_cell_.data() + row_[cell] * nodes;
  }

 private:
  static constexpr Index nodes = 1 << Dim;

  /// `each_part`(point, visit) calls visit(cell, share, middle) for the parts of a point's domain.
  template <class EachPart>
  void average_cells(const Grid<Dim>& grid, std::span<const double> volume,
                     const EachPart& each_part);
  template <class EachPart>
  void hand_to_points(const Grid<Dim>& grid, const PointWeights<Dim>& weights,
                      const EachPart& each_part);

  std::vector<Index> start_;  // of every point, -1: not averaged
  std::vector<Vec<Dim>> of_point_;
  std::vector<Index> row_;  // of every cell, -1: nothing averaged
  std::vector<Vec<Dim>> of_cell_;
  std::vector<Vec<Dim>> middle_;  // of the averaged material of each such cell
  std::vector<Vec<Dim>> arm_, middle_of_point_;
};

}  // namespace lapilli
