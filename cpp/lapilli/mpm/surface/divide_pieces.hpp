#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lapilli/mpm/surface/cut_shape.hpp"
#include "lapilli/mpm/surface/wall_contact.hpp"

namespace lapilli {

/// Tells which boundary condition has a place of a body's surface.
template <int Dim>
class SurfaceDivision {
 public:
  static constexpr int nobody = -1;         // no law wants it
  static constexpr int on_wall_label = -2;  // it rests on a wall
  /// Labels below: it rests on another body.
  static constexpr int on_body(std::size_t other) { return -3 - static_cast<int>(other); }
  static constexpr std::size_t body_of(int label) { return static_cast<std::size_t>(-3 - label); }

  /// `bodies` are the shapes of all bodies, of which `own` has the surface; `regions` those of the
  /// laws, null for what is left. A region whose own boundary runs along the surface, at most a
  /// third of a cell below it, has the surface.
  SurfaceDivision(const Grid<Dim>& grid, std::span<const Shape> bodies, std::size_t own,
                  std::vector<const Shape*> regions, const ContactFaces& walls);

  /// Call body(law, piece) for the parts of a piece; at the edge of a region it is cut to a
  /// hundredth of a cell (a tenth in three dimensions).
  template <class Body>
  void divide(const SurfacePiece<Dim>& piece, const Body& body) {
    divide(piece, near_others(piece), cuts, body);
  }
  /// Bodies that were found to touch this one.
  const std::vector<std::size_t>& touching() const { return touching_; }

 private:
  static constexpr int cuts = Dim == 2 ? 6 : Dim == 3 ? 2 : 0;

  template <class Body>
  void divide(const SurfacePiece<Dim>& piece, bool near, int cuts_left, const Body& body) {
    const Vec<Dim> middle = piece.middle();
    const int label = label_at(middle, piece.normal, near);
    bool one = cuts_left == 0 || (!near && !has_regions_);
    if (!one) {
      one = true;
      for (const Vec<Dim>& corner : piece.corners) {
        const Vec<Dim> at = corner + 1e-6 * (middle - corner);
        one = one && label_at(at, piece.normal, near) == label;
      }
    }
    if (one) {
      body(label, piece);
      return;
    }
    for (const SurfacePiece<Dim>& part : piece.parts()) {
      divide(part, near, cuts_left - 1, body);
    }
  }

  bool near_others(const SurfacePiece<Dim>& piece) const;
  int label_at(const Vec<Dim>& at, const Vec<Dim>& normal, bool near);
  bool on_wall(const Vec<Dim>& at, const Vec<Dim>& normal) const;

  const Grid<Dim>& grid_;
  std::span<const Shape> bodies_;
  std::size_t own_;
  std::vector<const Shape*> regions_;
  ContactFaces walls_;
  bool has_regions_ = false;
  std::vector<std::size_t> touching_;
};

}  // namespace lapilli
