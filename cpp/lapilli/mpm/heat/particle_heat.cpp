#include "lapilli/mpm/heat/particle_heat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/nodal_assembly.hpp"
#include "lapilli/mpm/heat/particle_boundary.hpp"
#include "lapilli/mpm/heat/step_bound.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {
namespace {

HeatTransfer chosen_transfer(const HeatSettings& settings) {
  return settings.transfer == HeatTransfer::automatic ? HeatTransfer::affine : settings.transfer;
}

}  // namespace

template <int Dim>
ParticleHeat<Dim>::ParticleHeat(Points& points, HeatProblem<Dim> problem)
    : points_(points),
      problem_(std::move(problem)),
      coefficients_(problem_.bodies, problem_.shape),
      transfer_(chosen_transfer(problem_.settings)),
      affine_(transfer_ == HeatTransfer::affine || transfer_ == HeatTransfer::tpic),
      temperature_(points, 1),
      capacity_(points, 1),
      order_(problem_.grid, support_of(problem_.shape)),
      grid_(problem_.grid, problem_.shape, coefficients_,
            !problem_.settings.boundaries.empty() || !problem_.obstacles.empty()),
      laws_(problem_.settings.boundaries, absolute_zero(problem_.settings)),
      obstacles_(problem_.obstacles) {
  require(transfer_ != HeatTransfer::nodal,
          "heat.transfer = \"nodal\" needs points at rest that no method \"particle\" reads");
  require(!affine_ || problem_.shape != ShapeFunction::linear, "heat.transfer = \"",
          name_of(transfer_),
          "\" is unstable with linear shape functions: set grid.shape_function to \"gimp\" or "
          "\"bspline\", or heat.transfer to \"flip\"");
  require(
      problem_.settings.time_integration != TimeIntegration::implicit_theta,
      "heat.time_integration = \"implicit\" needs points at rest and heat.transfer = \"nodal\"");
  require(problem_.settings.method != FluxMethod::particle || !laws_.has_held_temperature(),
          "heat.method = \"particle\" hands fluxes to points and holds no temperature: use "
          "\"virtual\" for a prescribed temperature");
  order_.update(points_);
  if (affine_) {
    gradient_ = std::make_unique<PointArray>(points_, Dim, 0.0, PointArray::Kind::gradient);
  }
  start_with(point_capacities(points_, problem_.bodies),
             initial_temperatures(points_, problem_.bodies));
  if (!laws_.empty()) {
    surface_ = std::make_unique<HeatSurface<Dim>>(points_, problem_);
    compare_with_shapes();
    if (transfer_ == HeatTransfer::flip && problem_.settings.implicit_robin) {
      relaxation_.assign(grid_.capacity.size(), 0.0);
      conductivity_ = std::numeric_limits<double>::infinity();
      for (const HeatBody& body : problem_.bodies) {
        conductivity_ = std::min(conductivity_, largest_conductivity(body.material));
      }
    }
  }
  if (HeatSource<Dim>::is_present(problem_.bodies)) {
    source_.emplace(problem_.bodies);
  }
  bound_carried_step();
  bound_step();
  project_to_grid();
  if (!laws_.empty()) {
    find_surface();
    laws_.require_all_used();
  }
  if (source_ && source_->depends_on_state()) {
    find_self_heating(0.0);
  }
  initial_ = balances().front().stored;
}

template <int Dim>
void ParticleHeat<Dim>::start_with(const std::vector<double>& capacity,
                                   const std::vector<double>& temperature) {
  require_absolute(problem_, points_, temperature);
  range_ = diverged_beyond(problem_, temperature);
  std::copy(capacity.begin(), capacity.end(), capacity_.data());
  std::copy(temperature.begin(), temperature.end(), temperature_.data());
  if (affine_) {
    std::vector<double> gradient;
    map_initial(points_, problem_, coefficients_, capacity, temperature, &gradient);
    std::copy(gradient.begin(), gradient.end(), gradient_->data());
  }
}

template <int Dim>
void ParticleHeat<Dim>::bound_carried_step() {
  if (transfer_ == HeatTransfer::flip) {
    const std::vector<double> capacity(capacity_.values().begin(), capacity_.values().end());
    const NodalOperators<Dim> operators =
        assemble_operators(points_, problem_, coefficients_, capacity, true);
    carried_limit_ =
        2.0 / fastest_carried_rate(*operators.conduction, *operators.capacity, operators.lumped);
  }
}

template <int Dim>
void ParticleHeat<Dim>::bound_step() {
  if (limited_ordering_ == points_.ordering()) {
    return;
  }
  limited_ordering_ = points_.ordering();
  limit_ = fields_ ? separate_limit()
                   : explicit_step_limit(points_, problem_, coefficients_, capacity_.values(),
                                         transfer_);
  if (limit_.hard > carried_limit_) {
    limit_.automatic *= carried_limit_ / limit_.hard;
    limit_.hard = carried_limit_;
  }
}

template <int Dim>
StepReport ParticleHeat<Dim>::advance(const Step& step) {
  order_.update(points_);
  bound_step();
  output_is_current_ = false;
  if (!sub_cycle_) {
    take_step(step);
  } else if (const auto due = sub_cycle_->due(step, own_limit().automatic)) {
    take_due(*due);
  }
  return {step.size, 0, 0.0};
}

template <int Dim>
void ParticleHeat<Dim>::take_step(const Step& step) {
  project_to_grid();
  require_in_range();
  obstacles_.find(problem_, points_, coefficients_, grid_);
  find_surface();
  conduct(step);
  exchange_with_surroundings(step);
  solve_nodes(step);
  update_points(step);
  if (step.output_due || step.index % 128 == 0) {
    require_finite();
  }
}

template <int Dim>
void ParticleHeat<Dim>::project_to_grid() {
  project_to_grid(temperature_.data());
}

template <int Dim>
void ParticleHeat<Dim>::project_to_grid(const double* temperature) {
  const double* gradient = affine_ ? gradient_->data() : nullptr;
  if (fields_) {
    fields_->project(points_, order_, capacity_.data(), temperature, gradient, grid_);
  } else {
    grid_.project(points_, order_, capacity_.data(), temperature, gradient);
  }
}

/// Areas are those of the shapes at the start, where these are known and nobody chose the operator.
template <int Dim>
void ParticleHeat<Dim>::compare_with_shapes() {
  std::vector<Shape> shapes;
  for (const HeatBody& body : problem_.bodies) {
    if (body.shape) {
      shapes.push_back(*body.shape);
    }
  }
  if (problem_.settings.method != FluxMethod::virtual_flux ||
      shapes.size() < problem_.bodies.size()) {
    return;
  }
  const ShapeAreas wanted =
      areas_of_shapes<Dim>(problem_.grid, problem_.shape, shapes,
                           regions_of(problem_.settings.boundaries), problem_.walls);
  laws_.compare_areas(AreaRatios(wanted, [&](const std::vector<std::size_t>& bodies) {
    return areas_without_others(bodies);
  }));
}

template <int Dim>
AreaRatios::Found ParticleHeat<Dim>::areas_without_others(
    const std::vector<std::size_t>& bodies) const {
  const std::unique_ptr<Points> some = points_of(points_, bodies);
  HeatSurface<Dim> surface(*some, problem_);
  const NodalAreas<Dim> areas = surface.areas(
      *some, coefficients_,
      nodal_sums<Dim>(*some, problem_.grid, problem_.shape, coefficients_.half_width));
  return {std::accumulate(areas.area.begin(), areas.area.end(), 0.0),
          laws_.areas_of(problem_.grid, areas, [&] {
            return surface_places<Dim>(problem_.grid, *some, problem_.shape,
                                       coefficients_.half_width, areas, problem_.walls);
          })};
}

template <int Dim>
void ParticleHeat<Dim>::find_surface() {
  const std::pair<Index, Index> now{points_.version(), points_.ordering()};
  if (laws_.empty() || now == surface_found_) {
    return;
  }
  surface_found_ = now;
  if (problem_.settings.method == FluxMethod::particle) {
    const NodalAreas<Dim> areas = particle_areas(points_, problem_);
    laws_.assign(problem_.grid, areas, [&] { return projected_places<Dim>(areas); });
    return;
  }
  NodalAreas<Dim> areas = surface_->areas(points_, coefficients_, grid_.sums);
  negative_share_ = areas.negative_share();
  laws_.area_ratios().scale(areas, surface_->outside());
  laws_.assign(problem_.grid, areas, [&] {
    return surface_places<Dim>(problem_.grid, points_, problem_.shape, coefficients_.half_width,
                               areas, problem_.walls);
  });
  for (const TouchingSurface<Dim>& surface : obstacles_.surfaces()) {
    laws_.leave_to_obstacle(surface.nodes, problem_.grid.cell_size());
  }
  if (laws_.has_held_temperature()) {
    const auto is_active = [&](Index node) { return grid_.capacity[node] > 0.0; };
    laws_.place_probes(problem_.grid, is_active,
                       nodal_conductivity(points_, problem_, coefficients_, grid_.sums));
  }
}

template <int Dim>
void ParticleHeat<Dim>::conduct(const Step& step) {
  if (fields_) {
    fields_->conduct(points_, order_, step, grid_);
  } else {
    grid_.conduct(points_, order_);
  }
}

template <int Dim>
double ParticleHeat<Dim>::blend(double step) const {
  switch (transfer_) {
    case HeatTransfer::flip:
      return 0.0;
    case HeatTransfer::affine: {
      const double h = problem_.grid.cell_size();
      return -std::expm1(-problem_.settings.blend * step * coefficients_.largest_diffusivity /
                         (h * h));
    }
    default:
      return 1.0;
  }
}

template <int Dim>
void ParticleHeat<Dim>::update_points(const Step& step) {
  const double beta = blend(step.size);
  relax_points();
  PointGridTransfer<Dim>& nodes = carrier();
  nodes.for_active_nodes([&](Index begin, Index end) {
    for (Index node = begin; node < end; ++node) {
      nodes.blended[node] = nodes.increment[node] + beta * nodes.temperature[node];
    }
  });
  nodes.update(points_, nodes.blended, beta, temperature_.data(),
               affine_ ? gradient_->data() : nullptr);
  if (step.output_due) {
    nodes.for_active_nodes([&](Index begin, Index end) {
      for (Index node = begin; node < end; ++node) {
        nodes.blended[node] = nodes.increment[node] + nodes.temperature[node];
      }
    });
    show(nodes.blended);
  }
}

template class ParticleHeat<1>;
template class ParticleHeat<2>;
template class ParticleHeat<3>;

}  // namespace lapilli
