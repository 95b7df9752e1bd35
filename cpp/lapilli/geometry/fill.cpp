#include "lapilli/geometry/fill.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/geometry/checks.hpp"
#include "lapilli/geometry/clipped.hpp"
#include "lapilli/geometry/lattice.hpp"
#include "lapilli/geometry/random.hpp"

namespace lapilli {
namespace {

// A site this near to the surface, as a share of the spacing, counts as inside.
constexpr double on_surface = 1e-9;

void add_point(FilledPoints& points, const Vec3& at, double volume) {
  points.position.insert(points.position.end(), at.data(), at.data() + points.dimension);
  points.volume.push_back(volume);
}

// One generator a site, so that a point's draw depends on its site and the seed alone.
Random random_of(const Sites::Site& site, std::uint64_t seed) {
  std::uint64_t mixed = seed;
  for (Index index : site) {
    mixed = Random(mixed ^ static_cast<std::uint64_t>(index)).bits();
  }
  return Random(mixed);
}

// A place near `middle`, in the frame of the lattice, that is still inside; `middle` itself after
// 32 draws.
Vec3 jittered(const Shape& shape, const Sites& sites, const Sites::Site& site, const Vec3& middle,
              const FillOptions& options) {
  Random random = random_of(site, options.seed);
  const double reach = options.jitter * sites.spacing();
  for (int draw = 0; draw < 32; ++draw) {
    Vec3 here = middle;
    for (int axis = 0; axis < sites.dimension(); ++axis) {
      here[axis] += random.uniform(-reach, reach);
    }
    const Vec3 there = sites.to_scene(here);
    if (distance(shape, there) <= 0.0) {
      return there;
    }
  }
  return sites.to_scene(middle);
}

void fill_lattice(const Shape& shape, const Sites& sites, const FillOptions& options,
                  FilledPoints& points) {
  const double tolerance = on_surface * sites.spacing();
  const double volume = sites.box_volume();
  sites.each([&](const Sites::Site& site) {
    const Vec3 there = sites.to_scene(sites.middle(site));
    if (distance(shape, there) <= tolerance) {
      add_point(
          points,
          options.jitter > 0.0 ? jittered(shape, sites, site, sites.middle(site), options) : there,
          volume);
    }
  });
}

// One point for the part of each box inside the shape.
void fill_clipped(const Shape& shape, const Sites& sites, const FillOptions& options,
                  FilledPoints& points) {
  std::vector<BoxPart> boxes = parts_of(shape, sites);
  merge_slivers(boxes, options.smallest_volume * sites.box_volume());
  for (const BoxPart& box : boxes) {
    const Vec3 middle = box.part.is_whole ? sites.middle(box.site) : box.part.centroid;
    add_point(points,
              options.jitter > 0.0 ? jittered(shape, sites, box.site, middle, options)
                                   : sites.to_scene(middle),
              box.part.is_whole ? sites.box_volume() : box.part.volume);
  }
}

// As many uniform points as boxes fit in, all of one volume; the volumes sum to the shape's.
void fill_random(const Shape& shape, const Sites& sites, const FillOptions& options,
                 FilledPoints& points) {
  const double whole = volume_of(parts_of(shape, sites));
  if (whole <= 0.0) {
    return;
  }
  const auto count = std::max<Index>(1, std::llround(whole / sites.box_volume()));
  const Bounds box = bounds(shape);
  Random random(options.seed);
  while (points.size() < static_cast<std::size_t>(count)) {
    Vec3 at = Vec3::Zero();
    for (int axis = 0; axis < points.dimension; ++axis) {
      at[axis] = random.uniform(box.lower[axis], box.upper[axis]);
    }
    if (distance(shape, at) <= 0.0) {
      add_point(points, at, whole / static_cast<double>(count));
    }
  }
}

void check_options(const Lattice& lattice, const FillOptions& options, int dimension) {
  require(dimension >= 1 && dimension <= 3, "fill: dimension must be 1, 2 or 3, got ", dimension);
  require_positive(lattice.cell, "fill", "cell");
  require(lattice.points_per_axis >= 1, "fill: points_per_axis must be at least 1, got ",
          lattice.points_per_axis);
  require(options.jitter >= 0.0 && options.jitter <= 0.5,
          "fill: jitter must be 0 to 0.5 of the spacing, got ", options.jitter);
  require(std::isfinite(options.degrees), "fill: degrees must be finite, got ", options.degrees);
  require(options.degrees == 0.0 || dimension > 1,
          "fill: a lattice of 1 dimension cannot be turned");
  require_numbers(options.center, 0, static_cast<std::size_t>(dimension), "fill", "center");
  require(!options.clip || !options.random,
          "fill: give clip or random, not both; random points have the volume of the shape anyway");
  require(options.smallest_volume >= 0.0 && options.smallest_volume <= 0.5,
          "fill: smallest_volume must be 0 to 0.5 of a lattice box, got ", options.smallest_volume);
  require(!options.random || options.jitter == 0.0, "fill: give random or jitter, not both");
}

// The shape, cut by the ends of the grid along axes where it has none.
Shape with_ends(const Shape& shape, const FillOptions& options, int dimension) {
  const Bounds own = bounds(shape);
  Box ends;
  bool infinite = false;
  for (int axis = 0; axis < dimension; ++axis) {
    const bool below = std::isinf(own.lower[axis]), above = std::isinf(own.upper[axis]);
    ends.lower.push_back(below ? options.within.lower[axis] : own.lower[axis]);
    ends.upper.push_back(above ? options.within.upper[axis] : own.upper[axis]);
    require(std::isfinite(ends.lower.back()) && std::isfinite(ends.upper.back()), kind_of(shape),
            ": the body has no end along the ", "xyz"[axis],
            " axis; intersect it with a box before filling it with points");
    infinite |= below || above;
  }
  return infinite ? Shape(Intersection{{shape, ends}}) : shape;
}

}  // namespace

Vec3 FilledPoints::place(std::size_t row) const {
  Vec3 at = Vec3::Zero();
  std::copy_n(position.data() + row * static_cast<std::size_t>(dimension), dimension, at.data());
  return at;
}

int points_per_axis(int points_per_cell, int dimension) {
  const auto power = [&](int root) {
    long long product = 1;
    for (int axis = 0; axis < dimension; ++axis) {
      product *= root;
    }
    return product;
  };
  require(points_per_cell >= 1, "points_per_cell must be at least 1, got ", points_per_cell);
  int root = static_cast<int>(std::lround(std::pow(points_per_cell, 1.0 / dimension)));
  if (power(root) > points_per_cell) {
    --root;
  }
  require(power(root) == points_per_cell, "points_per_cell must be a whole number to the power of ",
          dimension, " in ", dimension, " dimensions: ", power(root), " or ", power(root + 1),
          ", got ", points_per_cell);
  return root;
}

Shape ready_to_fill(const Shape& shape, const Lattice& lattice, const FillOptions& options,
                    int dimension) {
  check_options(lattice, options, dimension);
  check(shape, dimension);
  return with_ends(shape, options, dimension);
}

FilledPoints fill(const Shape& shape, const Lattice& lattice, const FillOptions& options,
                  int dimension) {
  const Shape body = ready_to_fill(shape, lattice, options, dimension);
  const Sites sites(body, lattice, options, dimension);
  FilledPoints points;
  points.dimension = dimension;
  points.spacing = sites.spacing();
  if (options.clip) {
    fill_clipped(body, sites, options, points);
  } else if (options.random) {
    fill_random(body, sites, options, points);
  } else {
    fill_lattice(body, sites, options, points);
  }
  require(points.size() > 0, kind_of(shape), ": no point of the lattice of spacing ",
          points.spacing, " m lies inside: choose smaller cells or more points per cell");
  return points;
}

}  // namespace lapilli
