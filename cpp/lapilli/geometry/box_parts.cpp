#include "lapilli/geometry/box_parts.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/interruption.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/geometry/flat.hpp"
#include "lapilli/geometry/image_parts.hpp"
#include "lapilli/geometry/measure.hpp"
#include "lapilli/geometry/mesh_parts.hpp"

namespace lapilli {
namespace {

// A box is empty or whole to within this share of it.
constexpr double rounding = 1e-13;

// The part of a box in regions with flat sides, about the corner of the box.
class FlatParts {
 public:
  FlatParts(std::vector<FlatTerm> terms, const Sites& sites)
      : terms_(std::move(terms)), dimension_(sites.dimension()), side_(sites.spacing()) {
    for (FlatTerm& term : terms_) {
      for (Cut<3>& cut : term.cuts) {
        const Vec3 on_plane = sites.to_lattice(cut.offset * cut.normal);
        cut = cut_through<3>(on_plane, sites.turn().transpose() * cut.normal);
      }
    }
  }

  MomentSum of(const Vec3& corner) const {
    MomentSum sum;
    for (const FlatTerm& term : terms_) {
      add(term, corner, sum);
    }
    return sum;
  }

 private:
  // Only the cuts that go through the box; the box is the unit of length near the origin.
  void add(const FlatTerm& term, const Vec3& corner, MomentSum& sum) const {
    const Vec3 half(0.5 * side_, 0.5 * side_, dimension_ == 3 ? 0.5 * side_ : 0.0);
    std::vector<Cut<3>> through;
    for (const Cut<3>& cut : term.cuts) {
      const Cut<3> here{cut.normal, cut.offset - cut.normal.dot(corner)};
      const double beyond = cut.normal.dot(half) - here.offset;
      const double reach = cut.normal.cwiseAbs().dot(half);
      if (beyond >= reach) {
        return;
      }
      if (beyond > -reach) {
        through.push_back(here);
      }
    }
    sum.add(term.sign, through.empty() ? moments_of_box(side_, dimension_) : cut_box(through));
  }

  MomentSum cut_box(const std::vector<Cut<3>>& cuts) const {
    if (dimension_ == 3) {
      return moment_sum(clip_polyhedron(cuboid(Vec3::Zero(), Vec3::Constant(side_)), cuts),
                        Vec3::Zero());
    }
    Outline left = rectangle({0.0, 0.0}, {side_, side_});
    for (const Cut<3>& cut : cuts) {
      const Cut<2> flat{cut.normal.head<2>(), cut.offset};
      left = clip_polygon(std::move(left), std::span(&flat, 1));
    }
    return moment_sum(left, {0.0, 0.0});
  }

  std::vector<FlatTerm> terms_;
  int dimension_;
  double side_;
};

// The part of a box in a polygon, about the corner of the box.
class OutlineParts {
 public:
  OutlineParts(Outline outline, const Sites& sites)
      : outline_(std::move(outline)), side_(sites.spacing()) {
    for (Vec<2>& corner : outline_) {
      corner = sites.to_lattice({corner[0], corner[1], 0.0}).head<2>();
    }
  }

  MomentSum of(const Vec3& corner) const {
    const Cut<2> cuts[] = {{{-1, 0}, -corner[0]},
                           {{1, 0}, corner[0] + side_},
                           {{0, -1}, -corner[1]},
                           {{0, 1}, corner[1] + side_}};
    return moment_sum(clip_polygon(outline_, cuts), corner.head<2>());
  }

 private:
  Outline outline_;
  double side_;
};

// The part of a box where the distance is negative.
class DistanceParts {
 public:
  DistanceParts(const Shape& shape, const Sites& sites) : shape_(shape), sites_(sites) {}

  MomentSum of(const Vec3& corner) const {
    const auto at = [this](const Vec3& here) { return distance(shape_, sites_.to_scene(here)); };
    return moments_inside(at, corner, sites_.spacing(), sites_.dimension());
  }

 private:
  const Shape& shape_;
  const Sites& sites_;
};

// All boxes, those far from the surface by the distance alone. One task for each row of boxes.
template <class Source>
class AllParts {
 public:
  AllParts(const Shape* near_surface_of, const Source& source, const Sites& sites)
      : near_surface_of_(near_surface_of),
        source_(source),
        sites_(sites),
        whole_(moments_of_box(sites.spacing(), sites.dimension()).part(Vec3::Zero())),
        reach_(0.5 * sites.spacing() * std::sqrt(static_cast<double>(sites.dimension()))) {
    whole_.is_whole = true;
  }

  std::vector<BoxPart> collect() const {
    const auto &first = sites_.first(), &last = sites_.last();
    const Index deep = last[1] - first[1] + 1, high = last[2] - first[2] + 1;
    std::vector<std::vector<BoxPart>> rows(static_cast<std::size_t>(deep * high));
    parallel_tasks(deep * high, [&](Index row) {
      allow_interruption();
      Sites::Site site{first[0], first[1] + row % deep, first[2] + row / deep};
      for (; site[0] <= last[0]; ++site[0]) {
        add(site, rows[static_cast<std::size_t>(row)]);
      }
    });
    std::size_t count = 0;
    for (const std::vector<BoxPart>& row : rows) {
      count += row.size();
    }
    std::vector<BoxPart> parts;
    parts.reserve(count);
    for (std::vector<BoxPart>& row : rows) {
      allow_interruption();
      parts.insert(parts.end(), row.begin(), row.end());
      row = {};
    }
    return parts;
  }

 private:
  void add(const Sites::Site& site, std::vector<BoxPart>& row) const {
    if (near_surface_of_ != nullptr) {
      const double depth = distance(*near_surface_of_, sites_.to_scene(sites_.middle(site)));
      if (depth >= reach_) {
        return;
      }
      if (depth <= -reach_) {
        add_whole(site, row);
        return;
      }
    }
    const Vec3 corner = sites_.corner(site);
    const MomentSum sum = source_.of(corner);
    if (sum.volume >= (1.0 - rounding) * whole_.volume) {
      add_whole(site, row);
    } else if (sum.volume > rounding * whole_.volume) {
      row.push_back({site, sum.part(corner)});
    }
  }

  void add_whole(const Sites::Site& site, std::vector<BoxPart>& row) const {
    row.push_back({site, whole_});
    row.back().part.centroid = sites_.middle(site);
  }

  const Shape* near_surface_of_;
  const Source& source_;
  const Sites& sites_;
  Part whole_;
  double reach_;
};

}  // namespace

bool visited_before(const Sites::Site& a, const Sites::Site& b) {
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

std::vector<BoxPart> parts_of(const Shape& shape, const Sites& sites) {
  if (sites.dimension() == 3) {
    const auto mesh = placed_kind<Mesh>(shape);
    if (mesh && mesh->shape->surface->covers_once()) {
      return mesh_parts(*mesh->shape->surface, mesh->turn, mesh->shift, sites);
    }
    if (const auto ground = placed_kind<HeightField>(shape)) {
      return mesh_parts(*ground->shape->mesh->surface, ground->turn, ground->shift, sites);
    }
  }
  if (sites.dimension() == 2) {
    if (const auto image = placed_kind<ImageMask>(shape)) {
      return AllParts(nullptr, ImageParts(*image, sites), sites).collect();
    }
    if (auto outline = outline_of(shape)) {
      return AllParts(&shape, OutlineParts(*std::move(outline), sites), sites).collect();
    }
  }
  if (sites.dimension() > 1) {
    if (auto terms = terms_of(shape)) {
      return AllParts(&shape, FlatParts(*std::move(terms), sites), sites).collect();
    }
  }
  return AllParts(&shape, DistanceParts(shape, sites), sites).collect();
}

}  // namespace lapilli
