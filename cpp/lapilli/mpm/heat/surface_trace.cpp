#include "lapilli/mpm/heat/surface_trace.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/weights.hpp"

namespace lapilli {

template <int Dim>
std::vector<std::pair<Index, double>> surface_trace(const Grid<Dim>& grid, ShapeFunction shape,
                                                    double half_width, const Vec<Dim>& place,
                                                    std::span<const double> fraction, Index own) {
  constexpr double tiny = 0.01;    // of a cell
  constexpr double largest = 3.0;  // weight
  using Row = Eigen::Matrix<double, Dim + 1, 1>;
  if (fraction[own] < tiny) {
    return {{own, 1.0}};
  }
  std::vector<std::pair<Index, double>> trace;
  double kept = 0.0;
  with_shape(shape, half_width, [&](auto function) {
    const Weights<Dim, decltype(function)> weights(grid, function, place.data());
    weights.for_each_node(grid, [&](Index node, double s, const Vec<Dim>&) {
      if (s > 0.0 && fraction[node] >= tiny) {
        trace.emplace_back(node, s);
        kept += s;
      }
    });
  });
  if (kept > 1.0 - 1e-12) {
    return trace;
  }
  const auto row_of = [&](Index node) {
    Row row;
    row[0] = 1.0;
    row.template tail<Dim>() = (grid.node_position(node) - place) / grid.cell_size();
    return row;
  };
  Eigen::Matrix<double, Dim + 1, Dim + 1> moments;
  moments.setZero();
  for (const auto& [node, s] : trace) {
    const Row row = row_of(node);
    moments += s * row * row.transpose();
  }
  const Eigen::LDLT<Eigen::Matrix<double, Dim + 1, Dim + 1>> factor(moments);
  const Row first = Row::Unit(0);
  Row linear = Row::Zero();
  bool usable = factor.info() == Eigen::Success && factor.vectorD().minCoeff() > 1e-6;
  if (usable) {
    linear = factor.solve(first);
  }
  for (const auto& [node, s] : trace) {
    usable = usable && std::abs(s * linear.dot(row_of(node))) <= largest;
  }
  for (auto& [node, s] : trace) {
    s = usable ? s * linear.dot(row_of(node)) : s / kept;
  }
  if (!(kept > tiny)) {
    trace.assign(1, {own, 1.0});
  }
  return trace;
}

template <int Dim>
void SurfaceSystem<Dim>::number_nodes(const HeatLaws<Dim>& laws, std::size_t nodes) {
  for (const Index node : node_) {
    number_[node] = -1;
  }
  node_.clear();
  number_.resize(nodes, -1);
  for (const auto& n : laws.nodes()) {
    for (const auto& [node, weight] : n.trace) {
      if (number_[node] < 0) {
        number_[node] = static_cast<int>(node_.size());
        node_.push_back(node);
      }
    }
  }
}

template <int Dim>
void SurfaceSystem<Dim>::gather(const HeatLaws<Dim>& laws) {
  sites_.clear();
  place_.clear();
  weight_.clear();
  sites_of_law_.assign(1, 0);
  for (const auto& n : laws.nodes()) {
    for (std::size_t k = 0; k < n.node.size(); ++k) {
      const std::size_t first = place_.size();
      for (std::size_t c = n.trace_begin[k]; c < n.trace_begin[k + 1]; ++c) {
        place_.push_back(number_[n.trace[c].first]);
        weight_.push_back(n.trace[c].second);
      }
      sites_.push_back({first, place_.size(), n.rate[k], n.slope[k]});
    }
    sites_of_law_.push_back(sites_.size());
  }
}

template <int Dim>
double SurfaceSystem<Dim>::at(const Site& site, const std::vector<double>& x) const {
  double value = 0.0;
  for (std::size_t c = site.first; c < site.last; ++c) {
    value += weight_[c] * x[place_[c]];
  }
  return value;
}

template <int Dim>
void SurfaceSystem<Dim>::multiply(const std::vector<double>& x, double step,
                                  std::vector<double>& product) const {
  for (std::size_t k = 0; k < x.size(); ++k) {
    product[k] = capacity_[k] * x[k];
  }
  for (const Site& site : sites_) {
    const double pull = step * site.slope * at(site, x);
    for (std::size_t c = site.first; c < site.last; ++c) {
      product[place_[c]] += weight_[c] * pull;
    }
  }
}

template <int Dim>
int SurfaceSystem<Dim>::solve(HeatLaws<Dim>& laws, std::span<const double> capacity,
                              std::span<const double> temperature, const TemperatureRange& range,
                              double step, std::span<double> increment) {
  constexpr double tolerance = 1e-11;  // of the first correction, K
  constexpr int most = 5000;
  number_nodes(laws, increment.size());
  gather(laws);
  const std::size_t count = node_.size();
  for (auto* values : {&capacity_, &rise_, &residual_, &direction_, &image_, &diagonal_}) {
    values->assign(count, 0.0);
  }
  for (std::size_t k = 0; k < count; ++k) {
    diagonal_[k] = capacity_[k] = capacity[node_[k]];
    rise_[k] = increment[node_[k]];
  }
  // From d0: the residual is dt (E - M d0).
  for (const Site& site : sites_) {
    const double push = step * (site.rate - site.slope * at(site, rise_));
    for (std::size_t c = site.first; c < site.last; ++c) {
      residual_[place_[c]] += weight_[c] * push;
      diagonal_[place_[c]] += step * site.slope * weight_[c] * weight_[c];
    }
  }
  double product = 0.0;
  int round = 0;
  const auto precondition = [&](double& dot, double& worst) {
    dot = worst = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      image_[k] = diagonal_[k] > 0.0 ? residual_[k] / diagonal_[k] : 0.0;
      dot += residual_[k] * image_[k];
      // In kelvin: heat that is nothing to others is much to a node of next to no capacity.
      worst = std::max(worst, std::abs(image_[k]));
    }
  };
  double worst = 0.0;
  precondition(product, worst);
  direction_ = image_;
  const double target = tolerance * worst;
  for (; worst > target && product > 0.0; ++round) {
    if (round > most) {
      throw RunError(message("heat: the conditions on the surface did not converge in ", most,
                             " rounds of conjugate gradients"));
    }
    multiply(direction_, step, image_);
    double curvature = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      curvature += direction_[k] * image_[k];
    }
    const double length = product / curvature;
    for (std::size_t k = 0; k < count; ++k) {
      rise_[k] += length * direction_[k];
      residual_[k] -= length * image_[k];
    }
    double next = 0.0;
    precondition(next, worst);
    for (std::size_t k = 0; k < count; ++k) {
      direction_[k] = image_[k] + next / product * direction_[k];
    }
    product = next;
  }
  double given = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    double& now = increment[node_[k]];
    const double before = temperature[node_[k]];
    if (before >= range.low && before <= range.high) {
      rise_[k] = std::clamp(before + rise_[k], range.low, range.high) - before;
    }
    given += capacity_[k] * (rise_[k] - now);
    now = rise_[k];
  }
  book(laws, step, given);
  return round;
}

template <int Dim>
void SurfaceSystem<Dim>::book(HeatLaws<Dim>& laws, double step, double given) const {
  // Each law gave what it says; what rounding and the rounds leave goes to the largest.
  std::vector<double> heat(laws.nodes().size(), 0.0);
  std::size_t largest = 0;
  for (std::size_t law = 0; law < heat.size(); ++law) {
    for (std::size_t s = sites_of_law_[law]; s < sites_of_law_[law + 1]; ++s) {
      heat[law] += step * (sites_[s].rate - sites_[s].slope * at(sites_[s], rise_));
    }
    given -= heat[law];
    largest = std::abs(heat[law]) > std::abs(heat[largest]) ? law : largest;
  }
  for (std::size_t law = 0; law < heat.size(); ++law) {
    laws.book(law, law == largest ? heat[law] + given : heat[law]);
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                                                 \
  template std::vector<std::pair<Index, double>> surface_trace(                                  \
      const Grid<Dim>&, ShapeFunction, double, const Vec<Dim>&, std::span<const double>, Index); \
  template class SurfaceSystem<Dim>;
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
