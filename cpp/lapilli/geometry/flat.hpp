#pragma once

#include <optional>
#include <vector>

#include "lapilli/geometry/clip.hpp"
#include "lapilli/geometry/shape.hpp"

namespace lapilli {

/// The corners of a shape that is a polygon in the x-y plane (box of two axes, polygon, turned or
/// moved ones), counter-clockwise; nothing for other shapes.
std::optional<Outline> outline_of(const Shape& shape);

/// A convex region with flat sides, counted `sign` times; the cuts have normals of length 1.
struct FlatTerm {
  double sign = 1.0;
  std::vector<Cut<3>> cuts;
};

/// Convex regions whose signed sum is the shape: boxes, half-spaces, polygons and their unions,
/// intersections and differences, turned or moved. Nothing for other shapes and for combinations
/// of more than 512 regions.
std::optional<std::vector<FlatTerm>> terms_of(const Shape& shape);

/// A shape of one kind that was turned and moved: x = turn y + shift for its places y.
template <class Kind>
struct Placed {
  const Kind* shape;
  Mat3 turn = Mat3::Identity();
  Vec3 shift = Vec3::Zero();
};

/// What is left of `shape` when turns and translations are peeled off, if it is a `Kind`.
template <class Kind>
std::optional<Placed<Kind>> placed_kind(const Shape& shape) {
  if (const auto* found = std::get_if<Kind>(&shape)) {
    return Placed<Kind>{found};
  }
  std::optional<Placed<Kind>> inner;
  if (const auto* rotated = std::get_if<Rotated>(&shape)) {
    if ((inner = placed_kind<Kind>(*rotated->shape))) {
      const Vec3 center = place(rotated->center);
      const Mat3 turn = rotated->matrix();
      inner->turn = turn * inner->turn;
      inner->shift = center + turn * (inner->shift - center);
    }
  } else if (const auto* translated = std::get_if<Translated>(&shape)) {
    if ((inner = placed_kind<Kind>(*translated->shape))) {
      inner->shift += place(translated->by);
    }
  }
  return inner;
}

}  // namespace lapilli
