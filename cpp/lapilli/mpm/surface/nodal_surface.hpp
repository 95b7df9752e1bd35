#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lapilli/core/points.hpp"
#include "lapilli/geometry/grid.hpp"
#include "lapilli/mpm/transfer/shape_function.hpp"

namespace lapilli {

/// Signed distance to the bodies of a scene, negative inside; absent when only points are known.
using DistanceFunction = std::function<double(const Vec3&)>;

/// Which cells are outside of the material: neither holes that open between points as they move
/// apart, nor cells that a random fill missed.
///
/// Cells without points are closed by one cell, body by body (so that two bodies one cell apart
/// stay apart), and flooded from the border of the grid and from what was outside before. At the
/// start, an empty cell whose centre lies outside every body is outside too: the hole of a ring,
/// a pore. What the closing covers from the start (a pore or slot of one or two cells) stays
/// outside as long as no point enters; what it covers later, one cell wide between points, was
/// swept by points that lie far apart and is inside.
template <int Dim>
class OutsideCells {
 public:
  OutsideCells(const Grid<Dim>& grid, int bodies) : grid_(grid), bodies_(bodies) {}

  void start(const Points& points, const DistanceFunction& distance);
  void follow(const Points& points);

  /// One flag a cell of the padded grid, zero inside.
  std::span<const unsigned char> flags() const { return outside_; }
  /// The body that has points nearest to a node, within two cells along every axis; -1 where none
  /// has.
  int body_beside(Index node) const;

  void save(Archive& archive, const std::string& name) const;
  void load(const Archive& archive, const std::string& name);

 private:
  void mark_occupied(const Points& points);
  void close();
  /// Each cell combined with its neighbours along every axis.
  template <class Combine>
  void sweep(std::vector<unsigned char>& cells, const Combine& combine);
  void take_in_swept();
  void flood();

  /// Of outside_: outside and open to the closing, or outside though the closing covers it.
  static constexpr unsigned char open = 1, narrow = 2;
  /// Of body_, beside the number of a body: no point, or points of several bodies.
  static constexpr int none = -1, shared = -2;

  Grid<Dim> grid_;
  int bodies_;
  std::vector<unsigned char> occupied_, closed_, outside_;
  std::vector<int> body_;
  std::vector<Index> queue_;
};

/// What the points alone say about the nodes of their surface.
template <int Dim>
struct NodalSums {
  std::vector<double> fraction;       // sum V S / h^dim, every node of the grid
  std::vector<Vec<Dim>> area_vector;  // a_I = sum V grad S = closed integral of S n, m^(dim-1)
};

/// At every node of the grid; `half_width` (cells) of the shape function is by body.
template <int Dim>
NodalSums<Dim> nodal_sums(const Points& points, const Grid<Dim>& grid, ShapeFunction function,
                          std::span<const double> half_width);

/// Area A_I, outward normal and place of every node near the surface. Areas are signed: they suit
/// prescribed fluxes. `positive` holds the same total without negative entries, for laws that
/// depend on the state (a negative area would make those grow).
template <int Dim>
struct NodalAreas {
  std::vector<Index> node;       // increasing
  std::vector<double> area;      // m^(dim-1)
  std::vector<double> positive;  // m^(dim-1)
  std::vector<Vec<Dim>> normal;  // outward, unit or zero
  std::vector<Vec3> position;    // of the node projected to the surface, m
  std::vector<Vec<Dim>> vector;  // a_I = closed integral of S n, m^(dim-1)
  std::vector<Vec<Dim>> weight;  // area = weight . vector: the normal, but for corners
  // By corner_fit, else empty: how alike the area vectors around are, and how far the weight is
  // that of a corner, both from 0 to 1.
  std::vector<double> trust, corner;

  /// Add a node of other areas.
  void append(const NodalAreas& other, std::size_t row);
  /// Sum of the negative areas over the sum of all.
  double negative_share() const;
};

/// Active nodes that touch an outside cell, dilated once.
template <int Dim>
std::vector<Index> surface_nodes(const Grid<Dim>& grid, std::span<const unsigned char> outside,
                                 std::span<const double> fraction);

/// Areas from one smoothed normal a node, A_I = n_I . a_I; with `corner_fit`, from a fitted vector
/// where the surface turns sharply.
template <int Dim>
NodalAreas<Dim> nodal_normal_areas(const Grid<Dim>& grid, const NodalSums<Dim>& sums,
                                   std::vector<Index> nodes, int smoothing, bool corner_fit);

/// One pass of 1/4, 1/2, 1/4 along every axis over values by node. The ends become zero: the grid
/// is padded there.
template <int Dim>
void smooth_nodes(const Grid<Dim>& grid, std::vector<double>& values, std::vector<double>& scratch);

/// Hand every negative area to the nearest positive nodes, keeping the sum.
template <int Dim>
std::vector<double> non_negative_areas(const Grid<Dim>& grid, std::span<const Index> nodes,
                                       std::span<const double> area);

}  // namespace lapilli
