#include "lapilli/geometry/flat.hpp"

#include <algorithm>
#include <cmath>

namespace lapilli {
namespace {

using Terms = std::vector<FlatTerm>;
using MaybeTerms = std::optional<Terms>;

constexpr std::size_t most_terms = 512;

FlatTerm term_of(const Box& box) {
  FlatTerm term;
  for (std::size_t axis = 0; axis < box.lower.size(); ++axis) {
    const Vec3 along = Vec3::Unit(static_cast<int>(axis));
    if (std::isfinite(box.lower[axis])) {
      term.cuts.push_back({-along, -box.lower[axis]});
    }
    if (std::isfinite(box.upper[axis])) {
      term.cuts.push_back({along, box.upper[axis]});
    }
  }
  return term;
}

Cut<3> cut_along(const Vec<2>& from, const Vec<2>& to) {
  const Vec<2> along = (to - from).normalized();
  return cut_through<3>({from[0], from[1], 0.0}, {along[1], -along[0], 0.0});
}

// The triangles of a fan, clockwise ones taken away: together they cover a polygon once.
Terms fan_of(const Polygon& polygon) {
  Terms all;
  const auto corner = [&](std::size_t k) { return Vec<2>(place(polygon.vertices[k]).head<2>()); };
  double area = 0.0;
  for (std::size_t k = 1; k + 1 < polygon.vertices.size(); ++k) {
    const Vec<2> a = corner(0), b = corner(k), c = corner(k + 1);
    const double twice = (b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0];
    area += twice;
    if (twice != 0.0) {
      const Vec<2>&second = twice > 0.0 ? b : c, &third = twice > 0.0 ? c : b;
      all.push_back({twice > 0.0 ? 1.0 : -1.0,
                     {cut_along(a, second), cut_along(second, third), cut_along(third, a)}});
    }
  }
  for (FlatTerm& term : all) {
    term.sign *= area > 0.0 ? 1.0 : -1.0;
  }
  return all;
}

// The indicator function of a common part is the product of the indicators.
MaybeTerms product(const Terms& one, const Terms& other) {
  if (one.size() * other.size() > most_terms) {
    return std::nullopt;
  }
  Terms all;
  for (const FlatTerm& a : one) {
    for (const FlatTerm& b : other) {
      all.push_back({a.sign * b.sign, a.cuts});
      all.back().cuts.insert(all.back().cuts.end(), b.cuts.begin(), b.cuts.end());
    }
  }
  return all;
}

MaybeTerms sum(Terms one, const Terms& other, double sign) {
  for (const FlatTerm& term : other) {
    one.push_back({sign * term.sign, term.cuts});
  }
  return one.size() > most_terms ? std::nullopt : MaybeTerms(std::move(one));
}

// a - a b
MaybeTerms difference(const MaybeTerms& one, const MaybeTerms& other) {
  const MaybeTerms common = one && other ? product(*one, *other) : std::nullopt;
  return common ? sum(*one, *common, -1.0) : std::nullopt;
}

MaybeTerms terms_of_any(const std::vector<Shape>& shapes) {
  MaybeTerms all = terms_of(shapes.front());
  for (std::size_t k = 1; k < shapes.size() && all; ++k) {
    // a + b - a b
    const MaybeTerms next = terms_of(shapes[k]);
    const MaybeTerms rest = difference(next, all);
    all = rest ? sum(*all, *rest, 1.0) : std::nullopt;
  }
  return all;
}

MaybeTerms terms_of_all(const std::vector<Shape>& shapes) {
  MaybeTerms all = terms_of(shapes.front());
  for (std::size_t k = 1; k < shapes.size() && all; ++k) {
    const MaybeTerms next = terms_of(shapes[k]);
    all = next ? product(*all, *next) : std::nullopt;
  }
  return all;
}

// Where a place goes when a shape is turned.
Vec3 turned(const Rotated& rotated, const Vec3& x) {
  return place(rotated.center) + rotated.matrix() * (x - place(rotated.center));
}

// The terms after a motion of the shape; `move` takes places, `turn` directions.
template <class Move>
Terms moved(Terms inner, const Mat3& turn, const Move& move) {
  for (FlatTerm& term : inner) {
    for (Cut<3>& cut : term.cuts) {
      cut = cut_through<3>(move(cut.offset * cut.normal), turn * cut.normal);
    }
  }
  return inner;
}

template <class Move>
Outline moved(const Outline& inner, const Move& move) {
  Outline all;
  for (const Vec<2>& corner : inner) {
    all.push_back(move(Vec3(corner[0], corner[1], 0.0)).template head<2>());
  }
  return all;
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
  } else if (const auto* ground = std::get_if<HeightField>(&shape)) {
    return ground->profile ? outline_of(*ground->profile) : std::nullopt;
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

std::optional<std::vector<FlatTerm>> terms_of(const Shape& shape) {
  if (const auto* box = std::get_if<Box>(&shape)) {
    return Terms{term_of(*box)};
  }
  if (const auto* side = std::get_if<HalfSpace>(&shape)) {
    return Terms{{1.0, {cut_through<3>(place(side->point), place(side->normal).normalized())}}};
  }
  if (const auto* polygon = std::get_if<Polygon>(&shape)) {
    return fan_of(*polygon);
  }
  if (const auto* ground = std::get_if<HeightField>(&shape)) {
    return ground->profile ? MaybeTerms(fan_of(*ground->profile)) : std::nullopt;
  }
  if (const auto* joined = std::get_if<Union>(&shape)) {
    return terms_of_any(joined->shapes);
  }
  if (const auto* common = std::get_if<Intersection>(&shape)) {
    return terms_of_all(common->shapes);
  }
  if (const auto* cut = std::get_if<Difference>(&shape)) {
    return difference(terms_of(*cut->shape), terms_of(*cut->minus));
  }
  if (const auto* rotated = std::get_if<Rotated>(&shape)) {
    if (auto inner = terms_of(*rotated->shape)) {
      return moved(*std::move(inner), rotated->matrix(),
                   [&](const Vec3& x) { return turned(*rotated, x); });
    }
  } else if (const auto* translated = std::get_if<Translated>(&shape)) {
    if (auto inner = terms_of(*translated->shape)) {
      return moved(*std::move(inner), Mat3::Identity(),
                   [&](const Vec3& x) { return Vec3(x + place(translated->by)); });
    }
  }
  return std::nullopt;
}

}  // namespace lapilli
