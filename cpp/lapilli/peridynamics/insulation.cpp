#include "lapilli/peridynamics/insulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lapilli {
namespace {

// Walls whose normals are closer than 60 degrees are one (curved) wall.
constexpr double same_wall = 0.5;

}  // namespace

template <int Dim>
Insulation<Dim>::Insulation(const Points& points, const WallSurface& walls,
                            const Families& families)
    : points_(points),
      walls_(walls),
      families_(families),
      planes_(static_cast<std::size_t>(points.size())),
      count_(static_cast<std::size_t>(points.size()), 0) {}

template <int Dim>
bool Insulation<Dim>::adiabatic(Index point) const {
  const int wall = walls_.wall(point);
  return wall >= 0 && walls_.walls()[wall].settings.heat == WallHeat::adiabatic;
}

template <int Dim>
void Insulation<Dim>::find(Index point) {
  auto& count = count_[static_cast<std::size_t>(point)];
  auto& planes = planes_[static_cast<std::size_t>(point)];
  const double* position = points_.position().data() + point * Dim;
  count = 0;
  if (families_.wall_begin(point) == families_.end(point)) {
    return;
  }
  // The nearest plane first, then the nearest of those that stand across all found before.
  for (; count < Dim; ++count) {
    std::optional<Plane> nearest;
    for (Index bond = families_.wall_begin(point); bond < families_.end(point); ++bond) {
      const Index j = families_.neighbour(bond);
      if (!adiabatic(j)) {
        continue;
      }
      const double ahead = std::max(0.0, walls_.template distance<Dim>(position, j));
      const Eigen::Map<const Vec<Dim>> normal(walls_.normal(j));
      const bool known = std::any_of(planes.begin(), planes.begin() + count, [&](const Plane& one) {
        return one.normal.dot(normal) > same_wall;
      });
      if (!known && (!nearest || ahead < nearest->distance) &&
          insulated_at_foot(point, ahead, normal)) {
        nearest = Plane{ahead, normal};
      }
    }
    if (!nearest) {
      break;
    }
    planes[static_cast<std::size_t>(count)] = *nearest;
  }
}

template <int Dim>
bool Insulation<Dim>::insulated_at_foot(Index point, double ahead, const Vec<Dim>& normal) const {
  const Vec<Dim> foot = points_.position<Dim>(point) - ahead * normal;
  double least = std::numeric_limits<double>::infinity();
  bool insulated = true;
  for (Index bond = families_.wall_begin(point); bond < families_.end(point); ++bond) {
    const Index j = families_.neighbour(bond);
    const Eigen::Map<const Vec<Dim>> other(walls_.normal(j));
    const double squared = (points_.position<Dim>(j) - foot).squaredNorm();
    if (squared < least && other.dot(normal) > same_wall) {
      least = squared;
      insulated = adiabatic(j);
    }
  }
  return insulated;
}

template <int Dim>
int Insulation<Dim>::same_plane(Index point, const Plane& plane) const {
  const auto& planes = planes_[static_cast<std::size_t>(point)];
  for (int p = 0; p < count_[static_cast<std::size_t>(point)]; ++p) {
    if (planes[p].normal.dot(plane.normal) > same_wall) {
      return p;
    }
  }
  return -1;
}

template <int Dim>
bool Insulation<Dim>::hides(Index point, Index other) const {
  const auto& planes = planes_[static_cast<std::size_t>(point)];
  const Vec<Dim> to = points_.position<Dim>(other) - points_.position<Dim>(point);
  for (int p = 0; p < count_[static_cast<std::size_t>(point)]; ++p) {
    if (planes[p].distance + to.dot(planes[p].normal) < -0.25 * walls_.spacing()) {
      return true;
    }
  }
  return false;
}

template <int Dim>
void Insulation<Dim>::images(Index point, double horizon, std::vector<Image>& found) const {
  const auto& planes = planes_[static_cast<std::size_t>(point)];
  const int count = count_[static_cast<std::size_t>(point)];
  std::array<double, Dim> own{}, other{};
  for (int p = 0; p < count; ++p) {
    own[p] = planes[p].distance;
  }
  add_images(point, -1, Vec<Dim>::Zero(), planes, own, horizon, found);
  for (Index bond = families_.begin(point); bond < families_.end(point); ++bond) {
    const Index j = families_.neighbour(bond);
    if (j == point || adiabatic(j) || (walls_.wall(j) >= 0 && hides(point, j))) {
      continue;
    }
    const Vec<Dim> to = points_.position<Dim>(j) - points_.position<Dim>(point);
    other.fill(-1.0);
    for (int p = 0; p < count; ++p) {
      if (walls_.wall(j) >= 0) {
        other[p] = planes[p].distance + to.dot(planes[p].normal);
        continue;
      }
      // The same wall as j sees it. Both ends must name the other's plane, so that both find the
      // same images.
      const int q = same_plane(j, planes[p]);
      if (q >= 0 && same_plane(point, planes_[static_cast<std::size_t>(j)][q]) == p) {
        other[p] = planes_[static_cast<std::size_t>(j)][q].distance;
      }
    }
    add_images(point, bond, to, planes, other, horizon, found);
  }
}

template <int Dim>
void Insulation<Dim>::add_images(Index point, Index bond, const Vec<Dim>& to, const Planes& planes,
                                 const std::array<double, Dim>& distance, double horizon,
                                 std::vector<Image>& found) const {
  const int sets = 1 << count_[static_cast<std::size_t>(point)];
  for (int set = 1; set < sets; ++set) {
    Image image{bond, to.squaredNorm(), to};
    bool seen = true;
    for (int p = 0; p < Dim; ++p) {
      if ((set >> p & 1) != 0) {
        seen = seen && distance[p] >= 0.0;
        image.squared += 4.0 * planes[p].distance * distance[p];
        image.to -= 2.0 * distance[p] * planes[p].normal;
      }
    }
    if (seen && image.squared < horizon * horizon) {
      found.push_back(image);
    }
  }
}

template class Insulation<1>;
template class Insulation<2>;
template class Insulation<3>;

}  // namespace lapilli
