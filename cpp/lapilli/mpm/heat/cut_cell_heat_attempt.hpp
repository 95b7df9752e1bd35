#pragma once

#include <vector>

#include "lapilli/mpm/heat/cut_cell_heat.hpp"

namespace lapilli {

/// One long step of one part that has been computed and not yet taken.
template <int Dim>
struct CutCellHeat<Dim>::Attempt {
  double local = 0.0;           // K, error of this step
  std::vector<double> of_laws;  // J
  double given = 0.0;           // J, by all laws
  double of_sources = 0.0;      // J
  int iterations = 0;

  // Implicit, by unknown:
  SurfaceTerm::Vector end;    // K
  SurfaceTerm::Vector error;  // K, of all steps so far

  // In stages, by place:
  std::vector<double> nodal, nodal_error;  // K, at the end; of this step
  HeatRates rates;                         // at the end
};

}  // namespace lapilli
