#include "lapilli/geometry/flat.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {
namespace {

template <class Move>
Outline moved(const Outline& inner, const Move& move) {
  Outline all;
  for (const Vec<2>& corner : inner) {
    all.push_back(move(Vec3(corner[0], corner[1], 0.0)).template head<2>());
  }
  return all;
}

// The cuts after a motion of the shape; `move` takes places, `turn` directions.
template <class Move>
std::vector<Cut<3>> moved(const std::vector<Cut<3>>& inner, const Mat3& turn, const Move& move) {
  std::vector<Cut<3>> all;
  for (const Cut<3>& cut : inner) {
    all.push_back(cut_through<3>(move(cut.offset * cut.normal), turn * cut.normal));
  }
  return all;
}

std::vector<Cut<3>> cuts_of_box(const Box& box) {
  std::vector<Cut<3>> all;
  for (std::size_t axis = 0; axis < box.lower.size(); ++axis) {
    const Vec3 along = Vec3::Unit(static_cast<int>(axis));
    if (std::isfinite(box.lower[axis])) {
      all.push_back({-along, -box.lower[axis]});
    }
    if (std::isfinite(box.upper[axis])) {
      all.push_back({along, box.upper[axis]});
    }
  }
  return all;
}

std::optional<std::vector<Cut<3>>> cuts_of_all(const std::vector<Shape>& shapes) {
  std::vector<Cut<3>> all;
  for (const Shape& shape : shapes) {
    const auto cuts = cuts_of(shape);
    if (!cuts) {
      return std::nullopt;
    }
    all.insert(all.end(), cuts->begin(), cuts->end());
  }
  return all;
}

// Where a place goes when a shape is turned or moved.
Vec3 turned(const Rotated& rotated, const Vec3& x) {
  return place(rotated.center) + rotated.matrix() * (x - place(rotated.center));
}

}  // namespace

std::optional<Outline> outline_of(const Shape& shape) {
  if (const auto* box = std::get_if<Box>(&shape)) {
    if (box->lower.size() == 2) {
      return rectangle(place(box->lower).head<2>(), place(box->upper).head<2>());
    }
  } else if (const auto* polygon = std::get_if<Polygon>(&shape)) {
    Outline all;
    for (const auto& vertex : polygon->vertices) {
      all.push_back(place(vertex).head<2>());
    }
    if (moments(all).size < 0.0) {
      std::reverse(all.begin(), all.end());
    }
    return all;
  } else if (const auto* rotated = std::get_if<Rotated>(&shape)) {
    if (const auto inner = outline_of(*rotated->shape)) {
      return moved(*inner, [&](const Vec3& x) { return turned(*rotated, x); });
    }
  } else if (const auto* translated = std::get_if<Translated>(&shape)) {
    if (const auto inner = outline_of(*translated->shape)) {
      return moved(*inner, [&](const Vec3& x) { return Vec3(x + place(translated->by)); });
    }
  }
  return std::nullopt;
}

std::optional<std::vector<Cut<3>>> cuts_of(const Shape& shape) {
  if (const auto* box = std::get_if<Box>(&shape)) {
    return cuts_of_box(*box);
  }
  if (const auto* side = std::get_if<HalfSpace>(&shape)) {
    return std::vector{cut_through<3>(place(side->point), place(side->normal).normalized())};
  }
  if (const auto* common = std::get_if<Intersection>(&shape)) {
    return cuts_of_all(common->shapes);
  }
  if (const auto* rotated = std::get_if<Rotated>(&shape)) {
    if (const auto inner = cuts_of(*rotated->shape)) {
      return moved(*inner, rotated->matrix(), [&](const Vec3& x) { return turned(*rotated, x); });
    }
  } else if (const auto* translated = std::get_if<Translated>(&shape)) {
    if (const auto inner = cuts_of(*translated->shape)) {
      return moved(*inner, Mat3::Identity(),
                   [&](const Vec3& x) { return Vec3(x + place(translated->by)); });
    }
  }
  return std::nullopt;
}

}  // namespace lapilli
