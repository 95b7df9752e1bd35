#include "lapilli/peridynamics/boundary_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lapilli/core/parallel.hpp"

namespace lapilli {
namespace {

using Distance = std::function<double(const Vec3&)>;
using Face = std::vector<Vec3>;

constexpr double tolerance = 0.02;  // of a box, between the distance and its planes
constexpr double same_plane = 0.9999;
constexpr double sheer = 0.9;  // slopes below are those of a kink

/// Keeps the places with normal . x <= offset.
struct Plane {
  Vec3 normal;
  double offset;

  double operator()(const Vec3& x) const { return normal.dot(x) - offset; }
  Plane turned() const { return {-normal, -offset}; }
};

/// The distance in a box: the largest of its planes, or the smallest.
struct Facets {
  std::vector<Plane> planes;
  bool convex = true;

  double operator()(const Vec3& x) const {
    double value = planes.front()(x);
    for (const Plane& plane : planes) {
      value = convex ? std::max(value, plane(x)) : std::min(value, plane(x));
    }
    return value;
  }
};

Face cut(const Face& face, const Plane& plane) {
  Face kept;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const Vec3 &a = face[k], &b = face[(k + 1) % face.size()];
    const double da = plane(a), db = plane(b);
    if (da <= 0.0) {
      kept.push_back(a);
    }
    if ((da <= 0.0) != (db <= 0.0)) {
      kept.push_back(a + da / (da - db) * (b - a));
    }
  }
  return kept;
}

/// A square of the plane, wider than `reach` around the foot of `middle`.
Face square(const Plane& plane, const Vec3& middle, double reach) {
  const Vec3 foot = middle - plane(middle) * plane.normal;
  int least = 0;
  plane.normal.cwiseAbs().minCoeff(&least);
  const Vec3 u = plane.normal.cross(Vec3::Unit(least)).normalized() * reach;
  const Vec3 v = plane.normal.cross(u);
  return {foot - u - v, foot + u - v, foot + u + v, foot - u + v};
}

struct Moment {
  double area = 0.0;
  Vec3 centroid = Vec3::Zero();
};

Moment moment_of(const Face& face) {
  Moment sum;
  for (std::size_t k = 1; k + 1 < face.size(); ++k) {
    const double area = 0.5 * (face[k] - face[0]).cross(face[k + 1] - face[0]).norm();
    sum.area += area;
    sum.centroid += area / 3.0 * (face[0] + face[k] + face[k + 1]);
  }
  if (sum.area > 0.0) {
    sum.centroid /= sum.area;
  }
  return sum;
}

/// One box, which missing axes extend by its side from 0.
class SurfaceBox {
 public:
  SurfaceBox(const Distance& region, const Vec3& lower, double side, int dimension)
      : region_(region), lower_(lower), side_(side), dimension_(dimension) {
    for (int d = 0; d < 3; ++d) {
      middle_[d] = d < dimension ? lower[d] + 0.5 * side : 0.0;
    }
  }

  bool holds_surface() const {
    return std::abs(region_(middle_)) <= 0.5001 * side_ * std::sqrt(double(dimension_));
  }

  /// Planes that stand for the distance; none if it cannot be told by few.
  std::optional<Facets> facets() const {
    const std::vector<Sample> samples = sample();
    const Sample& middle = samples.back();
    if (middle.sheer) {
      Facets flat{{middle.plane}, true};
      if (std::all_of(samples.begin(), samples.end(), [&](const Sample& one) {
            return std::abs(one.value - flat(one.place)) <= tolerance * side_;
          })) {
        return flat;
      }
    }
    for (const bool convex : {true, false}) {
      if (std::optional<Facets> found = edge(samples, convex)) {
        return found;
      }
    }
    return {};
  }

  /// The plane in the middle, where nothing better is known.
  std::optional<Facets> rough() const {
    const Sample middle = sample_at(middle_);
    const Vec3 slope = slope_at(middle_);
    if (slope.norm() < 0.3) {
      return {};
    }
    const Vec3 normal = slope.normalized();
    return Facets{{{normal, normal.dot(middle_) - middle.value}}, true};
  }

  /// What of plane `which` lies in the box and on the surface.
  Face face(const Facets& facets, std::size_t which) const {
    // A surface along the side of a box belongs to the box that the body fills.
    const double inward = 1e-9 * side_;
    Plane plane = facets.planes[which];
    plane.offset -= inward;
    Face found = square(plane, middle_, 4.0 * side_);
    for (int d = 0; d < 3 && !found.empty(); ++d) {
      const double from = d < dimension_ ? lower_[d] : -0.5 * side_;
      found = cut(found, {Vec3::Unit(d), from + side_});
      found = cut(found, {-Vec3::Unit(d), -from});
    }
    for (std::size_t k = 0; k < facets.planes.size() && !found.empty(); ++k) {
      if (k != which) {
        const Plane& other = facets.planes[k];
        found = cut(found, facets.convex ? other : other.turned());
      }
    }
    return found;
  }

  /// Area of a face without the extent that missing axes gave it.
  double area(double extended) const { return extended / std::pow(side_, 3 - dimension_); }

 private:
  struct Sample {
    Vec3 place;
    double value;
    bool sheer;
    Plane plane;
  };

  Vec3 slope_at(const Vec3& at) const {
    const double step = 1e-4 * side_;
    Vec3 slope = Vec3::Zero();
    for (int d = 0; d < dimension_; ++d) {
      Vec3 ahead = at, behind = at;
      ahead[d] += step;
      behind[d] -= step;
      slope[d] = (region_(ahead) - region_(behind)) / (2.0 * step);
    }
    return slope;
  }

  Sample sample_at(const Vec3& at) const {
    Sample one{at, region_(at), false, {Vec3::UnitX(), 0.0}};
    const Vec3 slope = slope_at(at);
    one.sheer = slope.norm() > sheer;
    if (one.sheer) {
      one.plane.normal = slope.normalized();
      one.plane.offset = one.plane.normal.dot(at) - one.value;
    }
    return one;
  }

  /// Three places along each axis, off the sides, where kinks like to be; the middle comes last.
  std::vector<Sample> sample() const {
    static constexpr double share[] = {0.03, 0.47, 0.98};
    std::vector<Sample> samples;
    const int count = dimension_ == 1 ? 3 : dimension_ == 2 ? 9 : 27;
    for (int which = 0; which < count; ++which) {
      Vec3 at = Vec3::Zero();
      for (int d = 0, rest = which; d < dimension_; ++d, rest /= 3) {
        at[d] = lower_[d] + share[rest % 3] * side_;
      }
      samples.push_back(sample_at(at));
    }
    samples.push_back(sample_at(middle_));
    return samples;
  }

  /// The planes that the near side of an edge or corner shows, if they tell where the surface is.
  std::optional<Facets> edge(const std::vector<Sample>& samples, bool convex) const {
    const double sign = convex ? 1.0 : -1.0;
    Facets facets{{}, convex};
    for (const Sample& one : samples) {
      const bool known =
          std::any_of(facets.planes.begin(), facets.planes.end(), [&](const Plane& plane) {
            return plane.normal.dot(one.plane.normal) > same_plane &&
                   std::abs(plane(one.place) - one.value) < tolerance * side_;
          });
      if (one.sheer && sign * one.value <= 0.0 && !known) {
        facets.planes.push_back(one.plane);
      }
    }
    if (facets.planes.empty() || facets.planes.size() > 2u * static_cast<unsigned>(dimension_)) {
      return {};
    }
    for (const Sample& one : samples) {
      const double model = facets(one.place);
      const bool fits = sign * one.value <= 0.0 ? std::abs(model - one.value) <= tolerance * side_
                                                : sign * model >= -tolerance * side_ ||
                                                      std::abs(one.value) <= tolerance * side_;
      if (!fits) {
        return {};
      }
    }
    return facets;
  }

  const Distance& region_;
  Vec3 lower_, middle_;
  double side_;
  int dimension_;
};

class PieceSearch {
 public:
  PieceSearch(const Distance& region, const std::function<int(const Vec3&, const Vec3&)>& wall_at,
              double side, int dimension)
      : region_(region), wall_at_(wall_at), side_(side), dimension_(dimension) {}

  void search(const Vec3& lower, double side, int halvings, std::vector<BoundaryPiece>& found) {
    const SurfaceBox box(region_, lower, side, dimension_);
    if (!box.holds_surface()) {
      return;
    }
    std::optional<Facets> facets = box.facets();
    if (!facets && halvings == 0) {
      facets = box.rough();
      if (!facets) {
        return;
      }
    }
    const std::size_t before = found.size();
    if (facets && (add(box, *facets, halvings == 0, found) || halvings == 0)) {
      return;
    }
    found.resize(before);
    for (int child = 0; child < 1 << dimension_; ++child) {
      Vec3 corner = lower;
      for (int d = 0; d < dimension_; ++d) {
        corner[d] += (child >> d & 1) * 0.5 * side;
      }
      search(corner, 0.5 * side, halvings - 1, found);
    }
  }

 private:
  /// The faces of a box; false where one of them meets several walls, unless that is `allowed`.
  bool add(const SurfaceBox& box, const Facets& facets, bool allowed,
           std::vector<BoundaryPiece>& found) const {
    for (std::size_t k = 0; k < facets.planes.size(); ++k) {
      const Face face = box.face(facets, k);
      Moment moment = moment_of(face);
      const double area = box.area(moment.area);
      if (area <= 1e-12 * std::pow(side_, dimension_ - 1)) {
        continue;
      }
      for (int d = dimension_; d < 3; ++d) {
        moment.centroid[d] = 0.0;
      }
      const Vec3& normal = facets.planes[k].normal;
      if (region_(moment.centroid + 1e-3 * side_ * normal) <= 0.0) {
        continue;  // another body begins here
      }
      const int wall = wall_at_(moment.centroid, normal);
      for (Vec3 corner : face) {
        for (int d = dimension_; d < 3; ++d) {
          corner[d] = 0.0;
        }
        const Vec3 near = moment.centroid + 0.999 * (corner - moment.centroid);
        if (!allowed && wall_at_(near, normal) != wall) {
          return false;
        }
      }
      found.push_back({moment.centroid, normal, area, wall});
    }
    return true;
  }

  const Distance& region_;
  const std::function<int(const Vec3&, const Vec3&)>& wall_at_;
  double side_;
  int dimension_;
};

}  // namespace

std::vector<std::vector<BoundaryPiece>> boundary_pieces(
    const Distance& region, const SurfaceBoxes& boxes,
    const std::function<int(const Vec3&, const Vec3&)>& wall_at) {
  const int halvings = boxes.dimension == 3 ? 4 : 7;
  std::vector<std::vector<BoundaryPiece>> pieces(boxes.lower.size());
  parallel_runs(static_cast<Index>(boxes.lower.size()), [&](Index box) {
    const auto which = static_cast<std::size_t>(box);
    PieceSearch(region, wall_at, boxes.side, boxes.dimension)
        .search(boxes.lower[which], boxes.side, halvings, pieces[which]);
  });
  return pieces;
}

}  // namespace lapilli
