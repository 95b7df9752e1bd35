// What the points exchange with their surroundings in a step: sources and laws of the surface.
#include <algorithm>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/exchange_on_diagonal.hpp"
#include "lapilli/mpm/heat/particle_heat.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {

template <int Dim>
void ParticleHeat<Dim>::exchange_with_surroundings(const Step& step) {
  if (laws_.empty()) {
    return;
  }
  if (problem_.settings.method == FluxMethod::particle) {
    exchange_at_points(step);
    return;
  }
  laws_.evaluate_over(grid_.temperature, step.time, step.time + step.size);
}

template <int Dim>
void ParticleHeat<Dim>::exchange_at_points(const Step& step) {
  laws_.evaluate_over(temperature_.values(), step.time, step.time + step.size);
  for (std::size_t law = 0; law < laws_.nodes().size(); ++law) {
    const auto& n = laws_.nodes()[law];
    double heat = 0.0;
    for (std::size_t k = 0; k < n.node.size(); ++k) {
      const Index row = n.node[k];
      heat += step.size * n.rate[k];
      with_shape(problem_.shape, coefficients_.half_width[points_.body()[row]], [&](auto shape) {
        const Weights<Dim, decltype(shape)> weights(problem_.grid, shape,
                                                    points_.position().data() + row * Dim);
        weights.for_each_node(problem_.grid, [&](Index node, double s, const Vec<Dim>&) {
          grid_.rate[node] += s * n.rate[k];
        });
      });
    }
    laws_.book(law, heat);
  }
}

template <int Dim>
void ParticleHeat<Dim>::find_self_heating(double time) {
  source_->assign(points_, problem_, coefficients_.half_width);
  self_heating_.forget();
  for (const auto& n : source_->evaluate_over(grid_.temperature, time, time)) {
    for (std::size_t k = 0; k < n.node.size(); ++k) {
      if (const double capacity = grid_.capacity[n.node[k]]; capacity > 0.0) {
        self_heating_.meet(n.slope[k], capacity);
      }
    }
  }
}

template <int Dim>
void ParticleHeat<Dim>::heat_by_sources(const Step& step) {
  if (!source_) {
    return;
  }
  source_->assign(points_, problem_, coefficients_.half_width);
  double heat = 0.0;
  self_heating_.forget();
  for (const auto& n :
       source_->evaluate_over(grid_.temperature, step.time, step.time + step.size)) {
    for (std::size_t k = 0; k < n.node.size(); ++k) {
      const double capacity = grid_.capacity[n.node[k]];
      if (!(capacity > 0.0)) {
        continue;
      }
      double& increment = grid_.increment[n.node[k]];
      const double rise =
          rise_by_source(increment, step.size * n.rate[k], step.size * n.slope[k], capacity);
      increment += rise;
      heat += capacity * rise;
      self_heating_.meet(n.slope[k], capacity);
    }
  }
  source_->book(heat);
  self_heating_.require_followed(step.size);
}

template <int Dim>
void ParticleHeat<Dim>::solve_nodes(const Step& now) {
  const double step = now.size;
  grid_.for_active_nodes([&, step](Index begin, Index end) {
    const double* capacity = grid_.capacity.data();
    const double* rate = grid_.rate.data();
    double* increment = grid_.increment.data();
    for (Index node = begin; node < end; ++node) {
      increment[node] = capacity[node] > 0.0 ? step * rate[node] / capacity[node] : 0.0;
    }
  });
  heat_by_sources(now);
  if (problem_.settings.method != FluxMethod::particle) {
    exchange_at_nodes(step);
  }
  obstacles_.exchange(now, grid_);
  if (fields_) {
    fields_->solve(now, grid_);
  }
}

template <int Dim>
void ParticleHeat<Dim>::exchange_at_nodes(double step) {
  for (std::size_t law = 0; law < laws_.nodes().size(); ++law) {
    const auto& n = laws_.nodes()[law];
    const auto relax = [&](std::size_t k, double slope, double capacity) {
      if (!relaxation_.empty() && n.area[k] > 0.0) {
        const double biot = slope / n.area[k] * problem_.grid.cell_size() / conductivity_;
        relaxation_[n.node[k]] =
            std::clamp(biot - 1.0, 0.0, 1.0) * step * slope / (capacity + step * slope);
        relaxes_ = relaxes_ || biot > 1.0;
      }
    };
    laws_.book(law, exchange_on_diagonal(n, step, problem_.settings.implicit_robin,
                                         grid_.capacity.data(), grid_.increment.data(), relax));
  }
}

template <int Dim>
void ParticleHeat<Dim>::relax_points() {
  if (!relaxes_) {
    return;
  }
  // T_p += sum S_I beta_I (T_I - T_p) keeps the heat of every node; with the increment
  // beta_I (ambient - T_I) of the law, what a point carries becomes a mean of itself and ambient.
  parallel_for(points_.size(), [&](Index row) {
    const std::size_t body = points_.body()[row];
    with_shape(problem_.shape, coefficients_.half_width[body], [&](auto shape) {
      const Weights<Dim, decltype(shape)> weights(problem_.grid, shape,
                                                  points_.position().data() + row * Dim);
      double change = 0.0;
      weights.for_each_node(problem_.grid, [&](Index node, double s, const Vec<Dim>&) {
        change += s * relaxation_[node] * (grid_.temperature[node] - temperature_[row]);
      });
      temperature_[row] += change;
    });
  });
  for (const auto& n : laws_.nodes()) {
    for (const Index node : n.node) {
      relaxation_[node] = 0.0;
    }
  }
  relaxes_ = false;
}

#define LAPILLI_INSTANTIATE(Dim)                                            \
  template void ParticleHeat<Dim>::exchange_with_surroundings(const Step&); \
  template void ParticleHeat<Dim>::find_self_heating(double);               \
  template void ParticleHeat<Dim>::solve_nodes(const Step&);                \
  template void ParticleHeat<Dim>::exchange_at_nodes(double);               \
  template void ParticleHeat<Dim>::relax_points();
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
