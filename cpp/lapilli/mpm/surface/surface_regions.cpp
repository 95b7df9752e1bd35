#include "lapilli/mpm/surface/surface_regions.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/mpm/surface/corner_faces.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {
namespace {

// Lengths in cells, areas in faces of a cell.
constexpr double least_width = 0.1;   // of the ramp there
constexpr double corner_width = 0.5;  // of the ramp across a corner's faces, which are pieces
constexpr double least_part = 0.02;   // less area gives no place
constexpr double farthest = 1.6;      // from a node to its surface
constexpr double least_along = 0.1;   // of a corner's area vector along its weight

/// Share of a piece of surface that a region covers, by a ramp over `width` cells of the piece.
template <int Dim>
double covered(const Shape& region, const Vec3& centre, const Vec<Dim>& direction, double cell,
               const Vec<Dim>& width) {
  const double from = distance(region, centre);
  if (std::abs(from) > 2.0 * cell) {
    return from < 0.0 ? 1.0 : 0.0;
  }
  const Vec<Dim> outward = gradient(region, centre).template head<Dim>();
  const double across = outward.dot(direction);
  const double along = (outward - across * direction).cwiseProduct(width).template lpNorm<1>();
  const double reach = region_slack * cell * std::pow(across, 8);
  return std::clamp(0.5 - (from - reach) / (cell * std::max(along, least_width)), 0.0, 1.0);
}

/// Divides pieces of surface among laws; what no law has counts as one more, the last.
template <int Dim>
class Division {
 public:
  Division(const Grid<Dim>& grid, const NodalAreas<Dim>& areas,
           std::span<const SurfacePlace<Dim>> places, std::span<const Shape* const> regions)
      : shares(regions.size() + 1, 0.0),
        vectors(regions.size() + 1),
        grid_(grid),
        areas_(areas),
        places_(places),
        regions_(regions) {}

  /// Divide one node.
  void divide(std::size_t k) {
    share(places_[k].centre, places_[k].direction, places_[k].width, shares);
    for (std::size_t law = 0; law < shares.size(); ++law) {
      vectors[law] = shares[law] * areas_.vector[k];
    }
    if (!areas_.corner.empty() && areas_.corner[k] > 0.0 && !places_[k].moment.isZero(0.0)) {
      divide_corner(k);
    }
  }

  // Of the node divided last.
  std::vector<double> shares;
  std::vector<Vec<Dim>> vectors;

 private:
  void share(const Vec3& centre, const Vec<Dim>& direction, const Vec<Dim>& width,
             std::vector<double>& to) const {
    double left = 1.0;
    for (std::size_t law = 0; law < regions_.size(); ++law) {
      const Shape* region = regions_[law];
      to[law] = left;
      if (left > 0.0 && region != nullptr) {
        to[law] *= covered<Dim>(*region, centre, direction, grid_.cell_size(), width);
      }
      left -= to[law];
    }
    to.back() = left;
  }

  /// Face by face, each at its own place, as far as the node is one of a corner.
  void divide_corner(std::size_t k) {
    const Vec<Dim>& a = areas_.vector[k];
    const double h = grid_.cell_size(), least = least_part * std::pow(h, Dim - 1);
    std::vector<Vec<Dim>> found(shares.size(), Vec<Dim>::Zero());
    std::vector<double> of_face(shares.size());
    Vec<Dim> rest = a;
    for (const CornerFace<Dim>& face : faces_of_corner(grid_, areas_, k)) {
      const double area = face.dual.dot(a);
      const Vec<Dim> offset = places_[k].moment * face.dual / area;
      if (!(area > least) || !(offset.norm() < farthest * h)) {
        continue;
      }
      Vec3 centre = Vec3::Zero();
      centre.template head<Dim>() = grid_.node_position(areas_.node[k]) + offset;
      share(centre, face.normal, Vec<Dim>::Constant(corner_width), of_face);
      for (std::size_t law = 0; law < shares.size(); ++law) {
        found[law] += of_face[law] * area * face.normal;
      }
      rest -= area * face.normal;
    }
    for (std::size_t law = 0; law < shares.size(); ++law) {
      found[law] += shares[law] * rest;
      vectors[law] += areas_.corner[k] * (found[law] - vectors[law]);
    }
    if (areas_.weight[k].dot(a) > least_along * a.norm()) {
      double sum = 0.0;
      for (std::size_t law = 0; law < shares.size(); ++law) {
        shares[law] = std::max(0.0, areas_.weight[k].dot(vectors[law]));
        sum += shares[law];
      }
      for (double& one : shares) {
        one /= sum;
      }
    }
  }

  const Grid<Dim>& grid_;
  const NodalAreas<Dim>& areas_;
  std::span<const SurfacePlace<Dim>> places_;
  std::span<const Shape* const> regions_;
};

/// One flag a cell: whether a point in it can touch one of the nodes.
template <int Dim>
std::vector<unsigned char> cells_near(const Grid<Dim>& grid, std::span<const Index> nodes) {
  constexpr int across = 4;  // cells from two below a node to one above
  constexpr int block = Dim == 1 ? across : Dim == 2 ? across * across : across * across * across;
  std::vector<unsigned char> near(static_cast<std::size_t>(grid.cell_count()), 0);
  for (const Index node : nodes) {
    for (int k = 0; k < block; ++k) {
      auto cell = grid.node_at(node);
      bool inside = true;
      for (int axis = 0, rest = k; axis < Dim; ++axis, rest /= across) {
        cell[axis] += rest % across - 2;
        inside = inside && cell[axis] >= 0 && cell[axis] < grid.cells(axis);
      }
      if (inside) {
        near[grid.cell_index(cell)] = 1;
      }
    }
  }
  return near;
}

/// Of the surface across a face that is held, the half before it.
template <int Dim>
void halve_at_face(const Grid<Dim>& grid, Index node, int face, SurfacePlace<Dim>& place) {
  constexpr int padding = Grid<Dim>::padding;
  constexpr double most_across = 0.7;  // of the normal; more lies along the face
  const int axis = face / 2, inward = face % 2 == 0 ? 1 : -1;
  auto at = grid.node_at(node);
  const int layer = inward > 0 ? padding : grid.nodes(axis) - 1 - padding;
  if (inward * (at[axis] - layer) > 0 || std::abs(place.direction[axis]) > most_across) {
    return;
  }
  at[axis] = layer;
  const double wall = grid.node_position(grid.node_index(at))[axis];
  place.centre[axis] = wall + inward * 0.25 * grid.cell_size();
  place.width[axis] = 0.5;
}

}  // namespace

template <int Dim>
std::vector<SurfacePlace<Dim>> surface_places(const Grid<Dim>& grid, const Points& points,
                                              ShapeFunction shape,
                                              std::span<const double> half_width,
                                              const NodalAreas<Dim>& areas,
                                              const ContactFaces& held) {
  const std::size_t count = areas.node.size();
  std::vector<int> row_of(static_cast<std::size_t>(grid.node_count()), -1);
  for (std::size_t k = 0; k < count; ++k) {
    row_of[areas.node[k]] = static_cast<int>(k);
  }
  std::vector<Mat<Dim>> moment(count, Mat<Dim>::Zero());
  std::vector<Vec<Dim>> vector(count, Vec<Dim>::Zero());
  const std::vector<unsigned char> near = cells_near<Dim>(grid, areas.node);
  for (Index point = 0; point < points.size(); ++point) {
    const Vec<Dim> x = points.position<Dim>(point);
    if (near[grid.cell_index(grid.cell_containing(x))] == 0) {
      continue;
    }
    const double volume = points.volume()[point];
    with_shape(shape, half_width[points.body()[point]], [&](auto chosen) {
      const Weights<Dim, decltype(chosen)> weights(grid, chosen, x.data());
      weights.for_each_node(grid, [&](Index node, double value, const Vec<Dim>& slope) {
        if (const int row = row_of[node]; row >= 0) {
          moment[row] += volume * (x - grid.node_position(node)) * slope.transpose();
          moment[row].diagonal().array() += volume * value;
          vector[row] += volume * slope;
        }
      });
    });
  }
  const double h = grid.cell_size();
  std::vector<SurfacePlace<Dim>> places(count);
  for (std::size_t k = 0; k < count; ++k) {
    places[k] = {areas.position[k], areas.normal[k], Mat<Dim>::Zero()};
    for (int face = 0; face < 2 * Dim; ++face) {
      if (held[static_cast<std::size_t>(face)]) {
        halve_at_face(grid, areas.node[k], face, places[k]);
      }
    }
    const Vec<Dim>& a = areas.vector[k];
    const double size = a.norm();
    if (size < least_part * std::pow(h, Dim - 1) || (a - vector[k]).norm() > 1e-9 * size) {
      continue;
    }
    const Vec<Dim> direction = a / size, offset = moment[k] * direction / size;
    if (offset.norm() < farthest * h && places[k].width.isOnes(0.0)) {
      places[k].centre.template head<Dim>() = grid.node_position(areas.node[k]) + offset;
      places[k].direction = direction;
      places[k].moment = moment[k];
    }
  }
  return places;
}

template <int Dim>
std::vector<std::vector<SurfacePart<Dim>>> divide_surface(
    const Grid<Dim>& grid, const NodalAreas<Dim>& areas,
    const std::function<std::vector<SurfacePlace<Dim>>()>& places,
    std::span<const Shape* const> regions) {
  std::vector<std::vector<SurfacePart<Dim>>> parts(regions.size());
  if (regions.empty()) {
    return parts;
  }
  if (regions.front() == nullptr) {  // the first law has all
    for (std::size_t k = 0; k < areas.node.size(); ++k) {
      parts.front().push_back({k, 1.0, areas.vector[k]});
    }
    return parts;
  }
  const std::vector<SurfacePlace<Dim>> known = places();
  Division<Dim> node(grid, areas, known, regions);
  for (std::size_t k = 0; k < areas.node.size(); ++k) {
    node.divide(k);
    for (std::size_t law = 0; law < regions.size(); ++law) {
      if (node.shares[law] > 0.0 || !node.vectors[law].isZero(0.0)) {
        parts[law].push_back({k, node.shares[law], node.vectors[law]});
      }
    }
  }
  return parts;
}

#define LAPILLI_INSTANTIATE(Dim)                                               \
  template std::vector<SurfacePlace<Dim>> surface_places(                      \
      const Grid<Dim>&, const Points&, ShapeFunction, std::span<const double>, \
      const NodalAreas<Dim>&, const ContactFaces&);                            \
  template std::vector<std::vector<SurfacePart<Dim>>> divide_surface(          \
      const Grid<Dim>&, const NodalAreas<Dim>&,                                \
      const std::function<std::vector<SurfacePlace<Dim>>()>&, std::span<const Shape* const>);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
