#include "lapilli/mpm/dynamics/wall_friction.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/mpm/dynamics/friction_lag.hpp"

namespace lapilli {

template <int Dim>
WallFriction<Dim>::WallFriction(const DynamicsData<Dim>& data)
    : lags_(static_cast<std::size_t>(data.fields.count()), 0.0) {
  for (std::size_t body = 0; body < data.materials.size(); ++body) {
    double& lag = lags_[static_cast<std::size_t>(data.fields.index_of(static_cast<Index>(body)))];
    lag = std::max(lag, friction_lag(data.materials[body], data.grid.cell_size()));
  }
}

template <int Dim>
void WallFriction<Dim>::begin_step(double step) {
  known_.swap(nodes_);
  past_.swap(felt_);
  nodes_.clear();
  felt_.clear();
  next_ = 0;
  step_ = step;
}

template <int Dim>
double WallFriction<Dim>::bear(const DynamicsData<Dim>& data, int field, int face, int layer,
                               Index number, double push) {
  const NodeField<Dim>& window = data.fields[field];
  auto at = window.grid.node_at(number - window.offset);
  for (int axis = 0; axis < Dim; ++axis) {
    at[axis] += window.corner[axis];
  }
  // Windows move; the number in the whole grid stays.
  const Index place = (field * 2 * Dim + face) * 2 + layer;
  const Index node = place * data.grid.node_count() + data.grid.node_index(at);
  while (next_ < known_.size() && known_[next_] < node) {
    ++next_;
  }
  double felt = push / step_;
  if (next_ < known_.size() && known_[next_] == node) {
    const double share = -std::expm1(-step_ / lags_[static_cast<std::size_t>(field)]);
    felt = past_[next_] + share * (felt - past_[next_]);
  }
  nodes_.push_back(node);
  felt_.push_back(felt);
  const Wall& wall = data.walls[static_cast<std::size_t>(face)];
  return wall.friction * felt * step_;
}

template <int Dim>
void WallFriction<Dim>::save(Archive& archive, const std::string& name) const {
  archive.write(name + "/nodes", std::span<const Index>(nodes_));
  archive.write(name + "/felt", std::span<const double>(felt_));
}

template <int Dim>
void WallFriction<Dim>::load(const Archive& archive, const std::string& name) {
  nodes_.clear();
  felt_.clear();
  if (archive.contains(name + "/nodes")) {
    nodes_ = archive.read_indices(name + "/nodes");
    felt_.resize(nodes_.size());
    archive.read(name + "/felt", std::span<double>(felt_));
  }
}

template <int Dim>
std::unique_ptr<WallFriction<Dim>> make_wall_friction(const DynamicsData<Dim>& data) {
  const bool any = std::ranges::any_of(
      data.walls, [](const Wall& wall) { return wall.kind == Wall::Kind::frictional; });
  return any ? std::make_unique<WallFriction<Dim>>(data) : nullptr;
}

template class WallFriction<2>;
template class WallFriction<3>;
template std::unique_ptr<WallFriction<2>> make_wall_friction(const DynamicsData<2>&);
template std::unique_ptr<WallFriction<3>> make_wall_friction(const DynamicsData<3>&);

}  // namespace lapilli
