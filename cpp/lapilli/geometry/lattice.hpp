#pragma once

#include <array>

#include "lapilli/geometry/fill.hpp"

namespace lapilli {

/// The sites of a possibly turned lattice that may lie in a shape. Positions in the frame of the
/// lattice ("here") and of the scene ("there") differ by the turn.
class Sites {
 public:
  using Site = std::array<Index, 3>;

  /// `body` must have ends along all axes. Throws std::invalid_argument if there are too many
  /// sites.
  Sites(const Shape& body, const Lattice& lattice, const FillOptions& options, int dimension);

  int dimension() const { return dimension_; }
  double spacing() const { return spacing_; }
  double box_volume() const;
  const Site& first() const { return first_; }
  const Site& last() const { return last_; }

  /// Lower corner of the box around a site, in the frame of the lattice.
  Vec3 corner(const Site& site) const;
  /// The site itself, in the frame of the lattice.
  Vec3 middle(const Site& site) const;
  /// From the frame of the lattice to that of the scene.
  Vec3 to_scene(const Vec3& here) const { return fixed_ + turn_ * (here - fixed_); }
  const Mat3& turn() const { return turn_; }
  /// And back.
  Vec3 to_lattice(const Vec3& there) const { return fixed_ + turn_.transpose() * (there - fixed_); }

  /// Call visit(site) for all, first axis fastest.
  template <class Visit>
  void each(const Visit& visit) const {
    Site site;
    for (site[2] = first_[2]; site[2] <= last_[2]; ++site[2]) {
      for (site[1] = first_[1]; site[1] <= last_[1]; ++site[1]) {
        for (site[0] = first_[0]; site[0] <= last_[0]; ++site[0]) {
          visit(static_cast<const Site&>(site));
        }
      }
    }
  }

 private:
  int dimension_;
  double spacing_;
  Vec3 lower_, fixed_;
  Mat3 turn_;
  Site first_{}, last_{};
};

}  // namespace lapilli
