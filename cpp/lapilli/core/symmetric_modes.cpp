#include "lapilli/core/symmetric_modes.hpp"

#include <Eigen/Eigenvalues>

namespace lapilli {

template <int Size>
SymmetricModes<Size> symmetric_modes(const Mat<Size>& matrix) {
  const Eigen::SelfAdjointEigenSolver<Mat<Size>> solver(matrix);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

template SymmetricModes<1> symmetric_modes(const Mat<1>&);
template SymmetricModes<2> symmetric_modes(const Mat<2>&);
template SymmetricModes<3> symmetric_modes(const Mat<3>&);
template SymmetricModes<4> symmetric_modes(const Mat<4>&);

}  // namespace lapilli
