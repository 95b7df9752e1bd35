#include <algorithm>
#include <cmath>
#include <optional>

#include "lapilli/mpm/quasi_static/simplex_cut.hpp"
#include "lapilli/mpm/quasi_static/surface.hpp"
#include "lapilli/mpm/quasi_static/surface_piece.hpp"
#include "lapilli/mpm/surface/cube_parts.hpp"

namespace lapilli {
namespace {

constexpr double nudge = 1e-7;  // cells; how far inside the material its cell is looked up

constexpr double flat = 1e-9;        // cells; how near to planes flat faces are
constexpr double slight_bend = 0.8;  // cosine between normals of one facet

constexpr int halvings[] = {0, 0, 5, 3};

/// The surface in one cell.
template <int Dim>
class CellCutter {
 public:
  CellCutter(const LevelSet& surface, double cell_size, Trims trims)
      : surface_(surface),
        nudged_{[this](const Vec3& x) { return surface_.distance(x) - shift_; }, surface.normal},
        cell_size_(cell_size),
        shift_(nudge * cell_size),
        trims_(trims) {}
  CellCutter(const CellCutter&) = delete;
  CellCutter& operator=(const CellCutter&) = delete;

  std::vector<Facet<Dim>> cut(int number, const typename Grid<Dim>::Cell& cell,
                              const Cube<Dim>& cube) {
    facets_.clear();
    proto_ = {number, cell, {}};
    cut(cube, halvings[Dim]);
    std::erase_if(facets_, [&](const Facet<Dim>& facet) {
      return !(facet.area() > 1e-13 * std::pow(cell_size_, Dim - 1));
    });
    return std::move(facets_);
  }

 private:
  using Fit = PlaneFit<Dim>;

  void cut(const Cube<Dim>& cube, int halvings_left) {
    const Fit fit = fit_planes<Dim>(nudged_, cube, flat * cell_size_, false);
    if (fit.state == Fit::State::full || fit.state == Fit::State::empty) {
      return;
    }
    if (fit.state == Fit::State::cut) {
      const std::vector<SurfacePiece<Dim>> faces = faces_of(cube, fit);
      if (std::ranges::all_of(faces, [this](const auto& face) { return is_on_surface(face); })) {
        add_faces(faces);
        return;
      }
    }
    if (halvings_left == 0 || !has_edge(cube)) {
      add_curve(cube);
      return;
    }
    for (int which = 0; which < (1 << Dim); ++which) {
      cut(cube.part(which), halvings_left - 1);
    }
  }

  /// The place of the surface nearest to another one; nothing where it is far.
  std::optional<Vec<Dim>> foot_in(const Vec<Dim>& from, const Cube<Dim>& cube) const {
    const Vec<Dim> foot = foot_of<Dim>(surface_, from, 1e-12 * cell_size_);
    const bool is_near = (foot - cube.middle()).cwiseAbs().maxCoeff() < 0.75 * cube.side;
    return is_near ? std::optional(foot) : std::nullopt;
  }

  Vec<Dim> normal_at(const Vec<Dim>& x) const {
    return surface_.normal(in_space<Dim>(x)).template head<Dim>();
  }

  /// Whether faces meet in or beside a cube: normals that differ still do as their places draw near
  /// to each other.
  bool has_edge(const Cube<Dim>& cube) const {
    std::vector<Vec<Dim>> feet;
    for (int k = -1; k < (1 << Dim); ++k) {
      if (const auto foot = foot_in(k < 0 ? cube.middle() : cube.corner(k), cube)) {
        feet.push_back(*foot);
      }
    }
    for (std::size_t k = 0; k < feet.size(); ++k) {
      for (std::size_t j = 0; j < k; ++j) {
        if (bends(feet[k], feet[j]) && jumps_between(feet[k], feet[j], cube)) {
          return true;
        }
      }
    }
    return false;
  }

  bool bends(const Vec<Dim>& a, const Vec<Dim>& b) const {
    return normal_at(a).dot(normal_at(b)) < slight_bend;
  }

  bool jumps_between(Vec<Dim> a, Vec<Dim> b, const Cube<Dim>& cube) const {
    for (int round = 0; round < 8; ++round) {
      const auto middle = foot_in(0.5 * (a + b), cube);
      if (!middle) {
        return false;
      }
      if (bends(a, *middle)) {
        b = *middle;
      } else if (bends(*middle, b)) {
        a = *middle;
      } else {
        return false;
      }
    }
    return true;
  }

  /// Flat faces, back at their place; the cube goes with them, so that every part belongs to one.
  std::vector<SurfacePiece<Dim>> faces_of(const Cube<Dim>& cube, Fit fit) const {
    for (Cut<Dim>& plane : fit.planes) {
      plane.offset -= shift_;
    }
    std::vector<SurfacePiece<Dim>> faces;
    for (std::size_t k = 0; k < fit.planes.size(); ++k) {
      const Cube<Dim> there{cube.low - shift_ * fit.planes[k].normal, cube.side};
      SurfacePiece<Dim> face = surface_piece(there, fit, k);
      if (!face.corners.empty()) {
        faces.push_back(std::move(face));
      }
    }
    return faces;
  }

  /// A face that no sample of the cube was nearest to would have cut the others.
  bool is_on_surface(const SurfacePiece<Dim>& face) const {
    const auto is_on = [this](const Vec<Dim>& place) {
      return std::abs(surface_.distance(in_space<Dim>(place))) <= 10.0 * flat * cell_size_;
    };
    return std::ranges::all_of(face.corners, is_on) && is_on(face.middle());
  }

  void add_faces(const std::vector<SurfacePiece<Dim>>& faces) {
    for (const SurfacePiece<Dim>& face : faces) {
      std::vector<SurfacePoint<Dim>> points;
      for (const Piece<Dim>& part : trim_to<Dim>(trims_, face.corners, 1e-12 * cell_size_)) {
        add_points<Dim>(part, face.normal, points);
      }
      for (const SurfacePoint<Dim>& point : points) {
        facet_along(face.normal).points.push_back(point);
      }
    }
  }

  void add_curve(const Cube<Dim>& cube) {
    std::vector<SurfacePoint<Dim>> points;
    cut_simplices<Dim>(surface_, cube, shift_, trims_, points);
    for (const SurfacePoint<Dim>& point : points) {
      facet_along(point.normal).points.push_back(point);
    }
  }

  /// Slight bends belong to a curve: one facet, or its mean gaps would hold the motion along it as
  /// well.
  Facet<Dim>& facet_along(const Vec<Dim>& normal) {
    for (Facet<Dim>& facet : facets_) {
      if (facet.points.back().normal.dot(normal) > slight_bend) {
        return facet;
      }
    }
    facets_.push_back(proto_);
    return facets_.back();
  }

  const LevelSet& surface_;
  LevelSet nudged_;
  double cell_size_, shift_;
  Trims trims_;
  Facet<Dim> proto_;
  std::vector<Facet<Dim>> facets_;
};

}  // namespace

template <int Dim>
std::vector<Facet<Dim>> cut_level_set(const Grid<Dim>& grid, std::span<const char> cells,
                                      const LevelSet& surface, int number, Trims trims) {
  const double h = grid.cell_size(), reach = 0.51 * h * std::sqrt(static_cast<double>(Dim));
  CellCutter<Dim> cutter(surface, h, trims);
  std::vector<Facet<Dim>> facets;
  for (Index index = 0; index < grid.cell_count(); ++index) {
    if (!cells[index]) {
      continue;
    }
    const auto cell = grid.cell_at(index);
    const Cube<Dim> cube{grid.node_position(grid.node_index(cell)), h};
    if (std::abs(surface.distance(in_space<Dim>(cube.middle()))) > reach) {
      continue;
    }
    for (Facet<Dim>& facet : cutter.cut(number, cell, cube)) {
      facets.push_back(std::move(facet));
    }
  }
  return facets;
}

template std::vector<Facet<2>> cut_level_set(const Grid<2>&, std::span<const char>, const LevelSet&,
                                             int, Trims);
template std::vector<Facet<3>> cut_level_set(const Grid<3>&, std::span<const char>, const LevelSet&,
                                             int, Trims);

}  // namespace lapilli
