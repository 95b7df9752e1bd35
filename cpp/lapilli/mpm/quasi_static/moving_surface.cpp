#include "lapilli/mpm/quasi_static/moving_surface.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

/// Corners, counter-clockwise, of a plane shape with straight sides; nothing for other shapes.
std::optional<std::vector<Vec<2>>> outline(const Shape& shape) {
  std::vector<Vec<2>> corners;
  if (const auto* polygon = std::get_if<Polygon>(&shape)) {
    for (const auto& vertex : polygon->vertices) {
      corners.push_back({vertex[0], vertex[1]});
    }
  } else if (const auto* box = std::get_if<Box>(&shape); box && box->lower.size() >= 2) {
    const Vec<2> low(box->lower[0], box->lower[1]), high(box->upper[0], box->upper[1]);
    corners = {low, {high[0], low[1]}, high, {low[0], high[1]}};
  } else if (const auto* turned = std::get_if<Rotated>(&shape)) {
    const auto before = outline(*turned->shape);
    if (!before) {
      return before;
    }
    const Vec3 centre = place(turned->center);
    for (const Vec<2>& corner : *before) {
      const Vec3 at = centre + turned->matrix() * (Vec3(corner[0], corner[1], 0.0) - centre);
      corners.push_back(at.head<2>());
    }
  } else if (const auto* moved = std::get_if<Translated>(&shape)) {
    const auto before = outline(*moved->shape);
    if (!before) {
      return before;
    }
    for (const Vec<2>& corner : *before) {
      corners.push_back(corner + place(moved->by).head<2>());
    }
  } else {
    return std::nullopt;
  }
  double twice_area = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2>&a = corners[k], &b = corners[(k + 1) % corners.size()];
    twice_area += a[0] * b[1] - a[1] * b[0];
  }
  if (twice_area < 0.0) {
    std::reverse(corners.begin(), corners.end());
  }
  return corners;
}

template <int Dim>
Vec3 shifted(const Vec3& place, const Vec<Dim>& by) {
  Vec3 at = place;
  at.head<Dim>() -= by;
  return at;
}

}  // namespace

template <int Dim>
MovingSurface<Dim>::MovingSurface(const SurfaceSettings& settings,
                                  const std::vector<Value>& displacement, std::string what,
                                  const Value& advance)
    : what_(std::move(what)),
      shape_(settings.shape),
      within_(settings.within),
      side_(settings.inside ? -1.0 : 1.0),
      displacement_(displacement),
      advance_(advance) {
  require(shape_.has_value() != !settings.line.empty(), what_,
          " needs either a shape or a line, not both");
  require(settings.line.empty() || Dim == 2, what_, ": a line is a surface in two dimensions only");
  require(settings.line.empty() || settings.line.size() >= 2, what_,
          ": a line needs at least two points, got ", settings.line.size());
  require(displacement_.size() <= Dim, what_, ": displacement has ", displacement_.size(),
          " values, the scene has ", Dim, " axes");
  if (shape_) {
    check(*shape_, Dim);
  }
  if (within_) {
    check(*within_, Dim);
  }
  for (const auto& point : settings.line) {
    require(point.size() == 2, what_, ": a point of a line has 2 coordinates, got ", point.size());
    line_.push_back({point[0], point[1]});
    require(line_.back().allFinite(), what_, ": a point of the line is not finite");
    require(line_.size() < 2 || line_.back() != line_[line_.size() - 2], what_,
            ": two neighbouring points of the line coincide at (", point[0], ", ", point[1], ")");
  }
  for (const Value& value : displacement_) {
    require(!value.is_constant() || value.at(0.0) == 0.0, what_, ": a constant displacement of ",
            value.at(0.0), " m moves nothing; give a table in time, from 0 at the start");
  }
  require(!advance_.is_constant() || advance_.at(0.0) == 0.0, what_, ": a constant advance of ",
          advance_.at(0.0), " m moves nothing; give a table in time, from 0 at the start");
  require(!advance_.is_function(), what_, ": advance is a number or a table in time");
  require(advance_.is_constant() || shape_, what_, ": a line cannot advance, a shape can");
  if (Dim == 2 && shape_ && advance_.is_constant()) {
    if (auto corners = outline(*shape_)) {
      line_ = std::move(*corners);
      if (side_ > 0.0) {
        std::reverse(line_.begin(), line_.end());
      }
      line_.push_back(line_.front());
    }
  }
}

template <int Dim>
Vec<Dim> MovingSurface<Dim>::offset(double time) const {
  Vec<Dim> sum = Vec<Dim>::Zero();
  for (std::size_t axis = 0; axis < displacement_.size(); ++axis) {
    sum[static_cast<int>(axis)] = displacement_[axis].at(time) - displacement_[axis].at(0.0);
  }
  return sum;
}

template <int Dim>
std::vector<Vec<Dim>> MovingSurface<Dim>::increments(const Facet<Dim>& facet, double from,
                                                     double to) const {
  const std::size_t count = facet.points.size();
  std::vector<Vec<Dim>> steps(count, Vec<Dim>::Zero());
  std::vector<Vec3> places(count, Vec3::Zero());
  for (std::size_t q = 0; q < count; ++q) {
    places[q].template head<Dim>() = facet.points[q].position;
  }
  std::vector<double> before(count), after(count);
  for (std::size_t axis = 0; axis < displacement_.size(); ++axis) {
    displacement_[axis].evaluate(places, {}, from, before);
    displacement_[axis].evaluate(places, {}, to, after);
    for (std::size_t q = 0; q < count; ++q) {
      steps[q][static_cast<int>(axis)] = after[q] - before[q];
    }
  }
  for (std::size_t q = 0; q < count; ++q) {
    steps[q] += (advance_.at(to) - advance_.at(from)) * facet.points[q].normal;
  }
  return steps;
}

template <int Dim>
double MovingSurface<Dim>::distance(const Vec3& place, double time) const {
  return side_ * lapilli::distance(*shape_, shifted<Dim>(place, offset(time))) -
         (advance_.at(time) - advance_.at(0.0));
}

template <int Dim>
bool MovingSurface<Dim>::counts(const Vec3& place, double time) const {
  return !within_ || covers(*within_, shifted<Dim>(place, offset(time)));
}

template <int Dim>
std::optional<double> MovingSurface<Dim>::gap(const Vec3& place, double time) const {
  if (!counts(place, time)) {
    return std::nullopt;
  }
  if (is_solid()) {
    return distance(place, time);
  }
  const Vec<2> at = shifted<Dim>(place, offset(time)).template head<2>();
  std::optional<double> nearest;
  for (std::size_t k = 0; k + 1 < line_.size(); ++k) {
    const Vec<2> along = line_[k + 1] - line_[k];
    const double share = (at - line_[k]).dot(along) / along.squaredNorm();
    if (share > 0.0 && share < 1.0) {
      const double side = (at - line_[k]).dot(Vec<2>(-along[1], along[0]).normalized());
      if (!nearest || std::abs(side) < std::abs(*nearest)) {
        nearest = side;
      }
    }
  }
  return nearest;
}

template <int Dim>
LevelSet MovingSurface<Dim>::level_set(double time) const {
  const Vec<Dim> by = offset(time);
  return {[this, time](const Vec3& place) { return distance(place, time); },
          [this, by](const Vec3& place) {
            return Vec3(side_ * lapilli::gradient(*shape_, shifted<Dim>(place, by)));
          }};
}

template <int Dim>
std::vector<Facet<Dim>> MovingSurface<Dim>::cut(const Grid<Dim>& grid, std::span<const char> cells,
                                                int number, double time,
                                                std::span<const MovingSurface* const> solids,
                                                const std::optional<LevelSet>& counts) const {
  std::vector<LevelSet> trims;
  if (within_) {
    const Vec<Dim> by = offset(time);
    trims.push_back({[this, by](const Vec3& place) {
                       return -lapilli::distance(*within_, shifted<Dim>(place, by));
                     },
                     [this, by](const Vec3& place) {
                       return Vec3(-lapilli::gradient(*within_, shifted<Dim>(place, by)));
                     }});
  }
  if (is_solid()) {
    for (const MovingSurface* solid : solids) {
      if (solid != this && solid->is_solid()) {
        trims.push_back(solid->level_set(time));
      }
    }
  }
  if (counts) {
    trims.push_back(*counts);
  }
  if constexpr (Dim == 2) {
    if (!line_.empty()) {
      std::vector<Vec<2>> line = line_;
      for (Vec<2>& point : line) {
        point += offset(time);
      }
      std::vector<Facet<2>> facets = cut_line(grid, line, number, trims);
      std::erase_if(facets, [&](const auto& facet) { return !cells[grid.cell_index(facet.cell)]; });
      return facets;
    }
  }
  return cut_level_set<Dim>(grid, cells, level_set(time), number, trims);
}

template <int Dim>
void MovingSurface<Dim>::require_whole(const std::vector<Facet<Dim>>& facets) const {
  if (is_solid() || within_) {
    return;
  }
  double length = 0.0, found = 0.0;
  for (std::size_t k = 0; k + 1 < line_.size(); ++k) {
    length += (line_[k + 1] - line_[k]).norm();
  }
  for (const Facet<Dim>& facet : facets) {
    found += facet.area();
  }
  if (std::abs(found - length) > 1e-9 * length) {
    throw RunError(
        message(what_, ": ", length - found, " of its ", length,
                " m lie outside of the grid: enlarge the grid, or end the line where the "
                "body ends"));
  }
}

template class MovingSurface<2>;
template class MovingSurface<3>;

}  // namespace lapilli
