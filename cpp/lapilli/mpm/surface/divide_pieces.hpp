#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lapilli/mpm/surface/cut_shape.hpp"
#include "lapilli/mpm/surface/trim_straight.hpp"
#include "lapilli/mpm/surface/wall_contact.hpp"

namespace lapilli {

inline constexpr double contact_gap = 2e-3;  // cells; bodies less apart touch

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

  /// Call body(law, piece) for the parts of a piece. Where labels differ it is halved, at last to a
  /// hundredth of a cell (a thirtieth in three dimensions), and cut along straight lines.
  template <class Body>
  void divide(const SurfacePiece<Dim>& piece, const Body& body) {
    divide(piece, near_others(piece), cuts, body);
  }
  /// What else has the face this far (m) from a place that law number `law` has: the first that is
  /// found, nothing where the law has it all around or the face ends.
  std::optional<int> beside(int law, const Vec<Dim>& at, const Vec<Dim>& normal, double way);
  /// Whether a law may have something else this near (m) to a place.
  bool may_end_near(int law, const Vec<Dim>& at, double way) const;
  /// Bodies that were found to touch this one.
  const std::vector<std::size_t>& touching() const { return touching_; }

 private:
  static constexpr int cuts = Dim == 2 ? 6 : Dim == 3 ? 4 : 0;

  template <class Body>
  void divide(const SurfacePiece<Dim>& piece, bool near, int cuts_left, const Body& body) {
    if (const std::optional<int> label = only_label(piece, near)) {
      body(*label, piece);
    } else if (cuts_left == 0) {
      split(piece, near, body);
    } else {
      for (const SurfacePiece<Dim>& part : piece.parts()) {
        divide(part, near, cuts_left - 1, body);
      }
    }
  }

  /// Cut at the edges of the regions.
  template <class Body>
  void split(SurfacePiece<Dim> piece, bool near, const Body& body) {
    const int label = label_at(piece.middle(), piece.normal, near);
    if (label < nobody || Dim == 1) {
      body(label, piece);
      return;
    }
    for (std::size_t law = 0; law < regions_.size(); ++law) {
      const auto side = [&](double sign) {
        return trim_straight<Dim>(
            piece.corners,
            [&](const Vec<Dim>& at) { return sign * depth_in(law, at, piece.normal, 0.0); }, 0.0);
      };
      const SurfacePiece<Dim> part{side(1.0), piece.normal};
      piece.corners = side(-1.0);
      if (part.corners.size() >= static_cast<std::size_t>(Dim)) {
        body(static_cast<int>(law), part);
      }
      if (piece.corners.size() < static_cast<std::size_t>(Dim)) {
        return;
      }
    }
    body(nobody, piece);
  }

  /// Of the whole piece; nothing where labels differ.
  std::optional<int> only_label(const SurfacePiece<Dim>& piece, bool near);
  /// How far a place lies in the region of a law, m; negative outside. `margin` (cells): how far
  /// beyond its edge a region still counts.
  double depth_in(std::size_t law, const Vec<Dim>& at, const Vec<Dim>& normal, double margin) const;
  bool enters(const Shape& region, const Vec3& place, double from, const Vec3& along) const;
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
