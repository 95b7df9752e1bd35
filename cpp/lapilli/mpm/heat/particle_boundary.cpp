#include "lapilli/mpm/heat/particle_boundary.hpp"

#include <cmath>
#include <unordered_map>

namespace lapilli {
namespace {

/// Points in bins of the size of the largest point's box: a free face has no point in the box
/// beyond it.
template <int Dim>
class PointBins {
 public:
  PointBins(const Points& points, const Vec<Dim>& origin) : points_(points), origin_(origin) {
    for (Index row = 0; row < points.size(); ++row) {
      size_ = std::max(size_, std::pow(points.volume()[row], 1.0 / Dim));
    }
    for (Index row = 0; row < points.size(); ++row) {
      bins_[bin_of(points.position<Dim>(row))].push_back(row);
    }
  }

  /// Whether a point but `self` lies in the box about `centre`.
  bool is_occupied(const Vec<Dim>& centre, Index self, double half) const {
    constexpr int block = Dim == 1 ? 3 : Dim == 2 ? 9 : 27;
    for (int b = 0; b < block; ++b) {
      Vec<Dim> at = centre;
      for (int axis = 0, rest = b; axis < Dim; ++axis, rest /= 3) {
        at[axis] += (rest % 3 - 1) * size_;
      }
      const auto found = bins_.find(bin_of(at));
      if (found == bins_.end()) {
        continue;
      }
      for (const Index other : found->second) {
        const Vec<Dim> way = points_.position<Dim>(other) - centre;
        if (other != self && way.cwiseAbs().maxCoeff() < half * 1.001) {
          return true;
        }
      }
    }
    return false;
  }

 private:
  Index bin_of(const Vec<Dim>& x) const {
    Index bin = 0;
    for (int axis = Dim - 1; axis >= 0; --axis) {
      bin = (bin << 20) + static_cast<Index>((x[axis] - origin_[axis]) / size_) + 4;
    }
    return bin;
  }

  const Points& points_;
  Vec<Dim> origin_;
  double size_ = 0.0;
  std::unordered_map<Index, std::vector<Index>> bins_;
};

}  // namespace

template <int Dim>
NodalAreas<Dim> particle_areas(const Points& points, const HeatProblem<Dim>& problem) {
  const PointBins<Dim> bins(points, problem.grid.origin());
  NodalAreas<Dim> areas;
  for (Index row = 0; row < points.size(); ++row) {
    const Vec<Dim> x = points.position<Dim>(row);
    const double size = std::pow(points.volume()[row], 1.0 / Dim);
    // Free faces add up to the normal; the face's own share is its component along the normal.
    Vec<Dim> open = Vec<Dim>::Zero();
    int faces = 0;
    for (int axis = 0; axis < Dim; ++axis) {
      for (const int side : {-1, 1}) {
        Vec<Dim> beyond = x;
        beyond[axis] += side * size;
        if (!bins.is_occupied(beyond, row, 0.5 * size)) {
          open[axis] += side;
          ++faces;
        }
      }
    }
    if (faces == 0 || open.squaredNorm() == 0.0) {
      continue;
    }
    const Vec<Dim> normal = open.normalized();
    areas.node.push_back(row);
    areas.area.push_back(std::pow(size, Dim - 1) * normal.cwiseAbs().sum());
    areas.normal.push_back(normal);
    areas.vector.push_back(areas.area.back() * normal);
    Vec3 position = Vec3::Zero();
    position.template head<Dim>() = x + 0.5 * size * open;
    areas.position.push_back(position);
  }
  areas.weight = areas.normal;
  areas.positive = areas.area;
  return areas;
}

template NodalAreas<1> particle_areas(const Points&, const HeatProblem<1>&);
template NodalAreas<2> particle_areas(const Points&, const HeatProblem<2>&);
template NodalAreas<3> particle_areas(const Points&, const HeatProblem<3>&);

}  // namespace lapilli
