#include "lapilli/peridynamics/boundary_pieces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "lapilli/core/parallel.hpp"
#include "lapilli/peridynamics/surface_box.hpp"

namespace lapilli {
namespace {

using Distance = std::function<double(const Vec3&)>;

constexpr double exact = 1e-6;      // of a box, between the distance and planes that are its sides
constexpr double tolerance = 0.02;  // and where the surface is curved
constexpr double clear = 0.05;      // of a whole box: nearer bodies touch

struct Moment {
  double area = 0.0;
  Vec3 centroid = Vec3::Zero(), normal = Vec3::Zero();  // of either sign
};

Moment moment_of(const Face& face) {
  Moment sum;
  double total = 0.0;
  for (std::size_t k = 1; k + 1 < face.size(); ++k) {
    const Vec3 across = 0.5 * (face[k] - face[0]).cross(face[k + 1] - face[0]);
    sum.normal += across;
    total += across.norm();
    sum.centroid += across.norm() / 3.0 * (face[0] + face[k] + face[k + 1]);
  }
  if (total > 0.0) {
    sum.centroid /= total;
    sum.area = sum.normal.norm();
    sum.normal /= sum.area > 0.0 ? sum.area : 1.0;
  }
  return sum;
}

class PieceSearch {
 public:
  PieceSearch(const Distance& region, const std::function<int(const Vec3&, const Vec3&)>& wall_at,
              double side, int dimension)
      : region_(region), wall_at_(wall_at), side_(side), dimension_(dimension) {}

  void search(const Vec3& lower, double side, int halvings, std::vector<BoundaryPiece>& found) {
    SurfaceBox box(region_, lower, side, dimension_);
    if (!box.holds_surface()) {
      return;
    }
    box.sample();
    std::optional<Facets> facets = box.facets(exact);
    const bool curved = !facets && box.plane(tolerance);
    if (!facets && !curved && halvings == 0) {
      if (!box.both_sides()) {
        return;
      }
      facets = box.facets(tolerance);
      facets = facets ? facets : box.rough();
      if (!facets) {
        return;
      }
    }
    const std::size_t before = found.size();
    if ((facets || curved) && (add(box, facets, halvings == 0, found) || halvings == 0)) {
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
  bool add(const SurfaceBox& box, const std::optional<Facets>& facets, bool allowed,
           std::vector<BoundaryPiece>& found) const {
    if (!facets) {
      const std::vector<Face> faces = box.curved_faces();
      return std::all_of(faces.begin(), faces.end(),
                         [&](const Face& face) { return add(box, face, allowed, found); });
    }
    for (std::size_t k = 0; k < facets->planes.size(); ++k) {
      if (!add(box, box.face(*facets, k), allowed, found)) {
        return false;
      }
    }
    return true;
  }

  bool add(const SurfaceBox& box, const Face& face, bool allowed,
           std::vector<BoundaryPiece>& found) const {
    Moment moment = moment_of(face);
    const double area = box.area(moment.area);
    if (area <= 1e-12 * std::pow(side_, dimension_ - 1)) {
      return true;
    }
    const Vec3 normal = box.outward(moment.centroid, moment.normal);
    flatten(moment.centroid);
    if (region_(moment.centroid + clear * side_ * normal) <= 0.0) {
      return true;  // another body begins here
    }
    moment.centroid -= region_(moment.centroid) * normal;
    const int wall = wall_at_(moment.centroid, normal);
    for (Vec3 corner : face) {
      flatten(corner);
      const Vec3 near = moment.centroid + 0.999 * (corner - moment.centroid);
      if (!allowed && wall_at_(near, normal) != wall) {
        return false;
      }
    }
    found.push_back({moment.centroid, normal, area, wall});
    return true;
  }

  void flatten(Vec3& at) const {
    for (int d = dimension_; d < 3; ++d) {
      at[d] = 0.0;
    }
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
