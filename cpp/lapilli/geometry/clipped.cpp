#include "lapilli/geometry/clipped.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/geometry/flat.hpp"
#include "lapilli/geometry/measure.hpp"

namespace lapilli {
namespace {

// Gives the part of each lattice box inside the shape, in the frame of the lattice.
class BoxParts {
 public:
  BoxParts(const Shape& shape, const Sites& sites) : shape_(shape), sites_(sites) {
    if (sites.dimension() == 2) {
      outline_ = outline_of(shape);
    }
    if (outline_) {
      for (Vec<2>& corner : *outline_) {
        const Vec3 there(corner[0], corner[1], 0.0);
        corner = sites.to_lattice(there).head<2>();
      }
    } else if (sites.dimension() > 1) {
      cuts_ = cuts_of(shape);
    }
    if (cuts_) {
      for (Cut<3>& cut : *cuts_) {
        const Vec3 on_plane = sites.to_lattice(cut.offset * cut.normal);
        cut = cut_through<3>(on_plane, sites.turn().transpose() * cut.normal);
      }
    }
  }

  Part of(const Sites::Site& site) const {
    const double side = sites_.spacing();
    const Vec3 middle = sites_.middle(site);
    const double depth = distance(shape_, sites_.to_scene(middle));
    const double reach = 0.5 * side * std::sqrt(static_cast<double>(sites_.dimension()));
    if (depth >= reach) {
      return {};
    }
    if (depth <= -reach) {
      return {sites_.box_volume(), middle};
    }
    const Vec3 corner = sites_.corner(site);
    return outline_ ? of_polygon(corner) : cuts_ ? of_cuts(corner) : of_distance(corner);
  }

 private:
  Part of_polygon(const Vec3& corner) const {
    const double side = sites_.spacing();
    const Cut<2> cuts[] = {{{-1, 0}, -corner[0]},
                           {{1, 0}, corner[0] + side},
                           {{0, -1}, -corner[1]},
                           {{0, 1}, corner[1] + side}};
    const Moments<2> part = moments(clip_polygon(*outline_, cuts));
    return {part.size, {part.centroid[0], part.centroid[1], 0.0}};
  }

  Part of_cuts(const Vec3& corner) const {
    const double side = sites_.spacing();
    if (sites_.dimension() == 3) {
      const auto part =
          moments(clip_polyhedron(cuboid(corner, corner + Vec3::Constant(side)), *cuts_));
      return {part.size, part.centroid};
    }
    Outline left = rectangle(corner.head<2>(), corner.head<2>() + Vec<2>::Constant(side));
    for (const Cut<3>& cut : *cuts_) {
      const Cut<2> flat{cut.normal.head<2>(), cut.offset};
      left = clip_polygon(std::move(left), std::span(&flat, 1));
    }
    const Moments<2> part = moments(left);
    return {part.size, {part.centroid[0], part.centroid[1], 0.0}};
  }

  Part of_distance(const Vec3& corner) const {
    const auto at = [this](const Vec3& here) { return distance(shape_, sites_.to_scene(here)); };
    return part_inside(at, corner, sites_.spacing(), sites_.dimension());
  }

  const Shape& shape_;
  const Sites& sites_;
  std::optional<Outline> outline_;
  std::optional<std::vector<Cut<3>>> cuts_;
};

struct FilledBox {
  Sites::Site site;
  Part part;
};

// First axis fastest: the order in which sites are visited.
bool before(const Sites::Site& a, const Sites::Site& b) {
  return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
}

// The fullest box around `site`, itself excluded; null if there is none above `least`.
FilledBox* fullest_neighbour(std::vector<FilledBox>& boxes, const Sites::Site& site, double least) {
  FilledBox* best = nullptr;
  Sites::Site other;
  for (other[2] = site[2] - 1; other[2] <= site[2] + 1; ++other[2]) {
    for (other[1] = site[1] - 1; other[1] <= site[1] + 1; ++other[1]) {
      for (other[0] = site[0] - 1; other[0] <= site[0] + 1; ++other[0]) {
        const auto found = std::lower_bound(boxes.begin(), boxes.end(), other,
                                            [](const FilledBox& box, const Sites::Site& wanted) {
                                              return before(box.site, wanted);
                                            });
        if (found != boxes.end() && found->site == other && found->part.volume >= least &&
            (best == nullptr || found->part.volume > best->part.volume)) {
          best = &*found;
        }
      }
    }
  }
  return best;
}

void merge_slivers(std::vector<FilledBox>& boxes, double least) {
  double whole = 0.0, left_out = 0.0;
  for (FilledBox& sliver : boxes) {
    whole += sliver.part.volume;
    if (sliver.part.volume >= least) {
      continue;
    }
    FilledBox* neighbour = fullest_neighbour(boxes, sliver.site, least);
    if (neighbour == nullptr) {
      left_out += sliver.part.volume;
      continue;
    }
    Part& part = neighbour->part;
    const double share = sliver.part.volume / (part.volume + sliver.part.volume);
    part.centroid += share * (sliver.part.centroid - part.centroid);
    part.volume += sliver.part.volume;
  }
  std::erase_if(boxes, [&](const FilledBox& box) { return box.part.volume < least; });
  if (left_out > 0.0) {
    for (FilledBox& box : boxes) {
      box.part.volume *= whole / (whole - left_out);
    }
  }
}

}  // namespace

void fill_clipped(const Shape& shape, const Sites& sites, double smallest, FilledPoints& points) {
  const BoxParts parts(shape, sites);
  std::vector<FilledBox> boxes;
  sites.each([&](const Sites::Site& site) {
    const Part part = parts.of(site);
    if (part.volume > 0.0) {
      boxes.push_back({site, part});
    }
  });
  merge_slivers(boxes, smallest * sites.box_volume());
  for (const FilledBox& box : boxes) {
    const Vec3 there = sites.to_scene(box.part.centroid);
    points.position.insert(points.position.end(), there.data(), there.data() + points.dimension);
    points.volume.push_back(box.part.volume);
  }
}

double clipped_volume(const Shape& shape, const Sites& sites) {
  const BoxParts parts(shape, sites);
  double sum = 0.0;
  sites.each([&](const Sites::Site& site) { sum += parts.of(site).volume; });
  return sum;
}

}  // namespace lapilli
