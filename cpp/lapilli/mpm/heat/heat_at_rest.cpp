#include "lapilli/mpm/heat/heat_at_rest.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/cell_order.hpp"
#include "lapilli/mpm/heat/nodal_assembly.hpp"
#include "lapilli/mpm/heat/step_bound.hpp"

namespace lapilli {
namespace {

HeatTransfer chosen_transfer(const HeatSettings& settings) {
  return settings.transfer == HeatTransfer::automatic ? HeatTransfer::kept : settings.transfer;
}

}  // namespace

template <int Dim>
HeatAtRest<Dim>::HeatAtRest(Points& points, HeatProblem<Dim> problem)
    : points_(points),
      problem_(std::move(problem)),
      coefficients_(problem_.bodies, problem_.shape),
      transfer_(chosen_transfer(problem_.settings)),
      laws_(problem_.settings.boundaries) {
  require(
      problem_.settings.stepping == HeatStepping::explicit_euler || transfer_ == HeatTransfer::kept,
      "heat.stepping = \"theta\" needs heat.transfer = \"kept\", got \"", name_of(transfer_), "\"");
  CellOrder<Dim>(problem_.grid, support_of(problem_.shape)).update(points_);
  assemble();
  bound_step();
}

template <int Dim>
void HeatAtRest<Dim>::assemble() {
  const Grid<Dim>& grid = problem_.grid;
  const std::vector<double> capacity = point_capacities(points_, problem_.bodies);
  const std::vector<double> start = initial_temperatures(points_, problem_.bodies);
  NodalSums<Dim> sums = nodal_sums(points_, problem_, coefficients_);
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

  std::vector<double> unused;
  const std::vector<double> nodal =
      map_initial(points_, problem_, coefficients_, capacity, start,
                  transfer_ == HeatTransfer::kept ? &unused : nullptr);
  temperature_.assign(lumped_.size(), 0.0);
  increment_.assign(lumped_.size(), 0.0);
  for (Index node = 0; node < grid.node_count(); ++node) {
    if (operators.active[node] != 0) {
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

  const auto place_of = [&](Index node) { return rows_->place(node); };
  if (!laws_.empty()) {
    HeatSurface<Dim> surface(points_, problem_);
    const NodalAreas<Dim> areas = surface.areas(points_, coefficients_, sums);
    negative_share_ = areas.negative_share();
    laws_.assign(areas, grid.cell_size());
    laws_.require_all_used();
    if (laws_.has_held_temperature()) {
      const auto is_active = [&](Index node) { return operators.active[node] != 0; };
      laws_.place_probes(grid, is_active,
                         nodal_conductivity(points_, problem_, coefficients_, sums));
    }
    laws_.renumber(place_of);
  }
  if (HeatSource<Dim>::is_present(problem_.bodies)) {
    source_.emplace(problem_.bodies);
    source_->assign(points_, problem_, coefficients_.half_width);
    source_->renumber(place_of);
  }
  if (problem_.settings.stepping == HeatStepping::theta) {
    theta_ =
        std::make_unique<ThetaSolver<Dim>>(*rows_, *conduction_, lumped_, problem_.settings.solver);
  }
  initial_ = ledgers().front().stored;
}

template <int Dim>
void HeatAtRest<Dim>::bound_step() {
  if (theta_) {
    limit_.reason = "the theta scheme has no limit";
    return;
  }
  const double h = problem_.grid.cell_size();
  std::vector<double> extra(lumped_.size(), 0.0);
  for (const auto& nodes : laws_.nodes()) {
    for (std::size_t k = 0; k < nodes.conductance.size(); ++k) {
      extra[nodes.node[k]] += nodes.area[k] * nodes.conductance[k];
    }
  }
  const double fastest = fastest_rate(*conduction_, lumped_, extra);
  const double by_operator = fastest > 0.0 ? 2.0 / fastest : limit_.hard;
  if (carries_points() && problem_.bodies.size() == 1) {
    const double multiple = carried_limit(transfer_, problem_.shape);
    limit_.hard = std::max(by_operator, multiple * h * h / coefficients_.largest_diffusivity);
    limit_.automatic = 0.8 * limit_.hard;
    limit_.reason = message("explicit heat, ", name_of(transfer_), ": ", multiple, " h^2/alpha");
  } else {
    limit_.hard = by_operator;
    limit_.automatic = (carries_points() ? 0.8 : 0.6) * by_operator;
    if (fastest > 0.0) {
      limit_.automatic =
          std::min(limit_.automatic, 1.0 / fastest_node(*conduction_, lumped_, extra));
    }
    limit_.reason = "explicit heat: Gershgorin bound of the nodal operator";
  }
}

template <int Dim>
StepReport HeatAtRest<Dim>::advance(const Step& step) {
  if (step.index % 128 == 0) {
    require_finite();
  }
  if (theta_) {
    return advance_implicitly(step);
  }
  conduct(step.size);
  exchange_with_surroundings(step);
  hand_back_to_points();
  return {step.size, 0, 0.0};
}

template <int Dim>
void HeatAtRest<Dim>::conduct(double step) {
  const double* inverse = inverse_.data();
  double* increment = increment_.data();
  conduction_->multiply(temperature_.data(), [=](Index place, int count, const auto& product) {
    for (int k = 0; k < count; ++k) {
      increment[place + k] = -step * inverse[place + k] * product[k];
    }
  });
}

template <int Dim>
void HeatAtRest<Dim>::exchange_with_surroundings(const Step& step) {
  if (source_) {
    double heat = 0.0;
    source_->for_each(temperature_, step.time, [&](Index place, double rate) {
      increment_[place] += step.size * inverse_[place] * rate;
      heat += step.size * rate;
    });
    source_->book(heat);
  }
  laws_.evaluate(temperature_, step.time);
  for (std::size_t law = 0; law < laws_.nodes().size(); ++law) {
    const auto& n = laws_.nodes()[law];
    double heat = 0.0;
    for (std::size_t k = 0; k < n.node.size(); ++k) {
      const Index place = n.node[k];
      // The law at the end of the step: (C + dt slope) dT = dt (conduction + rate). In this form
      // the heat stays exact where a stiff law leaves a small difference of large rates.
      const double slope = problem_.settings.implicit_exchange ? n.slope[k] : 0.0;
      const double rise = step.size * (n.rate[k] - slope * increment_[place]) /
                          (lumped_[place] + step.size * slope);
      increment_[place] += rise;
      heat += lumped_[place] * rise;
    }
    laws_.book(law, heat);
  }
}

template <int Dim>
void HeatAtRest<Dim>::hand_back_to_points() {
  const auto size = static_cast<Index>(temperature_.size());
  double* temperature = temperature_.data();
  const double* increment = increment_.data();
  if (transfer_ == HeatTransfer::kept) {
    parallel_ranges(size, [=](Index begin, Index end) {
      for (Index place = begin; place < end; ++place) {
        temperature[place] += increment[place];
      }
    });
    return;
  }
  double* updated = updated_.data();
  parallel_ranges(size, [=](Index begin, Index end) {
    for (Index place = begin; place < end; ++place) {
      updated[place] = temperature[place] + increment[place];
    }
  });
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

template <int Dim>
StepReport HeatAtRest<Dim>::advance_implicitly(const Step& step) {
  // The first two steps are taken as backward Euler halves, which share the matrix of a
  // Crank-Nicolson step and damp what the start excites (Rannacher 1984).
  const double theta = problem_.settings.theta;
  const bool starting = step.index < 2 && theta < 1.0;
  const int parts = starting ? 2 : 1;
  const double size = step.size / parts, weight = starting ? 1.0 : theta;
  const bool linear = laws_.is_linear() && !(source_ && source_->depends_on_state());
  const int iterations_allowed = linear ? 1 : 30;
  StepReport report{step.size, 0, 0.0};
  std::vector<double> residual(temperature_.size()), known(temperature_.size());
  std::vector<double> trial(temperature_.size()), middle(temperature_.size());
  std::vector<double> sources(temperature_.size());
  for (int part = 0; part < parts; ++part) {
    const double begin = step.time + part * size;
    // What the start of the step contributes, sources apart.
    std::fill(known.begin(), known.end(), 0.0);
    std::fill(sources.begin(), sources.end(), 0.0);
    const auto add_laws = [&](double time, double factor, std::span<double> to) {
      laws_.evaluate(trial, time);
      for (const auto& n : laws_.nodes()) {
        for (std::size_t k = 0; k < n.node.size(); ++k) {
          to[n.node[k]] += factor * n.rate[k];
        }
      }
    };
    const auto add_sources = [&](double time, double factor, std::span<double> to) {
      if (source_) {
        source_->for_each(trial, time,
                          [&](Index place, double rate) { to[place] += factor * rate; });
      }
    };
    // C (trial - T) + dt K (T + theta (trial - T)): the heat a node took up and handed on.
    const auto balance = [&](const auto& body) {
      for (std::size_t place = 0; place < trial.size(); ++place) {
        middle[place] = temperature_[place] + weight * (trial[place] - temperature_[place]);
      }
      conduction_->multiply(middle.data(), [&](Index place, int count, const auto& product) {
        for (int k = 0; k < count; ++k) {
          const Index at = place + k;
          body(at, lumped_[at] * (trial[at] - temperature_[at]) + size * product[k]);
        }
      });
    };
    trial = temperature_;
    if (weight < 1.0) {
      add_laws(begin, (1.0 - weight) * size, known);
      add_sources(begin, (1.0 - weight) * size, sources);
    }
    double scale = 0.0, change = 0.0;
    for (int iteration = 0; iteration < iterations_allowed; ++iteration) {
      // residual = dt (-K (T + theta d) + (1 - theta) rate(T) + theta rate(T + d)) - C d
      residual = known;
      add_laws(begin + size, weight * size, residual);
      for (std::size_t place = 0; place < trial.size(); ++place) {
        residual[place] += sources[place];
      }
      add_sources(begin + size, weight * size, residual);
      balance([&](Index place, double heat) { residual[place] -= heat; });
      theta_->prepare(weight * size, laws_);
      theta_->solve(residual, increment_);
      change = scale = 0.0;
      for (std::size_t place = 0; place < trial.size(); ++place) {
        trial[place] += increment_[place];
        change = std::max(change, std::abs(increment_[place]));
        scale = std::max(scale, std::abs(trial[place]));
      }
      ++report.iterations;
      if (change <= 1e-13 * scale) {
        break;
      }
    }
    if (linear) {
      change = 0.0;  // one solve is the answer
    }
    if (change > 1e-8 * scale) {
      throw RunError(message("heat: the theta scheme stalled after ", iterations_allowed,
                             " iterations, change ", change, " K; take smaller steps"));
    }
    report.residual = std::max(report.residual, scale > 0.0 ? change / scale : 0.0);
    add_sources(begin + size, weight * size, sources);
    // A law gave its nodes what they took up beyond conduction and sources: exact where a stiff law
    // leaves a small difference of large rates.
    balance([&](Index place, double heat) { residual[place] = heat - sources[place]; });
    for (std::size_t law = 0; law < laws_.nodes().size(); ++law) {
      double heat = 0.0;
      for (const Index place : laws_.nodes()[law].node) {
        heat += residual[place];
      }
      laws_.book(law, heat);
    }
    if (source_) {
      source_->book(std::accumulate(sources.begin(), sources.end(), 0.0));
    }
    temperature_ = trial;
  }
  return report;
}

template <int Dim>
void HeatAtRest<Dim>::require_finite() const {
  for (const auto& row : rows_->rows()) {
    for (int i = row.begin; i < row.end; ++i) {
      if (!std::isfinite(temperature_[row.shift + i])) {
        const Index node = row.grid_row * problem_.grid.nodes(0) + i;
        throw RunError(message("heat: temperature of the node at (",
                               problem_.grid.node_position(node).transpose(),
                               ") is not finite; a law or source gave such a value, or the step is "
                               "too large for it"));
      }
    }
  }
}

template <int Dim>
void HeatAtRest<Dim>::refresh_output() {
  require_finite();
  if (!output_temperature_) {
    output_temperature_ = std::make_unique<PointArray>(points_, 1);
    output_flux_ = std::make_unique<PointArray>(points_, Dim);
    if (carries_points()) {
      output_carried_ = std::make_unique<PointArray>(points_, 1);
    }
  }
  const std::vector<double>& nodal = carries_points() ? updated_ : temperature_;
  parallel_for(points_.size(), [&](Index row) {
    const auto body = static_cast<std::size_t>(points_.body()[row]);
    with_shape(problem_.shape, coefficients_.half_width[body], [&](auto shape) {
      const Weights<Dim, decltype(shape)> weights(problem_.grid, shape,
                                                  points_.position().data() + row * Dim);
      double value = 0.0, sum = 0.0;
      Vec<Dim> gradient = Vec<Dim>::Zero();
      weights.for_each_node(problem_.grid, [&](Index node, double s, const Vec<Dim>& slope) {
        const Index place = rows_->place(node);
        if (lumped_[place] > 0.0) {
          value += s * nodal[place];
          gradient += nodal[place] * slope;
          sum += transfer_ == HeatTransfer::flip ? s * total_[place] : 0.0;
        }
      });
      (*output_temperature_)[row] = value;
      Eigen::Map<Vec<Dim>>(output_flux_->data() + row * Dim) =
          -coefficients_.conductivity[body] * gradient;
      if (carries_points()) {
        (*output_carried_)[row] = transfer_ == HeatTransfer::flip ? (*start_)[row] + sum : value;
      }
    });
  });
}

template <int Dim>
std::vector<Field> HeatAtRest<Dim>::fields() {
  if (!output_temperature_) {
    refresh_output();
  }
  std::vector<Field> fields{{"temperature", "K", 1, output_temperature_->values()},
                            {"heat_flux", "W/m^2", Dim, output_flux_->values()}};
  if (output_carried_) {
    fields.push_back({"temperature_carried", "K", 1, output_carried_->values()});
  }
  return fields;
}

template <int Dim>
std::vector<Ledger> HeatAtRest<Dim>::ledgers() const {
  Ledger ledger{"heat", "J", initial_, 0.0, laws_.entries(), 0.0};
  if (source_) {
    ledger.entries.push_back({"source", source_->booked()});
  }
  double low = std::numeric_limits<double>::infinity(), high = -low, capacity = 0.0;
  for (std::size_t place = 0; place < lumped_.size(); ++place) {
    if (lumped_[place] > 0.0) {
      ledger.stored += lumped_[place] * temperature_[place];
      capacity += lumped_[place];
      low = std::min(low, temperature_[place]);
      high = std::max(high, temperature_[place]);
    }
  }
  ledger.scale = capacity * (high - low);
  return {ledger};
}

template <int Dim>
std::vector<std::pair<std::string, double>> HeatAtRest<Dim>::diagnostics() const {
  std::vector<std::pair<std::string, double>> all;
  if (!laws_.empty()) {
    double area = 0.0;
    for (const auto& nodes : laws_.nodes()) {
      for (const double a : nodes.area) {
        area += a;
      }
    }
    all.emplace_back("surface_area", area);
    all.emplace_back("negative_area_share", negative_share_);
  }
  return all;
}

template <int Dim>
void HeatAtRest<Dim>::save(Archive& archive) const {
  archive.write("heat/temperature", temperature_);
  archive.write("heat/updated", updated_);
  archive.write("heat/total", total_);
  archive.write("heat/initial", initial_);
  archive.write("heat/source", source_ ? source_->booked() : 0.0);
  if (start_) {
    archive.write("heat/start", start_->values());
  }
  laws_.save(archive, "heat/laws");
}

template <int Dim>
void HeatAtRest<Dim>::load(const Archive& archive) {
  archive.read("heat/temperature", std::span<double>(temperature_));
  archive.read("heat/updated", std::span<double>(updated_));
  archive.read("heat/total", std::span<double>(total_));
  initial_ = archive.read_number("heat/initial");
  if (source_) {
    source_->set_booked(archive.read_number("heat/source"));
  }
  if (start_) {
    archive.read("heat/start", start_->values());
  }
  laws_.load(archive, "heat/laws");
}

template class HeatAtRest<1>;
template class HeatAtRest<2>;
template class HeatAtRest<3>;

}  // namespace lapilli
