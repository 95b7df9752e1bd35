#pragma once

#include <array>
#include <vector>

#include "lapilli/peridynamics/families.hpp"
#include "lapilli/peridynamics/wall_surface.hpp"

namespace lapilli {

/// The planes of adiabatic walls near each point, and the images that points have in them.
///
/// An adiabatic wall is a mirror: a bond between two points at distances a and b from it has an
/// image of squared length r^2 + 4 a b, the same from both ends. A point in a corner sees up to Dim
/// walls, and images across every set of them (exact where walls meet at right angles). Curved
/// walls are taken as the plane nearest to the point. Which wall it is that a point stands before
/// is told by the wall point nearest to its foot there.
template <int Dim>
class Insulation {
 public:
  /// A bond of one point to an image.
  struct Image {
    Index bond;      // of the point it is the image of; -1: of the owner itself
    double squared;  // m^2, length
    Vec<Dim> to;     // m, from the owner to the image
  };

  Insulation(const Points& points, const WallSurface& walls, const Families& families);

  /// Find the planes near a point where it is now.
  void find(Index point);
  bool near(Index point) const { return count_[static_cast<std::size_t>(point)] > 0; }
  /// The images within `horizon` (m) that `point` sees of fluid points, of walls that are not
  /// adiabatic and of itself.
  void images(Index point, double horizon, std::vector<Image>& found) const;
  /// Whether wall point `other` lies behind an adiabatic wall, as `point` sees it: corners belong
  /// to the mirror, whichever wall their points are counted to.
  bool hides(Index point, Index other) const;

 private:
  struct Plane {
    double distance = 0.0;               // m, of the point from the plane
    Vec<Dim> normal = Vec<Dim>::Zero();  // into the fluid
  };
  using Planes = std::array<Plane, Dim>;

  bool adiabatic(Index point) const;
  /// Whether the wall is adiabatic where `point` stands before it, `ahead` (m) of it along
  /// `normal`: a heated part of it is no mirror, nor are corners that it shares with a wall across
  /// it.
  bool insulated_at_foot(Index point, double ahead, const Vec<Dim>& normal) const;
  /// Which plane of `point` is the wall that another point sees as `plane`; -1: none.
  int same_plane(Index point, const Plane& plane) const;
  void add_images(Index point, Index bond, const Vec<Dim>& to, const Planes& planes,
                  const std::array<double, Dim>& distance, double horizon,
                  std::vector<Image>& found) const;

  const Points& points_;
  const WallSurface& walls_;
  const Families& families_;
  std::vector<Planes> planes_;
  std::vector<char> count_;
};

}  // namespace lapilli
