#include <algorithm>
#include <cmath>
#include <optional>

#include "lapilli/geometry/node_block.hpp"
#include "lapilli/mpm/surface/corner_fit.hpp"
#include "lapilli/mpm/surface/nodal_surface.hpp"

namespace lapilli {
namespace {

/// The node moved along its normal to where the smoothed fraction is one half, at most 1.5 cells.
template <int Dim>
Vec3 projected(const Grid<Dim>& grid, Index node, const Vec<Dim>& normal, double fraction,
               double slope) {
  Vec3 position = Vec3::Zero();
  double reach = 0.0;
  if (slope > 0.0) {
    reach = std::clamp((fraction - 0.5) / slope, -1.5, 1.5) * grid.cell_size();
  }
  position.template head<Dim>() = grid.node_position(node) + reach * normal;
  return position;
}

}  // namespace

template <int Dim>
void smooth_nodes(const Grid<Dim>& grid, std::vector<double>& values,
                  std::vector<double>& scratch) {
  scratch.resize(values.size());
  for (int axis = 0; axis < Dim; ++axis) {
    const Index stride = grid.node_stride(axis), count = grid.node_count();
    std::fill(scratch.begin(), scratch.begin() + stride, 0.0);
    std::fill(scratch.end() - stride, scratch.end(), 0.0);
    const double* from = values.data() + stride;
    double* to = scratch.data() + stride;
    parallel_for(
        count - 2 * stride,
        [=](Index k) { to[k] = 0.5 * from[k] + 0.25 * (from[k - stride] + from[k + stride]); },
        Work::light);
    values.swap(scratch);
  }
}

template <int Dim>
double NodalAreas<Dim>::negative_share() const {
  double negative = 0.0, total = 0.0;
  for (const double a : area) {
    negative -= std::min(a, 0.0);
    total += a;
  }
  return total > 0.0 ? negative / total : 0.0;
}

template <int Dim>
void NodalAreas<Dim>::append(const NodalAreas& other, std::size_t row) {
  const auto copy = [row](auto& to, const auto& from) {
    if (!from.empty()) {
      to.push_back(from[row]);
    }
  };
  copy(node, other.node);
  copy(area, other.area);
  copy(positive, other.positive);
  copy(normal, other.normal);
  copy(position, other.position);
  copy(vector, other.vector);
  copy(weight, other.weight);
  copy(trust, other.trust);
  copy(corner, other.corner);
}

template <int Dim>
std::vector<Index> surface_nodes(const Grid<Dim>& grid, std::span<const unsigned char> outside,
                                 std::span<const double> fraction) {
  const Index count = grid.node_count();
  std::vector<unsigned char> touched(static_cast<std::size_t>(count), 0);
  const auto inner = [&](Index node, int margin) {
    const auto at = grid.node_at(node);
    for (int axis = 0; axis < Dim; ++axis) {
      if (at[axis] < margin || at[axis] >= grid.nodes(axis) - margin) {
        return false;
      }
    }
    return true;
  };
  std::vector<Index> first;
  for (Index node = 0; node < count; ++node) {
    if (fraction[node] <= 0.0 || !inner(node, 2)) {
      continue;
    }
    const auto at = grid.node_at(node);
    bool at_surface = false;
    for (int corner = 0; corner < (1 << Dim); ++corner) {
      auto cell = at;
      for (int axis = 0; axis < Dim; ++axis) {
        cell[axis] -= (corner >> axis) & 1;
      }
      at_surface = at_surface || outside[grid.cell_index(cell)] != 0;
    }
    if (at_surface) {
      first.push_back(node);
    }
  }
  std::vector<Index> all;
  const auto add = [&](Index node) {
    if (fraction[node] > 0.0 && touched[node] == 0) {
      touched[node] = 1;
      all.push_back(node);
    }
  };
  std::vector<Index> offsets{0};
  for (int axis = 0; axis < Dim; ++axis) {
    const std::vector<Index> before = offsets;
    for (const Index offset : before) {
      offsets.push_back(offset - grid.node_stride(axis));
      offsets.push_back(offset + grid.node_stride(axis));
    }
  }
  for (const Index node : first) {
    for (const Index offset : offsets) {
      add(node + offset);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

template <int Dim>
NodalAreas<Dim> nodal_normal_areas(const Grid<Dim>& grid, const NodalSums<Dim>& sums,
                                   std::vector<Index> nodes, int smoothing, bool corner_fit) {
  std::vector<double> fraction = sums.fraction, scratch;
  for (int pass = 0; pass < smoothing; ++pass) {
    smooth_nodes(grid, fraction, scratch);
  }
  const auto gradient = [&](Index node) {  // per cell
    Vec<Dim> slope;
    for (int axis = 0; axis < Dim; ++axis) {
      const Index stride = grid.node_stride(axis);
      slope[axis] = 0.5 * (fraction[node + stride] - fraction[node - stride]);
    }
    return slope;
  };
  NodalAreas<Dim> areas;
  areas.node = std::move(nodes);
  const auto count = static_cast<Index>(areas.node.size());
  areas.area.resize(areas.node.size());
  areas.normal.resize(areas.node.size());
  areas.position.resize(areas.node.size());
  areas.vector.resize(areas.node.size());
  for (Index k = 0; k < count; ++k) {
    const Index node = areas.node[k];
    const Vec<Dim> slope = gradient(node);
    const double steepness = slope.norm();
    // A gradient of rounding size, as in the middle of a thin plate, has no direction.
    areas.normal[k] = steepness > 1e-12 ? Vec<Dim>(-slope / steepness) : Vec<Dim>::Zero();
    areas.vector[k] = sums.area_vector[node];
    areas.area[k] = areas.normal[k].dot(areas.vector[k]);
    areas.position[k] = projected(grid, node, areas.normal[k], fraction[node], steepness);
  }
  areas.weight = areas.normal;
  if (corner_fit && Dim > 1) {
    fit_corners(grid, sums, areas);
  }
  areas.positive = non_negative_areas<Dim>(grid, areas.node, areas.area);
  return areas;
}

namespace {

/// Negative areas, made up for by positive ones around them.
template <int Dim>
class Needs {
 public:
  Needs(const Grid<Dim>& grid, std::span<const Index> nodes, std::span<const double> area)
      : grid_(grid),
        nodes_(nodes),
        positive_(area.begin(), area.end()),
        missing_(area.size(), 0.0) {
    for (std::size_t k = 0; k < positive_.size(); ++k) {
      if (positive_[k] < 0.0) {
        needy_.push_back(k);
        missing_[k] = -positive_[k];
        positive_[k] = 0.0;
      }
    }
  }

  bool empty() const { return needy_.empty(); }
  std::vector<double> areas() && { return std::move(positive_); }

  /// Take from the nodes within some cells, or from all. All ask at once, so that the order of the
  /// nodes does not matter: each asks the others in proportion to their area, and who is asked for
  /// more than it has gives its all.
  void take_from(std::optional<int> reach) {
    std::vector<std::vector<Index>> givers;
    std::vector<double> available(needy_.size(), 0.0), asked(positive_.size(), 0.0);
    for (std::size_t n = 0; n < needy_.size(); ++n) {
      givers.push_back(givers_to(needy_[n], reach));
      for (const Index row : givers[n]) {
        available[n] += positive_[row];
      }
      for (const Index row : givers[n]) {
        asked[row] += missing_[needy_[n]] * positive_[row] / available[n];
      }
    }
    std::vector<double> given(positive_.size(), 0.0);
    std::vector<std::size_t> still;
    for (std::size_t n = 0; n < needy_.size(); ++n) {
      double& wanted = missing_[needy_[n]];
      double got = 0.0;
      for (const Index row : givers[n]) {
        const double share = wanted * positive_[row] / available[n];
        const double gives =
            asked[row] > positive_[row] ? share * positive_[row] / asked[row] : share;
        given[row] += gives;
        got += gives;
      }
      wanted -= got;
      if (wanted > 1e-15 * got) {
        still.push_back(needy_[n]);
      }
    }
    for (std::size_t row = 0; row < positive_.size(); ++row) {
      positive_[row] = std::max(positive_[row] - given[row], 0.0);
    }
    needy_ = std::move(still);
  }

 private:
  std::vector<Index> givers_to(std::size_t needy, std::optional<int> reach) const {
    std::vector<Index> givers;
    const auto offer = [&](Index row) {
      if (row >= 0 && positive_[row] > 0.0) {
        givers.push_back(row);
      }
    };
    if (reach) {
      for_each_in_block(grid_, nodes_[needy], *reach,
                        [&](Index node, const Vec<Dim>&) { offer(row_of(node)); });
    } else {
      for (std::size_t row = 0; row < positive_.size(); ++row) {
        offer(static_cast<Index>(row));
      }
    }
    return givers;
  }

  Index row_of(Index node) const {
    const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), node);
    return found != nodes_.end() && *found == node ? found - nodes_.begin() : -1;
  }

  const Grid<Dim>& grid_;
  std::span<const Index> nodes_;
  std::vector<double> positive_, missing_;
  std::vector<std::size_t> needy_;
};

}  // namespace

template <int Dim>
std::vector<double> non_negative_areas(const Grid<Dim>& grid, std::span<const Index> nodes,
                                       std::span<const double> area) {
  constexpr int farthest = 8;  // cells; what is left then comes from everywhere
  Needs<Dim> needs(grid, nodes, area);
  for (int reach = 1; reach <= farthest && !needs.empty(); ++reach) {
    needs.take_from(reach);
  }
  if (!needs.empty()) {
    needs.take_from(std::nullopt);
  }
  return std::move(needs).areas();
}

template struct NodalAreas<1>;
template struct NodalAreas<2>;
template struct NodalAreas<3>;
#define LAPILLI_INSTANTIATE(Dim)                                                              \
  template void smooth_nodes(const Grid<Dim>&, std::vector<double>&, std::vector<double>&);   \
  template std::vector<Index> surface_nodes(const Grid<Dim>&, std::span<const unsigned char>, \
                                            std::span<const double>);                         \
  template NodalAreas<Dim> nodal_normal_areas(const Grid<Dim>&, const NodalSums<Dim>&,        \
                                              std::vector<Index>, int, bool);                 \
  template std::vector<double> non_negative_areas(const Grid<Dim>&, std::span<const Index>,   \
                                                  std::span<const double>);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
