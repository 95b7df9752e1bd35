#pragma once

#include <map>
#include <vector>

#include "lapilli/mpm/heat/cut_bodies.hpp"

namespace lapilli {

/// The cells that several bodies in contact share. Across their interface the flux is continuous,
/// not the slope of the temperature that one set of nodal values carries: each body takes its part
/// of that slope, as layers in series across the interface and side by side along it.
template <int Dim>
class SharedCells {
 public:
  /// `volumes`: by body of the part, the volume that it has of cells (m^dim) by node; `cut`: by
  /// body of the problem.
  SharedCells(const HeatProblem<Dim>& problem, const std::vector<std::size_t>& bodies,
              const std::vector<std::map<Index, double>>& volumes,
              const std::vector<CutBody<Dim>>& cut);

  /// Whether a cell holds bodies of more than one conductivity.
  bool is_shared(Index node) const { return parts_.count(node) != 0; }

  /// The conductivity with which body number `which` of the part enters a shared cell, W/(m K);
  /// `center` (m) of the cell.
  Mat<Dim> conductivity(std::size_t which, Index node, const Vec<Dim>& center) const;

 private:
  struct Part {
    std::size_t which;
    double fraction;
  };

  Mat<Dim> own(std::size_t which) const;
  /// Across the interfaces in a cell.
  Vec<Dim> normal(std::size_t which, Index node, const Vec<Dim>& center) const;

  const HeatProblem<Dim>& problem_;
  const std::vector<std::size_t>& bodies_;
  std::map<Index, std::vector<Part>> parts_;
  std::map<Index, Mat<Dim>> interface_;  // as of CutBody, of all bodies
};

}  // namespace lapilli
