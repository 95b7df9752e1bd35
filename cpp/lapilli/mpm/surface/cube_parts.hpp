#pragma once

#include <vector>

#include "lapilli/mpm/surface/plane_fit.hpp"

namespace lapilli {

/// A flat piece of a surface: its place (one dimension), ends (two) or corners in order (three).
template <int Dim>
struct SurfacePiece {
  std::vector<Vec<Dim>> corners;
  Vec<Dim> normal;  // unit, out of the shape

  double area() const;  // m^(Dim-1); 1 in one dimension
  Vec<Dim> middle() const;
  /// Places and weights that integrate over the piece: polynomials of degree 5 along a line,
  /// linear functions over a polygon.
  std::vector<QuadraturePoint<Dim>> quadrature() const;
  /// Parts of half the size.
  std::vector<SurfacePiece> parts() const;
};

/// What a cut leaves of a place, a segment or a convex polygon; too few corners where it leaves
/// none.
template <int Dim>
void clip_piece(std::vector<Vec<Dim>>& corners, const Cut<Dim>& cut);

/// Places and positive weights in the part of the cube that the fit leaves: exact to degree 4 in
/// two dimensions (7 in one), to degree 2 in three.
template <int Dim>
std::vector<QuadraturePoint<Dim>> volume_points(const Cube<Dim>& cube, const PlaneFit<Dim>& fit);

/// The surface of one of the planes inside the cube; no corners where there is none.
template <int Dim>
SurfacePiece<Dim> surface_piece(const Cube<Dim>& cube, const PlaneFit<Dim>& fit, std::size_t plane);

/// The surface inside the cube.
template <int Dim>
std::vector<SurfacePiece<Dim>> surface_pieces(const Cube<Dim>& cube, const PlaneFit<Dim>& fit);

}  // namespace lapilli
