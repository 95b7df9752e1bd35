#include "lapilli/mpm/heat/obstacle_exchange.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

std::string key_of(const HeatObstacle& obstacle) {
  return message("heat/obstacles/", obstacle.number);
}

}  // namespace

template <int Dim>
ObstacleExchange<Dim>::ObstacleExchange(const std::vector<HeatObstacle>& obstacles)
    : obstacles_(obstacles),
      surfaces_(obstacles.size()),
      rate_(obstacles.size(), 0.0),
      account_(obstacles.size()) {
  for (const HeatObstacle& obstacle : obstacles_) {
    temperature_.push_back(obstacle.temperature ? obstacle.temperature->at(0.0) : 0.0);
  }
}

template <int Dim>
void ObstacleExchange<Dim>::find(const HeatProblem<Dim>& problem, const Points& points,
                                 const HeatCoefficients<Dim>& coefficients,
                                 const PointGridTransfer<Dim>& nodal) {
  for (std::size_t k = 0; k < feet_.size(); ++k) {
    surfaces_[k] = touching_surface(problem.grid, problem.shape, points, feet_[k](), coefficients,
                                    nodal.sums.area_vector, nodal.capacity);
  }
  cell_ = problem.grid.cell_size();
}

/// W/(m^2 K), infinite where the contact is perfect.
template <int Dim>
double ObstacleExchange<Dim>::conductance_of(std::size_t k, const Step& step) const {
  const auto& given = obstacles_[k].conductance;
  return given ? given->mean(step.time, step.time + step.size)
               : std::numeric_limits<double>::infinity();
}

/// By node, J/K: the heat that a step gives it for every kelvin between it, after all else, and the
/// obstacle; taken at the end of the step.
template <int Dim>
std::vector<double> ObstacleExchange<Dim>::exchanged(std::size_t k, const Step& step,
                                                     const PointGridTransfer<Dim>& nodal) const {
  const TouchingSurface<Dim>& surface = surfaces_[k];
  const double conductance = conductance_of(k, step);
  std::vector<double> all(surface.nodes.size(), 0.0);
  for (const TouchingPiece& piece : surface.pieces) {
    const double inner = piece.coefficient(conductance, true);
    const double outer = piece.coefficient(conductance, false);
    for (std::size_t link = piece.first_link; link < piece.links_end; ++link) {
      const NodeLink& one = surface.links[link];
      all[one.slot] += one.area * (one.is_inner ? inner : outer);
    }
  }
  for (std::size_t n = 0; n < all.size(); ++n) {
    const double capacity = nodal.capacity[surface.nodes[n].node];
    all[n] = all[n] > 0.0 ? capacity / (1.0 + capacity / (step.size * all[n])) : 0.0;
  }
  return all;
}

/// How fast the surface follows; the obstacle too, where heat warms it.
template <int Dim>
double ObstacleExchange<Dim>::rate_of(std::size_t k, const Step& step,
                                      const PointGridTransfer<Dim>& nodal) const {
  const double conductance = conductance_of(k, step);
  double passes = 0.0, capacity = 0.0;
  for (const TouchingPiece& piece : surfaces_[k].pieces) {
    passes +=
        conductance > 0.0 ? piece.area / (1.0 / conductance + cell_ / piece.conductivity) : 0.0;
  }
  for (const TouchingNode<Dim>& node : surfaces_[k].nodes) {
    capacity += nodal.capacity[node.node];
  }
  capacity = std::min(capacity, obstacles_[k].heat_capacity.value_or(capacity));
  return capacity > 0.0 ? passes / capacity : 0.0;
}

template <int Dim>
void ObstacleExchange<Dim>::exchange(const Step& step, PointGridTransfer<Dim>& nodal) {
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    const HeatObstacle& obstacle = obstacles_[k];
    if (!obstacle.temperature) {
      continue;
    }
    for (const OuterNode& outer : surfaces_[k].outer) {
      nodal.hand_on(outer.node, outer.heir);
    }
    const std::vector<TouchingNode<Dim>>& nodes = surfaces_[k].nodes;
    const std::vector<double> weight = exchanged(k, step, nodal);
    const auto after = [&](Index node) { return nodal.temperature[node] + nodal.increment[node]; };
    double target = obstacle.temperature->mean(step.time, step.time + step.size);
    if (obstacle.heat_capacity) {  // the one at the end of the step, a mean of all
      double sum = *obstacle.heat_capacity * temperature_[k], whole = *obstacle.heat_capacity;
      for (std::size_t n = 0; n < nodes.size(); ++n) {
        sum += weight[n] * after(nodes[n].node);
        whole += weight[n];
      }
      target = sum / whole;
      temperature_[k] = target;
    }
    double heat = 0.0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (weight[n] > 0.0) {
        const double given = weight[n] * (target - after(nodes[n].node));
        nodal.increment[nodes[n].node] += given / nodal.capacity[nodes[n].node];
        heat += given;
      }
    }
    account_.book(k, heat);
    rate_[k] = rate_of(k, step, nodal);
  }
}

template <int Dim>
double ObstacleExchange<Dim>::rate() const {
  return rate_.empty() ? 0.0 : std::ranges::max(rate_);
}

template <int Dim>
std::vector<Balance::Entry> ObstacleExchange<Dim>::entries() const {
  std::vector<Balance::Entry> all;
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    if (obstacles_[k].temperature) {
      all.push_back({obstacles_[k].name, account_.heat(k)});
    }
  }
  return all;
}

template <int Dim>
std::vector<std::pair<std::string, double>> ObstacleExchange<Dim>::diagnostics() const {
  std::vector<std::pair<std::string, double>> all;
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    if (!obstacles_[k].temperature) {
      continue;
    }
    all.emplace_back(message("area on ", obstacles_[k].name), surfaces_[k].area());
    if (obstacles_[k].heat_capacity) {
      all.emplace_back(message("temperature of ", obstacles_[k].name), temperature_[k]);
    }
  }
  return all;
}

template <int Dim>
void ObstacleExchange<Dim>::save(Archive& archive) const {
  if (obstacles_.empty()) {
    return;
  }
  account_.save(archive, "heat/obstacles/account");
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    archive.write(key_of(obstacles_[k]), std::array{temperature_[k], rate_[k]});
  }
}

template <int Dim>
void ObstacleExchange<Dim>::load(const Archive& archive) {
  if (obstacles_.empty()) {
    return;
  }
  account_.load(archive, "heat/obstacles/account");
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    std::array<double, 2> numbers{};
    archive.read(key_of(obstacles_[k]), std::span<double>(numbers));
    temperature_[k] = numbers[0];
    rate_[k] = numbers[1];
  }
}

template <int Dim>
void ObstacleExchange<Dim>::go_on(const PointStart& start) {
  for (std::size_t k = 0; k < obstacles_.size() && !start.obstacle.empty(); ++k) {
    HeatObstacle before = obstacles_[k];
    before.number = start.obstacle[static_cast<std::size_t>(before.number)];
    if (before.number >= 0 && start.state->contains(key_of(before))) {
      temperature_[k] = start.state->read_numbers(key_of(before)).front();
    }
  }
}

template class ObstacleExchange<1>;
template class ObstacleExchange<2>;
template class ObstacleExchange<3>;

}  // namespace lapilli
