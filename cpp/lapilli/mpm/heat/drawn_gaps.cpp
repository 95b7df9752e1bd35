#include "lapilli/mpm/heat/drawn_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/in_space.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/geometry/checks.hpp"
#include "lapilli/mpm/heat/cut_bodies.hpp"
#include "lapilli/mpm/surface/divide_pieces.hpp"

namespace lapilli {
namespace {

constexpr double drawn = 0.05;  // cells; no drawing means a gap this narrow

// Cosines between normals: of surfaces that face each other, and of flat ones turned by rounding
// at most, which round bodies beside the place where they touch are not.
constexpr double facing = -0.99, flat = -0.9999;

SurfaceFound::NearBody& near_body(std::size_t other, SurfaceFound& found) {
  for (SurfaceFound::NearBody& one : found.near) {
    if (one.other == other) {
      return one;
    }
  }
  return found.near.emplace_back(SurfaceFound::NearBody{other});
}

/// What is meant of a pair: of two that touch, a gap along a whole cell of flat surface.
bool is_drawn(const SurfaceFound::NearBody& near, double cell, int dimension) {
  return near.touches ? near.flat > std::pow(cell, dimension - 1) : near.width > 0.0;
}

std::string in_cells(double width, double cell) {
  return message(width, " m (", std::round(1e4 * width / cell) * 1e-4, " cells)");
}

}  // namespace

void enter_touching(std::span<const std::size_t> others, SurfaceFound& found) {
  for (const std::size_t other : others) {
    near_body(other, found).touches = true;
  }
}

template <int Dim>
void enter_facing(const SurfacePiece<Dim>& piece, std::span<const Shape> shapes, std::size_t body,
                  double cell, SurfaceFound& found) {
  const Vec3 middle = in_space<Dim>(piece.middle()), normal = in_space<Dim>(piece.normal);
  for (std::size_t other = 0; other < shapes.size(); ++other) {
    if (other == body || distance(shapes[other], middle) > 2.0 * drawn * cell) {
      continue;
    }
    const Vec3 at = project(shapes[body], middle);
    const double width = distance(shapes[other], at);
    const double cosine = gradient(shapes[other], at).dot(normal);
    if (width <= 0.0 || width > drawn * cell || cosine > facing) {
      continue;
    }
    SurfaceFound::NearBody& near = near_body(other, found);
    near.flat += cosine < flat ? piece.area() : 0.0;
    if (width > near.width) {
      near.width = width;
      near.middle = at;
    }
  }
}

std::string gap_between(const std::vector<std::string>& pair, std::span<const SurfaceFound> found,
                        const std::vector<HeatBody>& bodies, double cell) {
  const std::vector<std::string> names = names_of(bodies);
  double width = 0.0;
  for (std::size_t body = 0; body < found.size(); ++body) {
    for (const SurfaceFound::NearBody& near : found[body].near) {
      if ((names[body] == pair[0] && names[near.other] == pair[1]) ||
          (names[body] == pair[1] && names[near.other] == pair[0])) {
        width = std::max(width, near.width);
      }
    }
  }
  return width > 0.0 ? ": " + in_cells(width, cell) + " lie between them" : std::string();
}

std::vector<Note> drawn_gaps(std::span<const SurfaceFound> found,
                             const std::vector<HeatBody>& bodies, double cell, int dimension) {
  const std::vector<std::string> names = names_of(bodies);
  std::vector<Note> all;
  for (std::size_t body = 0; body < found.size(); ++body) {
    for (const SurfaceFound::NearBody& near : found[body].near) {
      const bool told =
          near.other < body && std::ranges::any_of(found[near.other].near, [&](const auto& back) {
            return back.other == body && is_drawn(back, cell, dimension);
          });
      if (told || !is_drawn(near, cell, dimension)) {
        continue;
      }
      all.push_back(note(
          "heat.drawn-gap", "heat: ", names[body], " and ", names[near.other], " are ",
          in_cells(near.width, cell), " apart at ", text_of(near.middle, dimension), " m, ",
          near.touches ? "beside where they touch: their faces there are free surface"
                       : "so that no heat passes between them",
          "; a gap below ", drawn, " cells looks like rounding of a drawing: bodies touch where ",
          "less than ", contact_gap, " cells (", contact_gap * cell, " m) are between them"));
    }
  }
  return all;
}

template void enter_facing<1>(const SurfacePiece<1>&, std::span<const Shape>, std::size_t, double,
                              SurfaceFound&);
template void enter_facing<2>(const SurfacePiece<2>&, std::span<const Shape>, std::size_t, double,
                              SurfaceFound&);
template void enter_facing<3>(const SurfacePiece<3>&, std::span<const Shape>, std::size_t, double,
                              SurfaceFound&);

}  // namespace lapilli
