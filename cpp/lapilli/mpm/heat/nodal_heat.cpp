#include "lapilli/mpm/heat/nodal_heat.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/exchange_on_diagonal.hpp"
#include "lapilli/mpm/heat/nodal_assembly.hpp"
#include "lapilli/mpm/heat/step_bound.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"
#include "lapilli/mpm/transfer/cell_order.hpp"

namespace lapilli {
namespace {

HeatTransfer chosen_transfer(const HeatSettings& settings) {
  return settings.transfer == HeatTransfer::automatic ? HeatTransfer::nodal : settings.transfer;
}

}  // namespace

template <int Dim>
NodalHeat<Dim>::NodalHeat(Points& points, HeatProblem<Dim> problem)
    : points_(points),
      problem_(std::move(problem)),
      coefficients_(problem_.bodies, problem_.shape),
      transfer_(chosen_transfer(problem_.settings)),
      laws_(problem_.settings.boundaries, absolute_zero(problem_.settings)),
      in_time_(problem_.settings.boundaries) {
  require(problem_.settings.time_integration != TimeIntegration::implicit_theta ||
              transfer_ == HeatTransfer::nodal,
          "heat.time_integration = \"implicit\" needs heat.transfer = \"nodal\", got \"",
          name_of(transfer_), "\"");
  CellOrder<Dim>(problem_.grid, support_of(problem_.shape)).update(points_);
  assemble();
  bound_step();
  if (source_ && source_->depends_on_state()) {
    find_self_heating(0.0);
  }
}

template <int Dim>
void NodalHeat<Dim>::assemble() {
  const Grid<Dim>& grid = problem_.grid;
  const std::vector<double> capacity = point_capacities(points_, problem_.bodies);
  const std::vector<double> start = initial_temperatures(points_, problem_.bodies);
  require_absolute(problem_, points_, start);
  NodalSums<Dim> sums =
      nodal_sums<Dim>(points_, problem_.grid, problem_.shape, coefficients_.half_width);
  NodalOperators<Dim> operators =
      assemble_operators(points_, problem_, coefficients_, capacity, carries_points());
  rows_ = std::move(operators.rows);
  conduction_ = std::move(operators.conduction);
  capacity_ = std::move(operators.capacity);
  lumped_ = std::move(operators.lumped);
  inverse_.assign(lumped_.size(), 0.0);
  for (std::size_t place = 0; place < lumped_.size(); ++place) {
    inverse_[place] = lumped_[place] > 0.0 ? 1.0 / lumped_[place] : 0.0;
  }

  const auto is_active = [&](Index node) { return operators.active[node] != 0; };
  std::vector<double> unused;
  const std::vector<double> nodal =
      map_initial(points_, problem_, coefficients_, capacity, start,
                  transfer_ == HeatTransfer::nodal ? &unused : nullptr);
  temperature_.assign(lumped_.size(), 0.0);
  increment_.assign(lumped_.size(), 0.0);
  for (Index node = 0; node < grid.node_count(); ++node) {
    if (is_active(node)) {
      temperature_[rows_->place(node)] = nodal[node];
    } else {
      sums.fraction[node] = 0.0;
    }
  }
  if (carries_points()) {
    updated_ = temperature_;
  }
  if (transfer_ == HeatTransfer::flip) {
    total_.assign(lumped_.size(), 0.0);
    start_ = std::make_unique<PointArray>(points_, 1);
    std::copy(start.begin(), start.end(), start_->data());
  }

  if (!laws_.empty()) {
    assign_laws(sums, is_active);
  }
  if (HeatSource<Dim>::is_present(problem_.bodies)) {
    source_.emplace(problem_.bodies);
    source_->assign(points_, problem_, coefficients_.half_width);
    source_->renumber([&](Index node) { return is_active(node) ? rows_->place(node) : Index{-1}; });
  }
  if (problem_.settings.time_integration == TimeIntegration::implicit_theta) {
    theta_ =
        std::make_unique<ThetaSolver<Dim>>(*rows_, *conduction_, lumped_, problem_.settings.solver);
  }
  initial_ = balances().front().stored;
}

template <int Dim>
void NodalHeat<Dim>::assign_laws(const NodalSums<Dim>& sums,
                                 const std::function<bool(Index)>& is_active) {
  const Grid<Dim>& grid = problem_.grid;
  HeatSurface<Dim> surface(points_, problem_);
  const NodalAreas<Dim> areas = surface.areas(points_, coefficients_, sums);
  negative_share_ = areas.negative_share();
  laws_.assign(grid, areas, [&] {
    return surface_places<Dim>(grid, points_, problem_.shape, coefficients_.half_width, areas,
                               problem_.walls);
  });
  laws_.require_all_used();
  if (laws_.has_held_temperature()) {
    laws_.place_probes(grid, is_active, nodal_conductivity(points_, problem_, coefficients_, sums));
  }
  laws_.renumber([&](Index node) { return rows_->place(node); });
}

template <int Dim>
void NodalHeat<Dim>::bound_step() {
  if (theta_) {
    limit_.reason = "the theta scheme has no limit";
    return;
  }
  const double h = problem_.grid.cell_size();
  const double fastest =
      fastest_rate(*conduction_, lumped_, std::span<const NodeCoupling>(laws_.couplings()));
  const double by_operator = fastest > 0.0 ? 2.0 / fastest : limit_.hard;
  if (carries_points() && problem_.bodies.size() == 1) {
    const double multiple = carried_limit(transfer_, problem_.shape);
    limit_.hard = std::max(by_operator, multiple * h * h / coefficients_.largest_diffusivity);
    if (transfer_ == HeatTransfer::flip) {
      const double carried = fastest_carried_rate(*conduction_, *capacity_, lumped_);
      limit_.hard = carried > 0.0 ? std::min(limit_.hard, 2.0 / carried) : limit_.hard;
    }
    limit_.automatic = 0.8 * limit_.hard;
    limit_.reason = message("explicit heat, ", name_of(transfer_), ": ", multiple, " h^2/alpha");
  } else {
    limit_.hard = by_operator;
    limit_.automatic = (carries_points() ? 0.8 : 0.6) * by_operator;
    if (fastest > 0.0) {
      limit_.automatic = std::min(limit_.automatic, 1.0 / fastest_node(*conduction_, lumped_));
    }
    limit_.reason = "explicit heat: Gershgorin bound of the nodal operator";
  }
}

template <int Dim>
void NodalHeat<Dim>::find_self_heating(double time) {
  for (const auto& n : source_->evaluate_over(temperature_, time, time)) {
    for (std::size_t k = 0; k < n.node.size(); ++k) {
      self_heating_.meet(n.slope[k], lumped_[n.node[k]]);
    }
  }
}

template <int Dim>
StepLimit NodalHeat<Dim>::step_limit() const {
  StepLimit limit = limit_;
  if (!theta_) {
    self_heating_.bound(limit);
  }
  return limit;
}

template <int Dim>
StepReport NodalHeat<Dim>::advance(const Step& step) {
  StepReport report{step.size, 0, 0.0};
  if (theta_) {
    report = advance_implicitly(step);
  } else {
    conduct(step.size);
    exchange_with_surroundings(step);
    hand_back_to_points();
  }
  if (step.output_due || step.index % 128 == 0) {
    require_finite();
  }
  return report;
}

template <int Dim>
void NodalHeat<Dim>::conduct(double step) {
  const double* inverse = inverse_.data();
  double* increment = increment_.data();
  conduction_->multiply(temperature_.data(), [=](Index place, int count, const auto& product) {
    for (int k = 0; k < count; ++k) {
      increment[place + k] = -step * inverse[place + k] * product[k];
    }
  });
}

template <int Dim>
void NodalHeat<Dim>::exchange_with_surroundings(const Step& step) {
  if (source_) {
    self_heating_.forget();
    double heat = 0.0;
    for (const auto& n : source_->evaluate_over(temperature_, step.time, step.time + step.size)) {
      for (std::size_t k = 0; k < n.node.size(); ++k) {
        const Index place = n.node[k];
        const double rise = rise_by_source(increment_[place], step.size * n.rate[k],
                                           step.size * n.slope[k], lumped_[place]);
        increment_[place] += rise;
        heat += lumped_[place] * rise;
        self_heating_.meet(n.slope[k], lumped_[place]);
      }
    }
    source_->book(heat);
    self_heating_.require_followed(step.size);
  }
  laws_.evaluate_over(temperature_, step.time, step.time + step.size);
  for (std::size_t law = 0; law < laws_.nodes().size(); ++law) {
    laws_.book(law,
               exchange_on_diagonal(laws_.nodes()[law], step.size, problem_.settings.implicit_robin,
                                    lumped_.data(), increment_.data(), [](auto...) {}));
  }
}

template <int Dim>
void NodalHeat<Dim>::hand_back_to_points() {
  const auto size = static_cast<Index>(temperature_.size());
  double* temperature = temperature_.data();
  const double* increment = increment_.data();
  if (transfer_ == HeatTransfer::nodal) {
    parallel_for(
        size, [=](Index place) { temperature[place] += increment[place]; }, Work::light);
    return;
  }
  double* updated = updated_.data();
  parallel_for(
      size, [=](Index place) { updated[place] = temperature[place] + increment[place]; },
      Work::light);
  const double* inverse = inverse_.data();
  if (transfer_ == HeatTransfer::flip) {
    double* total = total_.data();
    capacity_->multiply(increment, [=](Index place, int count, const auto& product) {
      for (int k = 0; k < count; ++k) {
        temperature[place + k] += inverse[place + k] * product[k];
        total[place + k] += increment[place + k];
      }
    });
  } else {
    capacity_->multiply(updated, [=](Index place, int count, const auto& product) {
      for (int k = 0; k < count; ++k) {
        temperature[place + k] = inverse[place + k] * product[k];
      }
    });
  }
}

template class NodalHeat<1>;
template class NodalHeat<2>;
template class NodalHeat<3>;

}  // namespace lapilli
