#include "lapilli/mpm/heat/nodal_range.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/parallel.hpp"

namespace lapilli {
namespace {

constexpr int farthest = 8;          // cells that heat is handed on
constexpr double tolerance = 1e-13;  // of the largest temperature: rounding

/// The least and largest of several ranges, as a sum.
struct Extent : TemperatureRange {
  Extent() {
    low = std::numeric_limits<double>::infinity();
    high = -low;
  }
  Extent& operator+=(const Extent& other) {
    low = std::min(low, other.low);
    high = std::max(high, other.high);
    return *this;
  }
};

double slack(const TemperatureRange& range) {
  return tolerance * std::max(std::abs(range.low), std::abs(range.high));
}

}  // namespace

template <int Dim>
NodalRange<Dim>::NodalRange(const HeatProblem<Dim>& problem, const HeatPart<Dim>& part)
    : grid_(problem.grid), inside_(static_cast<std::size_t>(problem.grid.node_count()), 0) {
  const auto is_inside = [&](Index node) {
    Vec3 at = Vec3::Zero();
    at.template head<Dim>() = grid_->node_position(node);
    return std::any_of(part.bodies.begin(), part.bodies.end(), [&](std::size_t body) {
      return distance(*problem.bodies[body].shape, at) <= 0.0;
    });
  };
  for (const auto& row : part.rows->rows()) {
    bool goes_on = false;
    for (int i = row.begin; i < row.end; ++i) {
      const Index place = row.shift + i, node = row.grid_row * grid_->nodes(0) + i;
      const bool shared = part.conduction->kind(place) >= 0;
      const bool inside = shared || (part.capacity[place] > 0.0 && is_inside(node));
      inside_[node] = inside ? 1 : 0;
      if (inside && goes_on) {
        ++runs_.back().count;
      } else if (inside) {
        runs_.push_back({place, 1, node});
      }
      goes_on = inside;
    }
  }
}

template <int Dim>
TemperatureRange NodalRange<Dim>::extent(std::span<const double> temperature) const {
  return parallel_sum(static_cast<Index>(runs_.size()), Extent(), [&](Index k) {
    Extent own;
    const double* values = temperature.data() + runs_[k].place;
    for (Index i = 0; i < runs_[k].count; ++i) {
      own.low = std::min(own.low, values[i]);
      own.high = std::max(own.high, values[i]);
    }
    return own;
  });
}

template <int Dim>
void NodalRange<Dim>::include(std::span<const double> temperature, TemperatureRange& range) const {
  const TemperatureRange now = extent(temperature);
  range.low = std::min(range.low, now.low);
  range.high = std::max(range.high, now.high);
}

template <int Dim>
double NodalRange<Dim>::stray(std::span<const double> temperature,
                              const TemperatureRange& range) const {
  const TemperatureRange now = extent(temperature);
  return std::max({0.0, range.low - now.low, now.high - range.high});
}

template <int Dim>
bool NodalRange<Dim>::restore(const HeatPart<Dim>& part, const TemperatureRange& range,
                              std::span<double> temperature) const {
  const std::vector<double>& capacity = part.capacity;
  return restore(
      part, range, temperature,
      {[&](Index place, double wanted) { return capacity[place] * (wanted - temperature[place]); },
       [&](Index place, double heat) { temperature[place] += heat / capacity[place]; }});
}

template <int Dim>
bool NodalRange<Dim>::restore(const HeatPart<Dim>& part, const TemperatureRange& range,
                              std::span<const double> temperature, const NodalStore& store) const {
  if (!std::isfinite(range.low) || !(stray(temperature, range) > slack(range))) {
    return false;
  }
  const TemperatureRange held{range.low - slack(range), range.high + slack(range)};
  for (const Run& run : runs_) {
    for (Index i = 0; i < run.count; ++i) {
      if (const double value = temperature[run.place + i]; !held.holds(value)) {
        restore_node(part, run.node + i, value > range.high ? range.high : range.low, store);
      }
    }
  }
  return true;
}

template <int Dim>
void NodalRange<Dim>::restore_node(const HeatPart<Dim>& part, Index node, double bound,
                                   const NodalStore& store) const {
  const Index own = part.rows->place(node);
  double left = -store.needed(own, bound);
  std::vector<std::pair<Index, double>> around;  // places and what each takes, J
  for (int reach = 1; reach <= farthest && left != 0.0; ++reach) {
    // Those that can take some up, on the side of the bound where the range lies.
    around.clear();
    double room = 0.0;
    const auto at = grid_->node_at(node);
    const int width = 2 * reach + 1;
    int block = 1;
    for (int axis = 0; axis < Dim; ++axis) {
      block *= width;
    }
    for (int b = 0; b < block; ++b) {
      auto other = at;
      bool in_grid = true;
      for (int axis = 0, rest = b; axis < Dim; ++axis, rest /= width) {
        other[axis] += rest % width - reach;
        in_grid = in_grid && other[axis] >= 0 && other[axis] < grid_->nodes(axis);
      }
      const Index beside = in_grid ? grid_->node_index(other) : node;
      if (beside == node || inside_[beside] == 0) {
        continue;
      }
      const Index place = part.rows->place(beside);
      const double takes = store.needed(place, bound);
      if (takes * left > 0.0) {
        around.emplace_back(place, takes);
        room += takes;
      }
    }
    const double share = around.empty() ? 0.0 : std::min(1.0, left / room);
    for (const auto& [place, takes] : around) {
      store.give(place, share * takes);
    }
    left = share < 1.0 && !around.empty() ? 0.0 : left - share * room;
  }
  store.give(own, store.needed(own, bound) + left);
}

template class NodalRange<1>;
template class NodalRange<2>;
template class NodalRange<3>;

}  // namespace lapilli
