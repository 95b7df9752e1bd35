#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// Points that fill a shape.
struct FilledPoints {
  std::vector<double> position;  // m, rows x dimension
  std::vector<double> volume;    // m^dimension, rows
  int dimension = 0;
  double spacing = 0.0;  // m between neighbours; of a random fill the mean

  std::size_t size() const { return volume.size(); }

  /// Where a point lies; zero along the axes there are not.
  Vec3 place(std::size_t row) const;
  /// Put every point at map(place), a function of Vec3.
  template <class Map>
  void move(const Map& map) {
    for (std::size_t row = 0; row < size(); ++row) {
      const Vec3 to = map(place(row));
      std::copy_n(to.data(), dimension,
                  position.data() + row * static_cast<std::size_t>(dimension));
    }
  }
};

/// The sites that may hold a point: `points_per_axis` in every cell of the background grid, in the
/// middle of equal boxes (0.25 h and 0.75 h for two).
struct Lattice {
  Vec3 lower = Vec3::Zero();  // m, a node of the grid
  double cell = 1.0;          // m
  int points_per_axis = 2;

  double spacing() const { return cell / points_per_axis; }
};

/// How a shape is filled.
struct FillOptions {
  bool clip = false;    // boxes cut by the surface get their exact volume and centroid; points
                        // displaced by jitter stay inside and keep the volume
  double jitter = 0.0;  // fraction of the spacing, 0 to 0.5: largest displacement along each axis
  bool random = false;  // places drawn uniformly; as many as boxes fit, all of one volume
  std::uint64_t seed = 1;         // of jitter and random
  double degrees = 0.0;           // the lattice is turned counter-clockwise (2D; about z in 3D)
  std::vector<double> center;     // m, about this point; empty: the origin
  double smallest_volume = 1e-6;  // clip: boxes filled less than this share join a neighbour
  Bounds within;                  // m, ends of axes along which the shape has none: the grid
  Bounds reach;                   // m, no site further out is looked at
};

/// The checked shape, cut by options.within along axes where it has no end. Throws
/// std::invalid_argument for unusable shapes, lattices and options.
Shape ready_to_fill(const Shape& shape, const Lattice& lattice, const FillOptions& options,
                    int dimension);

/// Points per axis of `points_per_cell`: its root of order `dimension`. Throws
/// std::invalid_argument naming the nearest allowed numbers if that is not whole.
int points_per_axis(int points_per_cell, int dimension);

/// Fill a shape with points.
///
/// By default one point at each lattice site inside the shape, of volume spacing^dimension, in
/// lexicographic order (first axis fastest); the body then ends in a staircase. A site on the
/// surface, to 1e-9 of the spacing, is inside. With `clip` each lattice box gives the part of it in
/// the shape, volume and centroid (box_parts.hpp says how exact).
/// Throws std::invalid_argument for unusable shapes or options, infinite shapes and when no site is
/// inside.
FilledPoints fill(const Shape& shape, const Lattice& lattice, const FillOptions& options,
                  int dimension);

}  // namespace lapilli
