#include "lapilli/mpm/surface/wall_contact.hpp"

#include <algorithm>

namespace lapilli {

template <int Dim>
bool WallContact<Dim>::any() const {
  return std::ranges::any_of(faces_, [](bool wall) { return wall; });
}

template <int Dim>
template <class Body>
void WallContact<Dim>::for_each_wall(const Body& body) const {
  for (int axis = 0; axis < Dim; ++axis) {
    for (int side = 0; side < 2; ++side) {
      if (faces_[static_cast<std::size_t>(2 * axis + side)]) {
        constexpr int padding = Grid<Dim>::padding;
        body(axis, side == 0 ? padding : grid_.nodes(axis) - 1 - padding, side == 0 ? 1 : -1);
      }
    }
  }
}

template <int Dim>
std::vector<unsigned char> WallContact<Dim>::without_walls(
    std::span<const unsigned char> outside) const {
  std::vector<unsigned char> flags(outside.begin(), outside.end());
  for_each_wall([&](int axis, int face, int inward) {
    for (Index cell = 0; cell < grid_.cell_count(); ++cell) {
      const int at = grid_.cell_at(cell)[axis];
      if (inward > 0 ? at < face : at >= face) {
        flags[cell] = 0;
      }
    }
  });
  return flags;
}

template <int Dim>
NodalSums<Dim> WallContact<Dim>::mirrored(const NodalSums<Dim>& sums) const {
  NodalSums<Dim> both = sums;
  for_each_wall([&](int axis, int face, int inward) {
    const Index stride = inward * grid_.node_stride(axis);
    for (Index node = 0; node < grid_.node_count(); ++node) {
      if (grid_.node_at(node)[axis] != face) {
        continue;
      }
      both.fraction[node] *= 2.0;
      both.area_vector[node] *= 2.0;
      both.area_vector[node][axis] = 0.0;
      for (int k = 1; k <= Grid<Dim>::padding; ++k) {
        const Index inner = node + k * stride, outer = node - k * stride;
        const double fraction = both.fraction[inner] + both.fraction[outer];
        both.fraction[inner] = both.fraction[outer] = fraction;
        Vec<Dim> image = both.area_vector[outer];
        image[axis] = -image[axis];
        both.area_vector[inner] += image;
        both.area_vector[outer] = both.area_vector[inner];
        both.area_vector[outer][axis] = -both.area_vector[inner][axis];
      }
    }
  });
  return both;
}

template <int Dim>
NodalSums<Dim> WallContact<Dim>::without_contact(const NodalSums<Dim>& sums) const {
  NodalSums<Dim> free{mirrored(sums).fraction, sums.area_vector};
  for_each_wall([&](int axis, int face, int inward) {
    for (Index node = 0; node < grid_.node_count(); ++node) {
      if (inward * (grid_.node_at(node)[axis] - face) <= 0) {
        double& across = free.area_vector[node][axis];
        across = inward * across < 0.0 ? 0.0 : across;
      }
    }
  });
  return free;
}

template <int Dim>
double WallContact<Dim>::uncovered(Index node, int axis, int inward, const NodalSums<Dim>& sums,
                                   std::span<const unsigned char> outside) const {
  const auto at = grid_.node_at(node);
  double covered = 0.0;
  for (int corner = 0; corner < (1 << Dim); ++corner) {
    auto cell = at;
    for (int other = 0; other < Dim; ++other) {
      cell[other] -= (corner >> other) & 1;
    }
    const bool before_wall = inward > 0 ? cell[axis] == at[axis] : cell[axis] == at[axis] - 1;
    if (before_wall && outside[grid_.cell_index(cell)] == 0) {
      covered += std::pow(grid_.cell_size(), Dim - 1) / (1 << (Dim - 1));
    }
  }
  const Index stride = inward * grid_.node_stride(axis);
  double across = 0.0;  // of the nodes on and behind the wall
  for (int k = 0; k <= 1; ++k) {
    across += inward * sums.area_vector[node - k * stride][axis];
  }
  return std::max(0.0, covered + across);
}

template <int Dim>
void WallContact<Dim>::take_off(NodalAreas<Dim>& areas, const NodalSums<Dim>& sums,
                                std::span<const unsigned char> outside) const {
  NodalAreas<Dim> kept;
  for (std::size_t k = 0; k < areas.node.size(); ++k) {
    const Index node = areas.node[k];
    const auto at = grid_.node_at(node);
    double area = areas.area[k], free = 0.0;
    Vec<Dim> normal = areas.normal[k];
    bool behind = false;
    for_each_wall([&](int axis, int face, int inward) {
      behind = behind || inward * (at[axis] - face) < 0;
      if (at[axis] == face) {
        area *= 0.5;
        free += uncovered(node, axis, inward, sums, outside);
        normal[axis] += inward * free;
      }
    });
    if (!behind) {
      kept.append(areas, k);
      kept.area.back() = area + free;
      kept.normal.back() = normal.norm() > 0.0 ? Vec<Dim>(normal.normalized()) : normal;
    }
  }
  kept.positive = non_negative_areas<Dim>(grid_, kept.node, kept.area);
  areas = std::move(kept);
}

template class WallContact<1>;
template class WallContact<2>;
template class WallContact<3>;

}  // namespace lapilli
