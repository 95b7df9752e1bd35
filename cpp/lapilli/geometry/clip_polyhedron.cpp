#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "lapilli/geometry/clip.hpp"

namespace lapilli {
namespace {

using Face = std::vector<Vec3>;

// Corners this near to a cut, as a share of the body's extent, lie on it.
constexpr double on_cut = 1e-15;

Vec3 middle_of(const Face& corners) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& corner : corners) {
    sum += corner;
  }
  return sum / static_cast<double>(corners.size());
}

// The corners of a convex face in order, counter-clockwise seen from where the normal points.
Face ordered(Face corners, const Vec3& normal) {
  const Vec3 middle = middle_of(corners);
  const Vec3 across = normal.unitOrthogonal();
  const Vec3 up = normal.normalized().cross(across);
  const auto angle = [&](const Vec3& x) {
    return std::atan2(up.dot(x - middle), across.dot(x - middle));
  };
  std::sort(corners.begin(), corners.end(),
            [&](const Vec3& a, const Vec3& b) { return angle(a) < angle(b); });
  return corners;
}

class BodyCut {
 public:
  BodyCut(const Polyhedron& body, const Cut<3>& cut) : cut_(cut) {
    double extent = 0.0;
    for (const Face& face : body.faces) {
      for (const Vec3& corner : face) {
        extent = std::max(extent, (corner - body.faces.front().front()).norm());
      }
    }
    tolerance_ = on_cut * extent * cut.normal.norm();
    for (const Face& face : body.faces) {
      for (const Vec3& corner : face) {
        any_inside_ |= beyond(corner) < 0.0;
        any_outside_ |= beyond(corner) > 0.0;
      }
    }
  }

  bool any_inside() const { return any_inside_; }
  bool any_outside() const { return any_outside_; }

  double beyond(const Vec3& x) const {
    const double value = cut_.normal.dot(x) - cut_.offset;
    return std::abs(value) <= tolerance_ ? 0.0 : value;
  }

  // What is left of a face; the corners on the cut are added to `rim`.
  Face keep(const Face& face, Face& rim) const {
    Face kept;
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vec3 &here = face[k], &next = face[(k + 1) % face.size()];
      const double from = beyond(here), to = beyond(next);
      if (from <= 0.0) {
        kept.push_back(here);
      }
      if (from == 0.0) {
        rim.push_back(here);
      }
      if ((from < 0.0 && to > 0.0) || (from > 0.0 && to < 0.0)) {
        kept.push_back(crossing(here, next, from, to));
        rim.push_back(kept.back());
      }
    }
    return kept;
  }

 private:
  // Both faces of an edge must find the same bytes: start from the kept end.
  static Vec3 crossing(const Vec3& a, const Vec3& b, double from, double to) {
    return from < 0.0 ? Vec3(a + from / (from - to) * (b - a))
                      : Vec3(b + to / (to - from) * (a - b));
  }

  const Cut<3>& cut_;
  double tolerance_ = 0.0;
  bool any_inside_ = false, any_outside_ = false;
};

Polyhedron clip_once(const Polyhedron& body, const Cut<3>& cut) {
  const BodyCut at(body, cut);
  if (!at.any_inside()) {
    return {};
  }
  if (!at.any_outside()) {
    return body;
  }
  Polyhedron kept;
  Face rim;
  for (const Face& face : body.faces) {
    Face left = at.keep(face, rim);
    if (left.size() >= 3) {
      kept.faces.push_back(std::move(left));
    }
  }
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  };
  std::sort(rim.begin(), rim.end(), less);
  rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
  if (rim.size() >= 3) {
    kept.faces.push_back(ordered(std::move(rim), cut.normal));
  }
  return kept;
}

}  // namespace

Polyhedron cuboid(const Vec3& lower, const Vec3& upper) {
  const auto corner = [&](int x, int y, int z) {
    return Vec3(x ? upper[0] : lower[0], y ? upper[1] : lower[1], z ? upper[2] : lower[2]);
  };
  return {{{corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0)},
           {corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1)},
           {corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1)},
           {corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0)},
           {corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0)},
           {corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)}}};
}

Polyhedron clip_polyhedron(Polyhedron body, std::span<const Cut<3>> cuts) {
  for (const Cut<3>& cut : cuts) {
    if (body.empty()) {
      break;
    }
    body = clip_once(body, cut);
  }
  return body;
}

std::vector<Tetrahedron> tetrahedra(const Polyhedron& body) {
  std::vector<Tetrahedron> parts;
  if (body.empty()) {
    return parts;
  }
  Face middles;
  for (const Face& face : body.faces) {
    middles.push_back(middle_of(face));
  }
  const Vec3 inside = middle_of(middles);
  for (const Face& face : body.faces) {
    for (std::size_t k = 1; k + 1 < face.size(); ++k) {
      const Tetrahedron part{inside, face[0], face[k], face[k + 1]};
      if (volume(part) > 0.0) {
        parts.push_back(part);
      }
    }
  }
  return parts;
}

double volume(const Tetrahedron& corners) {
  const Vec3 a = corners[1] - corners[0], b = corners[2] - corners[0], c = corners[3] - corners[0];
  return a.dot(b.cross(c)) / 6.0;
}

Moments<3> moments(const Polyhedron& body) {
  Moments<3> all;
  const auto parts = tetrahedra(body);
  if (parts.empty()) {
    return all;
  }
  const Vec3 from = parts.front()[0];
  Vec3 moment = Vec3::Zero();
  for (const Tetrahedron& part : parts) {
    const double size = volume(part);
    all.size += size;
    moment += 0.25 * size * ((part[1] - from) + (part[2] - from) + (part[3] - from));
  }
  all.centroid = from + moment / all.size;
  return all;
}

std::vector<QuadraturePoint<3>> quadrature(std::span<const Tetrahedron> parts) {
  // Degree 2 with four points (Hammer and Stroud 1956): barycentric (a, b, b, b).
  const double b = (5.0 - std::sqrt(5.0)) / 20.0, a = 1.0 - 3.0 * b;
  std::vector<QuadraturePoint<3>> points;
  points.reserve(4 * parts.size());
  for (const Tetrahedron& part : parts) {
    const Vec3 sum = part[0] + part[1] + part[2] + part[3];
    for (const Vec3& corner : part) {
      points.push_back({b * sum + (a - b) * corner, 0.25 * volume(part)});
    }
  }
  return points;
}

}  // namespace lapilli
