#include "lapilli/mpm/heat/touching_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/mpm/heat/thin_columns.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {
namespace {

/// Feet tell an area in the mean alone: each so much too much or too little, all of them together
/// so much (corners of a body may lose one).
constexpr double most_scale = 2.0, most_in_all = 1.1;
constexpr int passes = 4;
/// Nodes further in lie about along the normal and have no free surface to speak of. Nodes so many
/// cells deep have whole boxes beyond them.
constexpr double steepest = 0.2, most_further_in = 0.3, deep_enough = 0.6;

/// One after the other; 0 where one of them insulates.
double in_series(double one, double other) {
  return one > 0.0 && other > 0.0 ? 1.0 / (1.0 / one + 1.0 / other) : 0.0;
}

/// Sums over the feet around a node, by linear functions.
template <int Dim>
struct Seen {
  Index node = 0;
  double area = 0.0;                   // m^(dim-1)
  Vec<Dim> normal = Vec<Dim>::Zero();  // times area
  Vec<Dim> place = Vec<Dim>::Zero();   // times area
};

/// Call body(node, weight) around a foot. Boxes of points fill the body: their sums of GIMP
/// gradients are those of linear functions.
template <int Dim, class Body>
void around(const Grid<Dim>& grid, ShapeFunction function, const Vec<Dim>& place,
            const Body& body) {
  const bool is_wide = function == ShapeFunction::bspline;
  with_shape(is_wide ? function : ShapeFunction::linear, 0.5, [&](auto shape) {
    const Weights<Dim, decltype(shape)> weights(grid, shape, place.data());
    weights.for_each_node(grid, [&](Index node, double weight, const Vec<Dim>&) {
      if (weight > 0.0) {
        body(node, weight);
      }
    });
  });
}

template <int Dim>
std::vector<Seen<Dim>> seen_by_nodes(const Grid<Dim>& grid, ShapeFunction function,
                                     const std::vector<SurfaceFoot<Dim>>& feet) {
  std::vector<Seen<Dim>> all;
  for (const SurfaceFoot<Dim>& foot : feet) {
    around(grid, function, foot.place, [&](Index node, double weight) {
      const double area = weight * foot.area;
      all.push_back({node, area, area * foot.normal, area * foot.place});
    });
  }
  std::ranges::stable_sort(all, {}, &Seen<Dim>::node);
  std::size_t last = 0;
  for (std::size_t k = 1; k < all.size(); ++k) {
    if (all[k].node != all[last].node) {
      all[++last] = all[k];
      continue;
    }
    all[last].area += all[k].area;
    all[last].normal += all[k].normal;
    all[last].place += all[k].place;
  }
  all.resize(std::min(all.size(), last + 1));
  return all;
}

template <int Dim>
TouchingNode<Dim> node_of(const Seen<Dim>& seen, const Vec<Dim>& area_vector) {
  const double length = seen.normal.norm();
  const Vec<Dim> normal = length > 0.0 ? Vec<Dim>(seen.normal / length) : Vec<Dim>::Zero();
  const double facing = std::max(0.0, -area_vector.dot(normal));
  const double free = (area_vector + facing * normal).norm();
  TouchingNode<Dim> node;
  node.node = seen.node;
  node.free_share = free + facing > 0.0 ? free / (free + facing) : 1.0;
  node.place.template head<Dim>() = seen.place / seen.area;
  return node;
}

template <int Dim>
const Seen<Dim>& find(const std::vector<Seen<Dim>>& seen, Index node) {
  return *std::ranges::lower_bound(seen, node, {}, &Seen<Dim>::node);
}

/// Call body(neighbour, way to it in cells) for the neighbours of a node.
template <int Dim, class Body>
void around_node(const Grid<Dim>& grid, Index node, const Body& body) {
  for (int number = 0; number < (Dim == 3 ? 27 : Dim == 2 ? 9 : 3); ++number) {
    Vec<Dim> way;
    Index neighbour = node;
    for (int axis = 0, rest = number; axis < Dim; ++axis, rest /= 3) {
      way[axis] = rest % 3 - 1;
      neighbour += (rest % 3 - 1) * grid.node_stride(axis);
    }
    if (neighbour != node && neighbour >= 0 && neighbour < grid.node_count()) {
      body(neighbour, way);
    }
  }
}

/// What the nodes one cell further in add to the area vectors along the normals. Boxes of points
/// beside the surface, which were cut and joined, do not tile; with these nodes they do not count.
template <int Dim>
double further_in(const Grid<Dim>& grid, const std::vector<Seen<Dim>>& seen,
                  const std::vector<Vec<Dim>>& area_vector, const std::vector<double>& capacity) {
  std::vector<std::pair<Index, double>> added;  // node, area
  const double most = most_further_in * std::pow(grid.cell_size(), Dim - 1);
  for (const Seen<Dim>& one : seen) {
    const double length = one.normal.norm();
    if (!(length > 0.0)) {
      continue;
    }
    const Vec<Dim> normal = one.normal / length;
    const Vec<Dim> from = grid.node_position(one.node) - one.place / one.area;
    if (from.dot(normal) > deep_enough * grid.cell_size()) {
      continue;
    }
    around_node(grid, one.node, [&](Index node, const Vec<Dim>& way) {
      const double area = -area_vector[node].dot(normal);
      const bool is_known = std::ranges::binary_search(seen, node, {}, &Seen<Dim>::node);
      if (way.dot(normal) > steepest * way.norm() && !is_known && capacity[node] > 0.0 &&
          std::abs(area) < most) {
        added.emplace_back(node, area);
      }
    });
  }
  std::ranges::stable_sort(added, {}, &std::pair<Index, double>::first);
  double sum = 0.0;
  for (std::size_t k = 0; k < added.size(); ++k) {
    sum += k == 0 || added[k].first != added[k - 1].first ? added[k].second : 0.0;
  }
  return sum;
}

/// The feet with the area that the area vectors of the nodes around each have along its normal, as
/// far as the body is not `thin` there.
template <int Dim>
std::vector<SurfaceFoot<Dim>> scaled(const Grid<Dim>& grid, ShapeFunction function,
                                     const std::vector<SurfaceFoot<Dim>>& given,
                                     const std::vector<double>& thin,
                                     const std::vector<Vec<Dim>>& area_vector,
                                     const std::vector<double>& capacity) {
  std::vector<SurfaceFoot<Dim>> feet = given;
  for (int pass = 0; pass < passes; ++pass) {
    const std::vector<Seen<Dim>> seen = seen_by_nodes(grid, function, feet);
    for (std::size_t k = 0; k < feet.size(); ++k) {
      double wanted = 0.0, found = 0.0;
      around(grid, function, feet[k].place, [&](Index node, double) {
        wanted -= area_vector[node].dot(feet[k].normal);
        found += find(seen, node).normal.dot(feet[k].normal);
      });
      const double area = found > 0.0 ? feet[k].area * wanted / found : given[k].area;
      feet[k].area = std::clamp(area, given[k].area / most_scale, given[k].area * most_scale);
    }
  }
  const std::vector<Seen<Dim>> seen = seen_by_nodes(grid, function, feet);
  double wanted = further_in(grid, seen, area_vector, capacity), found = 0.0;
  for (const Seen<Dim>& one : seen) {
    const double length = one.normal.norm();
    wanted -= length > 0.0 ? area_vector[one.node].dot(one.normal) / length : 0.0;
    found += length;
  }
  const double in_all =
      found > 0.0 ? std::clamp(wanted / found, 1.0 / most_in_all, most_in_all) : 1.0;
  for (std::size_t k = 0; k < feet.size(); ++k) {
    feet[k].area = (1.0 - thin[k]) * in_all * feet[k].area + thin[k] * given[k].area;
  }
  return feet;
}

/// Adds those that the box of the foot's point reaches beyond the surface and no foot does.
template <int Dim>
void add_outer_nodes(const Grid<Dim>& grid, ShapeFunction function, const Points& points,
                     const SurfaceFoot<Dim>& foot, double half_width,
                     const std::vector<Seen<Dim>>& seen, const std::vector<double>& capacity,
                     std::vector<OuterNode>& outer) {
  Index heir = -1;
  double most = 0.0;
  around(grid, function, foot.place, [&](Index node, double weight) {
    if (weight * capacity[node] > most) {
      most = weight * capacity[node];
      heir = node;
    }
  });
  with_shape(function, half_width, [&](auto shape) {
    const double* x = points.position().data() + foot.row * Dim;
    const Weights<Dim, decltype(shape)> weights(grid, shape, x);
    weights.for_each_node(grid, [&](Index node, double, const Vec<Dim>&) {
      const bool is_beyond = (grid.node_position(node) - foot.place).dot(foot.normal) < 0.0;
      const bool is_seen = std::ranges::binary_search(seen, node, {}, &Seen<Dim>::node);
      if (heir >= 0 && capacity[node] > 0.0 && is_beyond && !is_seen) {
        outer.push_back({node, heir});
      }
    });
  });
}

}  // namespace

double TouchingPiece::coefficient(double conductance, bool is_inner) const {
  const double beyond = share_beyond * conductance;
  if (!is_inner) {
    return beyond;
  }
  if (!(depth > 0.0)) {
    return conductance;
  }
  const double between = depth + reach;
  const double by_nodes_beyond =
      share_beyond > 0.0 ? in_series(beyond, conductivity * depth / (between * between)) : 0.0;
  return std::max(0.0, in_series(conductance, conductivity / depth) - by_nodes_beyond);
}

template <int Dim>
double TouchingSurface<Dim>::area() const {
  double sum = 0.0;
  for (const TouchingPiece& piece : pieces) {
    sum += piece.area;
  }
  return sum;
}

template <int Dim>
TouchingSurface<Dim> touching_surface(const Grid<Dim>& grid, ShapeFunction function,
                                      const Points& points,
                                      const std::vector<SurfaceFoot<Dim>>& feet,
                                      const HeatCoefficients<Dim>& coefficients,
                                      const std::vector<Vec<Dim>>& area_vector,
                                      const std::vector<double>& capacity) {
  TouchingSurface<Dim> surface;
  const std::vector<SurfaceFoot<Dim>> all =
      scaled(grid, function, feet, thin_columns(grid, points, feet, coefficients, capacity),
             area_vector, capacity);
  const std::vector<Seen<Dim>> seen = seen_by_nodes(grid, function, all);
  for (const Seen<Dim>& one : seen) {
    surface.nodes.push_back(node_of<Dim>(one, area_vector[one.node]));
  }
  for (const SurfaceFoot<Dim>& foot : all) {
    const Index body = points.body()[foot.row];
    TouchingPiece piece;
    piece.area = foot.area;
    piece.conductivity = foot.normal.dot(coefficients.conductivity[body] * foot.normal);
    piece.first_link = surface.links.size();
    double below = 0.0, beyond = 0.0;
    around(grid, function, foot.place, [&](Index node, double weight) {
      if (!(capacity[node] > 0.0)) {
        return;
      }
      const double depth = (grid.node_position(node) - foot.place).dot(foot.normal);
      const bool is_inner = depth >= 0.0;
      (is_inner ? below : beyond) += weight;
      (is_inner ? piece.depth : piece.reach) += weight * std::abs(depth);
      const auto slot = static_cast<std::size_t>(&find(seen, node) - seen.data());
      surface.links.push_back({slot, weight, is_inner});
    });
    piece.links_end = surface.links.size();
    if (!(below + beyond > 0.0)) {
      continue;
    }
    piece.depth = below > 0.0 ? piece.depth / below : 0.0;
    piece.reach = beyond > 0.0 ? piece.reach / beyond : 0.0;
    piece.share_beyond = beyond / (below + beyond);
    for (std::size_t k = piece.first_link; k < piece.links_end; ++k) {
      NodeLink& link = surface.links[k];
      link.area *= piece.area / (link.is_inner ? below : beyond);
    }
    surface.pieces.push_back(piece);
    add_outer_nodes(grid, function, points, foot,
                    coefficients.half_width[static_cast<std::size_t>(body)], seen, capacity,
                    surface.outer);
  }
  std::ranges::stable_sort(surface.outer, {}, &OuterNode::node);
  const auto twice =
      std::unique(surface.outer.begin(), surface.outer.end(),
                  [](const OuterNode& a, const OuterNode& b) { return a.node == b.node; });
  surface.outer.erase(twice, surface.outer.end());
  return surface;
}

#define LAPILLI_INSTANTIATE(Dim)                                                            \
  template struct TouchingSurface<Dim>;                                                     \
  template TouchingSurface<Dim> touching_surface(                                           \
      const Grid<Dim>&, ShapeFunction, const Points&, const std::vector<SurfaceFoot<Dim>>&, \
      const HeatCoefficients<Dim>&, const std::vector<Vec<Dim>>&, const std::vector<double>&);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
