#include "lapilli/mpm/surface/plane_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "lapilli/core/in_space.hpp"

namespace lapilli {
namespace {

struct OfShape {
  const Shape& shape;
  double distance(const Vec3& x) const { return lapilli::distance(shape, x); }
  Vec3 normal(const Vec3& x) const { return gradient(shape, x); }
};

template <int Dim, class Surface>
class Fitter {
 public:
  using Fit = PlaneFit<Dim>;

  Fitter(const Surface& surface, const Cube<Dim>& cube, double tolerance)
      : surface_(surface), cube_(cube), tolerance_(tolerance) {
    sample_[0] = cube.middle();
    depth_[0] = distance_at(sample_[0]);
  }

  Fit fit() {
    Fit found;
    // A face that the cube shares with its neighbour counts as inside.
    const double reach = (0.5 * std::sqrt(static_cast<double>(Dim)) + 1e-8) * cube_.side;
    if (std::abs(depth_[0]) >= reach) {
      found.state = depth_[0] < 0.0 ? Fit::State::full : Fit::State::empty;
      return found;
    }
    for (int k = 1; k < samples; ++k) {
      sample_[k] = cube_.corner(k - 1);
      depth_[k] = distance_at(sample_[k]);
      // On the surface but for rounding: on the same side in all cubes that share the corner.
      depth_[k] = std::abs(depth_[k]) < touching * cube_.side ? 0.0 : depth_[k];
    }
    add_plane_near(sample_[0], found.planes);
    double bend = 0.0;
    if (found.planes.size() == 1 && suits_alone(found.planes.front(), bend)) {
      found.state = Fit::State::cut;
      if (bend > 1e-9 * cube_.side) {
        follow_curve(found);
      }
      return found;
    }
    for (int k = 1; k < samples; ++k) {
      add_plane_near(sample_[k], found.planes);
    }
    if (found.planes.empty()) {
      const bool one_side = std::all_of(depth_.begin(), depth_.end(), [&](double d) {
        return (d < 0.0) == (depth_[0] < 0.0) || std::abs(d) < tolerance_;
      });
      found.state = !one_side         ? Fit::State::rough
                    : depth_[0] < 0.0 ? Fit::State::full
                                      : Fit::State::empty;
      return found;
    }
    for (const auto join : {Fit::Join::all, Fit::Join::any}) {
      if (!bends_slightly(found.planes) && suits(found.planes, join)) {
        found.state = Fit::State::cut;
        found.join = join;
        return found;
      }
    }
    keep_nearest(found.planes);
    found.state = Fit::State::rough;
    return found;
  }

  /// Where planes do not tell the shape: one that parts the corners as it does.
  void settle(Fit& found) const {
    if (found.planes.empty()) {
      found.state = depth_[0] < 0.0 ? Fit::State::full : Fit::State::empty;
    } else if (Dim > 1) {
      follow_curve(found);
    }
  }

 private:
  static constexpr int samples = 1 + (1 << Dim);
  static constexpr double touching = 1e-9;  // of the side

  double distance_at(const Vec<Dim>& x) const { return surface_.distance(in_space<Dim>(x)); }
  Vec<Dim> normal_at(const Vec<Dim>& x) const {
    return surface_.normal(in_space<Dim>(x)).template head<Dim>();
  }

  /// The tangent plane where the surface is nearest to `from`; nothing at edges, at seams inside
  /// the shape and where the surface passes far from the cube.
  std::optional<Cut<Dim>> plane_near(const Vec<Dim>& from) const {
    const double side = cube_.side;
    const Vec<Dim> x = foot_of<Dim>(surface_, from, 1e-13 * side);
    if ((x - sample_[0]).cwiseAbs().maxCoeff() > 0.75 * side) {
      return std::nullopt;
    }
    const double small = 1e-4 * side;
    Vec<Dim> normal = normal_at(x);
    const Vec<Dim> within = x - small * normal, beyond = x + small * normal;
    const bool is_surface = distance_at(within) < -0.5 * small && distance_at(beyond) > 0.5 * small;
    const Vec<Dim> inner = normal_at(within), outer = normal_at(beyond);
    if (!is_surface || inner.dot(outer) < 0.999) {
      return std::nullopt;
    }
    normal = outer;
    return cut_through<Dim>(x, normal);
  }

  void add_plane_near(const Vec<Dim>& from, std::vector<Cut<Dim>>& planes) const {
    const auto found = plane_near(from);
    if (!found) {
      return;
    }
    const auto same = [&](const Cut<Dim>& other) {
      return other.normal.dot(found->normal) > 0.95 &&
             std::abs(beyond(other, sample_[0]) - beyond(*found, sample_[0])) < tolerance_;
    };
    if (std::none_of(planes.begin(), planes.end(), same)) {
      planes.push_back(*found);
    }
  }

  static double beyond(const Cut<Dim>& plane, const Vec<Dim>& x) {
    return plane.normal.dot(x) - plane.offset;
  }

  /// Whether one plane tells the shape; `bend` is how far it is from it.
  bool suits_alone(const Cut<Dim>& plane, double& bend) const {
    for (int k = 1; k < samples; ++k) {
      bend = std::max(bend, std::abs(depth_[k] - beyond(plane, sample_[k])));
    }
    return bend <= tolerance_;
  }

  /// A curved surface must leave a cube where its neighbour takes it over. A cube whose corners lie
  /// on one side, or on the surface that only touches it there, has none of it; in the plane the
  /// rest is a chord between the cube's edges.
  void follow_curve(Fit& found) const {
    const auto corners_beyond = [&](double sign) {
      return std::any_of(depth_.begin() + 1, depth_.end(), [&](double d) { return sign * d > 0; });
    };
    const bool inside = corners_beyond(-1.0);
    if (!(inside && corners_beyond(1.0))) {
      found.state = inside ? Fit::State::full : Fit::State::empty;
      found.planes.clear();
      return;
    }
    if constexpr (Dim == 2) {
      std::vector<Vec<2>> ends;
      constexpr int around[] = {1, 2, 4, 3};
      for (int k = 0; k < 4; ++k) {
        const int a = around[k], b = around[(k + 1) % 4];
        if ((depth_[a] <= 0.0) != (depth_[b] <= 0.0)) {
          // Always from the same end, so that neighbours find the same place.
          ends.push_back(a < b ? crossing(a, b) : crossing(b, a));
        }
      }
      if (ends.size() != 2) {
        found.state = Fit::State::rough;
        return;
      }
      const Vec<2> along = ends[1] - ends[0];
      if (along.norm() > 1e-9 * cube_.side) {
        Vec<2> normal = Vec<2>(along[1], -along[0]).normalized();
        normal *= normal.dot(found.planes.front().normal) < 0.0 ? -1.0 : 1.0;
        found.planes.front() = cut_through<2>(ends[0], normal);
      }
    }
  }

  Vec<Dim> crossing(int a, int b) const {
    if (depth_[a] == 0.0 || depth_[b] == 0.0) {
      return sample_[depth_[a] == 0.0 ? a : b];
    }
    const Vec<Dim> along = sample_[b] - sample_[a];
    double low = 0.0, high = 1.0, at_low = depth_[a], at_high = depth_[b], share = 0.5;
    for (int round = 0; round < 60 && high - low > 1e-15 && at_low != at_high; ++round) {
      share = std::clamp((low * at_high - high * at_low) / (at_high - at_low), low, high);
      const double here = distance_at(sample_[a] + share * along);
      if (here == 0.0) {
        break;
      }
      // Illinois: the end that stays counts half.
      if ((here < 0.0) == (at_low < 0.0)) {
        low = share;
        at_low = here;
        at_high *= 0.5;
      } else {
        high = share;
        at_high = here;
        at_low *= 0.5;
      }
    }
    return sample_[a] + share * along;
  }

  /// Whether planes in the plane are those of a curve rather than of a corner.
  bool bends_slightly(const std::vector<Cut<Dim>>& planes) const {
    constexpr double slight = 0.8;  // cosine
    for (std::size_t k = 0; Dim == 2 && k < planes.size(); ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        if (planes[k].normal.dot(planes[j].normal) > slight) {
          return true;
        }
      }
    }
    return false;
  }

  bool suits(const std::vector<Cut<Dim>>& planes, typename Fit::Join join) const {
    for (int k = 0; k < samples; ++k) {
      double fitted = beyond(planes.front(), sample_[k]);
      for (const Cut<Dim>& plane : planes) {
        const double one = beyond(plane, sample_[k]);
        fitted = join == Fit::Join::all ? std::max(fitted, one) : std::min(fitted, one);
      }
      // Distances around an edge are told by the planes on one side only.
      const bool told = planes.size() == 1 || (join == Fit::Join::all) == (depth_[k] < 0.0);
      const bool same_side = (fitted < 0.0) == (depth_[k] < 0.0);
      if ((told && std::abs(fitted - depth_[k]) > tolerance_ && !of_another_place(k, fitted)) ||
          (!same_side && std::max(std::abs(fitted), std::abs(depth_[k])) > tolerance_)) {
        return false;
      }
    }
    return true;
  }

  /// Whether the distance of a sample is that to a surface beyond the cube, as in a plate, or to a
  /// seam between parts of the shape.
  bool of_another_place(int k, double fitted) const {
    if (std::abs(depth_[k]) > std::abs(fitted) - 0.1 * cube_.side) {
      return false;
    }
    const Vec<Dim> normal = normal_at(sample_[k]), foot = sample_[k] - depth_[k] * normal;
    const double small = 1e-4 * cube_.side;
    const bool seam = depth_[k] < 0.0 && distance_at(foot + small * normal) < 0.0;
    return seam || (foot - sample_[0]).cwiseAbs().maxCoeff() > 0.5 * cube_.side;
  }

  void keep_nearest(std::vector<Cut<Dim>>& planes) const {
    const auto nearest =
        std::min_element(planes.begin(), planes.end(), [&](const Cut<Dim>& a, const Cut<Dim>& b) {
          return std::abs(beyond(a, sample_[0])) < std::abs(beyond(b, sample_[0]));
        });
    planes = {*nearest};
  }

  const Surface& surface_;
  const Cube<Dim> cube_;
  double tolerance_;
  std::array<Vec<Dim>, samples> sample_;
  std::array<double, samples> depth_;
};

template <int Dim, class Surface>
PlaneFit<Dim> fit_to(const Surface& surface, const Cube<Dim>& cube, double tolerance, bool settle) {
  Fitter<Dim, Surface> fitter(surface, cube, tolerance);
  PlaneFit<Dim> found = fitter.fit();
  if (settle && found.state == PlaneFit<Dim>::State::rough) {
    fitter.settle(found);
  }
  return found;
}

}  // namespace

template <int Dim>
PlaneFit<Dim> fit_planes(const Shape& shape, const Cube<Dim>& cube, double tolerance, bool settle) {
  return fit_to<Dim>(OfShape{shape}, cube, tolerance, settle);
}

template <int Dim>
PlaneFit<Dim> fit_planes(const LevelSet& surface, const Cube<Dim>& cube, double tolerance,
                         bool settle) {
  return fit_to<Dim>(surface, cube, tolerance, settle);
}

template PlaneFit<1> fit_planes(const Shape&, const Cube<1>&, double, bool);
template PlaneFit<2> fit_planes(const Shape&, const Cube<2>&, double, bool);
template PlaneFit<3> fit_planes(const Shape&, const Cube<3>&, double, bool);
template PlaneFit<2> fit_planes(const LevelSet&, const Cube<2>&, double, bool);
template PlaneFit<3> fit_planes(const LevelSet&, const Cube<3>&, double, bool);

}  // namespace lapilli
