#include "lapilli/peridynamics/surface_box.hpp"

#include <Eigen/Geometry>
#include <array>

namespace lapilli {
namespace {

constexpr double same_plane = 0.9999;
constexpr double sheer = 0.9;  // slopes below are those of a kink

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

}  // namespace

SurfaceBox::SurfaceBox(const std::function<double(const Vec3&)>& region, const Vec3& lower,
                       double side, int dimension)
    : region_(region), lower_(lower), side_(side), dimension_(dimension) {
  for (int d = 0; d < 3; ++d) {
    middle_[d] = d < dimension ? lower[d] + 0.5 * side : 0.0;
  }
}

bool SurfaceBox::both_sides() const {
  const auto inside = [](const Sample& one) { return one.value <= 0.0; };
  return std::any_of(samples_.begin(), samples_.end(), inside) &&
         !std::all_of(samples_.begin(), samples_.end(), inside);
}

std::optional<Facets> SurfaceBox::facets(double slack) const {
  if (std::optional<Facets> flat = plane(slack)) {
    return flat;
  }
  for (const bool convex : {true, false}) {
    if (std::optional<Facets> found = edge(convex, slack)) {
      return found;
    }
  }
  return {};
}

std::optional<Facets> SurfaceBox::plane(double slack) const {
  const Sample& middle = samples_.back();
  const Facets flat{{middle.plane}, true};
  const bool fits =
      middle.sheer && std::all_of(samples_.begin(), samples_.end(), [&](const Sample& one) {
        return std::abs(one.value - flat(one.place)) <= slack * side_;
      });
  return fits ? std::optional(flat) : std::nullopt;
}

std::optional<Facets> SurfaceBox::rough() const {
  const Sample middle = sample_at(middle_);
  const Vec3 slope = slope_at(middle_);
  if (slope.norm() < 0.3) {
    return {};
  }
  const Vec3 normal = slope.normalized();
  return Facets{{{normal, normal.dot(middle_) - middle.value}}, true};
}

Face SurfaceBox::face(const Facets& facets, std::size_t which) const {
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

Vec3 SurfaceBox::outward(const Vec3& at, const Vec3& normal) const {
  const double step = 0.1 * side_;
  return region_(at + step * normal) >= region_(at - step * normal) ? normal : -normal;
}

Vec3 SurfaceBox::slope_at(const Vec3& at) const {
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

SurfaceBox::Sample SurfaceBox::sample_at(const Vec3& at) const {
  Sample one{at, region_(at), false, {Vec3::UnitX(), 0.0}};
  const Vec3 slope = slope_at(at);
  one.sheer = slope.norm() > sheer;
  if (one.sheer) {
    one.plane.normal = slope.normalized();
    one.plane.offset = one.plane.normal.dot(at) - one.value;
  }
  return one;
}

// Three places along each axis, off the sides, where kinks like to be; the middle comes last.
void SurfaceBox::sample() {
  static constexpr double share[] = {0.03, 0.47, 0.98};
  const int count = dimension_ == 1 ? 3 : dimension_ == 2 ? 9 : 27;
  for (int which = 0; which < count; ++which) {
    Vec3 at = Vec3::Zero();
    for (int d = 0, rest = which; d < dimension_; ++d, rest /= 3) {
      at[d] = lower_[d] + share[rest % 3] * side_;
    }
    samples_.push_back(sample_at(at));
  }
  samples_.push_back(sample_at(middle_));
}

// Every place of a curved surface has a plane of its own that fits it: one that is a side keeps its
// distance to one hand at least.
bool SurfaceBox::straight(const Sample& one, double slack_share) const {
  const double aside = 0.05 * side_;
  for (int d = 0; d < dimension_; ++d) {
    const Vec3 along = Vec3::Unit(d) - one.plane.normal[d] * one.plane.normal;
    const auto off = [&](double way) {
      return std::abs(region_(one.place + way * along) - one.value);
    };
    if (std::min(off(aside), off(-aside)) > 0.1 * slack_share * side_) {
      return false;
    }
  }
  return true;
}

std::optional<Facets> SurfaceBox::edge(bool convex, double slack_share) const {
  const double sign = convex ? 1.0 : -1.0;
  Facets facets{{}, convex};
  for (const Sample& one : samples_) {
    const bool known =
        std::any_of(facets.planes.begin(), facets.planes.end(), [&](const Plane& plane) {
          return plane.normal.dot(one.plane.normal) > same_plane &&
                 std::abs(plane(one.place) - one.value) <= slack_share * side_;
        });
    if (one.sheer && sign * one.value <= 0.0 && !known) {
      if (!straight(one, slack_share)) {
        return {};
      }
      facets.planes.push_back(one.plane);
    }
  }
  if (facets.planes.empty() || facets.planes.size() > 2u * static_cast<unsigned>(dimension_)) {
    return {};
  }
  // Beyond an edge the way to the surface is longer than to any plane, by sqrt(dimension) at
  // most.
  const double longer = std::sqrt(static_cast<double>(dimension_)), slack = slack_share * side_;
  for (const Sample& one : samples_) {
    const double model = sign * facets(one.place), value = sign * one.value;
    const bool fits = value <= 0.0 ? std::abs(model - value) <= slack
                                   : model >= -slack && value <= longer * model + slack;
    if (!fits) {
      return {};
    }
  }
  return facets;
}

// Regula falsi: a distance is nearly straight between the ends of an edge.
Vec3 SurfaceBox::crossing(Vec3 inside, Vec3 outside) const {
  double a = region_(inside), b = region_(outside);
  for (int step = 0; step < 8; ++step) {
    const Vec3 between = inside + a / (a - b) * (outside - inside);
    const double value = region_(between);
    if (std::abs(value) < 1e-12 * side_) {
      return between;
    }
    (value <= 0.0 ? inside : outside) = between;
    (value <= 0.0 ? a : b) = value;
  }
  return inside + a / (a - b) * (outside - inside);
}

void SurfaceBox::add_simplex(const std::vector<Vec3>& corners, std::vector<Face>& faces) const {
  std::vector<Vec3> in, out;
  for (const Vec3& corner : corners) {
    (region_(corner) <= 0.0 ? in : out).push_back(corner);
  }
  if (in.empty() || out.empty()) {
    return;
  }
  if (dimension_ == 2) {
    // Pulled along the missing axis.
    const bool tip = in.size() == 1;
    const Vec3 a = crossing(in.front(), out.front());
    const Vec3 b = tip ? crossing(in.front(), out.back()) : crossing(in.back(), out.front());
    const Vec3 half = 0.5 * side_ * Vec3::UnitZ();
    faces.push_back({a - half, b - half, b + half, a + half});
  } else if (in.size() == 2) {
    faces.push_back({crossing(in[0], out[0]), crossing(in[0], out[1]), crossing(in[1], out[1]),
                     crossing(in[1], out[0])});
  } else {
    const bool tip = in.size() == 1;
    Face face;
    for (std::size_t k = 0; k < 3; ++k) {
      face.push_back(tip ? crossing(in[0], out[k]) : crossing(in[k], out[0]));
    }
    faces.push_back(face);
  }
}

std::vector<Face> SurfaceBox::curved_faces() const {
  // One simplex for each order in which the axes are walked from the low to the high corner.
  std::vector<Face> faces;
  std::array<int, 3> order{0, 1, 2};
  do {
    std::vector<Vec3> corners{lower_};
    for (int d = dimension_; d < 3; ++d) {
      corners[0][d] = 0.0;
    }
    for (int k = 0; k < dimension_; ++k) {
      corners.push_back(corners.back() + side_ * Vec3::Unit(order[static_cast<std::size_t>(k)]));
    }
    add_simplex(corners, faces);
  } while (std::next_permutation(order.begin(), order.begin() + dimension_));
  return faces;
}

}  // namespace lapilli
