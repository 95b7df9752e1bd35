#pragma once

#include "lapilli/mpm/dynamics/dynamics_data.hpp"

namespace lapilli {

/// Gives points the mean of the free strain over the material of their cells. The strain of a cell
/// hardly varies across it; a free strain that does would leave a stress of its own, first order in
/// the cell and, as nothing answers it, the larger the less the material gives way. Points keep
/// their own where a cell holds several bodies. Shares of points in cells are those of
/// CellDilatation; points must have their places of the step.
template <int Dim>
void average_free_strain(DynamicsData<Dim>& data);

}  // namespace lapilli
