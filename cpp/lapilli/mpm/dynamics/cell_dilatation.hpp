#pragma once

#include <vector>

#include "lapilli/core/large_array.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/geometry/grid.hpp"
#include "lapilli/materials/solid.hpp"
#include "lapilli/mpm/dynamics/dynamics_settings.hpp"

namespace lapilli {

/// Whether points of a solid share the dilatation of their cell, by the setting or, where it is
/// absent, because they keep their volume.
bool averages_dilatation(const DynamicsSettings& settings, const Solid& solid);

/// The material of nearly incompressible bodies in each cell of the grid (numbered by its lowest
/// node), and the one rate of dilatation that it has there (B-bar: Hughes 1980).
///
/// A domain has the share w_pc in a cell. The rate of the cell is the mean over the parts in it of
/// the divergence of linear functions, D_c = sum_I grad N_I(c) . v_I, which their volume and
/// centroid give (and in space their covariance). A point takes D_p = sum w_pc D_c. Forces are the
/// transpose: f_I = - sum_c (sum_p V_p w_pc s_p) grad N_I(c) with the mean stress s_p, so that what
/// they do to the nodes is what the stress does to the strain, and an even stress acts as without
/// means.
template <int Dim>
class CellDilatation {
 public:
  static constexpr int crossed = Dim == 2 ? 0 : 3;  // covariances yz, xz, xy
  static constexpr int sums = 2 + Dim + crossed;    // what points add to

  /// `of_body`: which bodies are averaged.
  explicit CellDilatation(std::vector<char> of_body) : of_body_(std::move(of_body)) {}

  bool of_body(Index body) const { return of_body_[body] != 0; }

  /// Zero the sums of nodes [first, last) and of those before; room for `count` nodes.
  void clear(Index first, Index last, Index count);
  /// From the sums of points (volume, moments, mean stress times volume) to means over the cells.
  void divide();

  double* volume() { return array(0); }                      // m^Dim
  double* middle(int axis) { return array(1 + axis); }       // cells, from the lowest node
  double* cross(int axis) { return array(1 + Dim + axis); }  // cells^2, across `axis`
  double* stress() { return array(sums - 1); }               // Pa m^Dim
  double* rate() { return array(sums); }                     // 1/s
  const double* rate() const { return values_.data() + sums * size_; }

  /// Means of linear functions over the material of one cell.
  class Mean {
   public:
    Mean(const CellDilatation& cells, Index cell) {
      for (int k = 0; k < Dim + crossed; ++k) {
        mean_[k] = cells.values_[(1 + k) * cells.size_ + cell];
      }
    }
    /// Of the slope, per cell, along `axis` of the function of a corner (bit k: its upper side
    /// along axis k).
    double slope(int corner, int axis) const {
      const auto upper = [&](int k) { return ((corner >> k) & 1) != 0; };
      const auto value = [&](int k) { return upper(k) ? mean_[k] : 1.0 - mean_[k]; };
      const int next = (axis + 1) % Dim;
      double mean = value(next);
      if constexpr (Dim == 3) {
        const int last = (axis + 2) % Dim;
        const double covariance = mean_[Dim + axis];
        mean = mean * value(last) + (upper(next) == upper(last) ? covariance : -covariance);
      }
      return upper(axis) ? mean : -mean;
    }

   private:
    double mean_[Dim + crossed];
  };

 private:
  double* array(int which) { return values_.data() + which * size_; }

  std::vector<char> of_body_;
  Index size_ = 0, first_ = 0, last_ = 0;
  LargeArray<double> values_;
};

/// What the dilatation works against, Pa: the mean of the stresses that belong to an axis.
template <int Dim>
double mean_stress(const double* stress) {
  return Dim == 2 ? 0.5 * (stress[0] + stress[1]) : (stress[0] + stress[1] + stress[2]) / 3.0;
}

template <int Dim>
struct DynamicsData;

/// Mean stresses of the averaged points act on the nodes; points must have their places of the
/// step.
template <int Dim>
void add_mean_stress(DynamicsData<Dim>& data);

/// The rate of dilatation of every cell from the nodal velocity that strains the points.
template <int Dim>
void find_mean_dilatation(DynamicsData<Dim>& data);

}  // namespace lapilli
