#include "lapilli/peridynamics/heat.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/parallel.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr Index stiffest_every = 16;      // steps
constexpr double patch_tolerance = 0.03;  // of the bonds of a point
constexpr double end_tolerance = 0.005;   // of the heat of a wall

}  // namespace

PeridynamicHeat::PeridynamicHeat(Points& points, std::shared_ptr<WallSurface> walls,
                                 const PeridynamicHeatSettings& settings, const Fluid& fluid,
                                 bool points_move)
    : points_(points),
      walls_(std::move(walls)),
      settings_(settings),
      fluid_(fluid),
      exchange_(make_heat_exchange(points, *walls_, settings, fluid.conductivity(), points_move)),
      temperature_(points, 1),
      capacity_(points, 1),
      rate_(points, 1),
      wall_heat_flux_(points, 1),
      met_area_(points, 1),
      surface_(walls_->walls().size()),
      from_walls_(walls_->walls().size(), 0.0),
      supplied_(walls_->walls().size() + 2, 0.0) {
  for (Index i = 0; i < points.size(); ++i) {
    if (walls_->wall(i) < 0) {
      capacity_[i] = fluid_.thermal.capacity() * points.volume()[i];
    }
  }
  std::vector<Vec3> place(static_cast<std::size_t>(points.size()));
  for (Index i = 0; i < points.size(); ++i) {
    place[static_cast<std::size_t>(i)] = walls_->place(i);
  }
  std::vector<double> start(place.size());
  for (const FluidBody& body : fluid_.bodies) {
    body.temperature.evaluate(place, {}, 0.0, start);
    for (Index i = 0; i < points.size(); ++i) {
      if (points.body()[i] == body.body) {
        temperature_[i] = start[static_cast<std::size_t>(i)];
      }
    }
  }
  points_move_ = points_move;
  prescribe_walls(0.0, 0.0);
  exchange_->refresh();
  find_self_heating();
  find_stiffest();
}

void PeridynamicHeat::find_stiffest() {
  // Until the next rates these rows are free.
  exchange_->diagonal(rate_.data());
  stiffest_ = 0.0;
  for (Index i = 0; i < points_.size(); ++i) {
    if (capacity_[i] > 0.0) {
      stiffest_ = std::max(stiffest_, rate_[i] / capacity_[i]);
    }
  }
}

StepLimit PeridynamicHeat::step_limit() const {
  const double diffusivity = fluid_.diffusivity();
  if (diffusivity == 0.0) {
    StepLimit limit;
    self_heating_.bound(limit);
    return limit;
  }
  const double natural =
      walls_->spacing() * walls_->spacing() / (points_.dimension() * diffusivity);
  const double least = stiffest_ > 0.0 ? 1.0 / stiffest_ : natural;
  StepLimit limit{std::min(0.5 * natural, least),
                  std::min(settings_.step_factor * natural, 0.9 * least),
                  least < 0.5 * natural ? "explicit conduction, capacity over the bonds of a point"
                                        : "explicit conduction, 0.5 dx^2/(dim alpha)"};
  self_heating_.bound(limit);
  return limit;
}

StepReport PeridynamicHeat::advance(const Step& step) {
  if (!started_) {
    initial_ = stored();
    started_ = true;
  }
  const double end = step.time + step.size;
  prescribe_walls(step.time, end);
  exchange_->update();
  if (step.index % stiffest_every == 0) {
    find_stiffest();
  }
  interpolate_to_shifted_places();
  exchange_->rates(temperature_.data(), surface_, rate_.data(), from_walls_);
  source_power_ = dissipated_power_ = 0.0;
  self_heating_.forget();
  for (const FluidBody& body : fluid_.bodies) {
    add_source(body, step.time, end);
  }
  self_heating_.require_followed(step.size);
  add_dissipation();
  update_points(step);
  return {step.size, 0, 0.0};
}

// A point that is shifted takes the temperature of the place it comes to. Together this adds no
// heat: what the sums of all points leave over is taken from those that brought it.
void PeridynamicHeat::interpolate_to_shifted_places() {
  if (shift_ == nullptr) {
    return;
  }
  std::fill(rate_.values().begin(), rate_.values().end(), 0.0);
  exchange_->add_missed(temperature_.data(), surface_, shift_->data(), rate_.data());
  // Gained and lost by all.
  const Vec<2> sums = parallel_sum(points_.size(), Vec<2>(0.0, 0.0), [&](Index i) {
    return Vec<2>(std::max(rate_[i], 0.0), std::max(-rate_[i], 0.0));
  });
  const double kept = sums.minCoeff();
  if (!(kept > 0.0)) {
    return;
  }
  const double of_gain = kept / sums[0], of_loss = kept / sums[1];
  parallel_for(points_.size(), [&](Index i) {
    if (capacity_[i] > 0.0) {
      const double part = rate_[i] > 0.0 ? of_gain : of_loss;
      temperature_[i] += fluid_.thermal.capacity() * part * rate_[i] / capacity_[i];
    }
  });
}

void PeridynamicHeat::update_points(const Step& step) {
  parallel_for(points_.size(), [&](Index i) {
    if (capacity_[i] > 0.0) {
      rate_[i] = step.size * rate_[i] / capacity_[i];
    }
  });
  if (!source_fall_.empty()) {
    follow_sources(step.size);
  }
  parallel_for(points_.size(), [&](Index i) {
    if (capacity_[i] > 0.0) {
      temperature_[i] += rate_[i];
    }
  });
  for (std::size_t k = 0; k < from_walls_.size(); ++k) {
    supplied_[k] += step.size * from_walls_[k];
  }
  supplied_[from_walls_.size()] += step.size * source_power_;
  supplied_[from_walls_.size() + 1] += step.size * dissipated_power_;
  if (step.index % 64 == 0) {
    for (Index i = 0; i < points_.size(); ++i) {
      if (!std::isfinite(temperature_[i])) {
        throw RunError(message("temperature of point ", points_.id()[i],
                               " is no longer a number: the step of ", step.size,
                               " s is too long, or the flow has become unstable"));
      }
    }
  }
}

double PeridynamicHeat::stored() const {
  return parallel_sum(points_.size(), 0.0, [&](Index i) { return capacity_[i] * temperature_[i]; });
}

double PeridynamicHeat::mean_temperature() const {
  return stored() / parallel_sum(points_.size(), 0.0, [&](Index i) { return capacity_[i]; });
}

double PeridynamicHeat::span() const {
  double low = std::numeric_limits<double>::infinity(), high = -low, capacity = 0.0;
  for (Index i = 0; i < points_.size(); ++i) {
    if (capacity_[i] > 0.0) {
      capacity += capacity_[i];
      low = std::min(low, temperature_[i]);
      high = std::max(high, temperature_[i]);
    }
  }
  return capacity > 0.0 ? capacity * (high - low) : 0.0;
}

void PeridynamicHeat::refresh_output() {
  exchange_->refresh();
  exchange_->wall_rows(temperature_.data(), surface_, wall_heat_flux_.data(), met_area_.data());
}

std::vector<Field> PeridynamicHeat::fields() {
  constexpr const char* areas[] = {"", "m", "m^2"};
  return {{"temperature", "K", 1, temperature_.values()},
          {"wall_heat_flux", "W/m^2", 1, wall_heat_flux_.values()},
          {"wall_area", areas[points_.dimension() - 1], 1, met_area_.values()}};
}

std::vector<Balance> PeridynamicHeat::balances() const {
  const double now = stored();
  const double before = started_ ? initial_ : now;
  Balance balance{"heat", "J", before, now, {}, span(), 1e-6};
  for (std::size_t k = 0; k < from_walls_.size(); ++k) {
    balance.entries.push_back({message("wall ", walls_->walls()[k].settings.name), supplied_[k]});
  }
  balance.entries.push_back({"source", supplied_[from_walls_.size()]});
  if (dissipation_ != nullptr) {
    balance.entries.push_back({"dissipation", supplied_[from_walls_.size() + 1]});
  }
  return {balance};
}

void PeridynamicHeat::save(Archive& archive) const {
  archive.write("heat/temperature", temperature_.values());
  archive.write("heat/capacity", capacity_.values());
  archive.write("heat/from_walls", from_walls_);
  archive.write("heat/supplied", supplied_);
  archive.write("heat/initial", initial_);
  archive.write("heat/stiffest", stiffest_);
  archive.write("heat/self_heating", self_heating_.rate());
  archive.write("heat/started", static_cast<Index>(started_ ? 1 : 0));
  exchange_->save(archive);
  walls_->save(archive);
}

void PeridynamicHeat::load(const Archive& archive) {
  archive.read("heat/temperature", temperature_.values());
  archive.read("heat/capacity", capacity_.values());
  archive.read("heat/from_walls", from_walls_);
  archive.read("heat/supplied", supplied_);
  initial_ = archive.read_number("heat/initial");
  stiffest_ = archive.read_number("heat/stiffest");
  self_heating_.set_rate(archive.read_number("heat/self_heating"));
  started_ = archive.read_index("heat/started") == 1;
  walls_->load(archive);
  prescribed_ = false;
  exchange_->load(archive);
}

std::vector<std::pair<std::string, double>> PeridynamicHeat::diagnostics() const {
  std::vector<std::pair<std::string, double>> numbers;
  for (std::size_t k = 0; k < from_walls_.size(); ++k) {
    if (walls_->walls()[k].settings.heat != WallHeat::adiabatic) {
      numbers.emplace_back(message("heat_flow_from_wall_", walls_->walls()[k].settings.name),
                           from_walls_[k]);
    }
  }
  numbers.emplace_back("bond_imbalance", exchange_->imbalance());
  return numbers;
}

std::vector<Note> PeridynamicHeat::warnings() const {
  std::vector<Note> all;
  if (points_move_) {
    return all;
  }
  if (const double missing = exchange_->imbalance(); missing > patch_tolerance) {
    all.push_back(
        note("peridynamics.thin-body", "the bonds of a point miss its surface, or each other, by ",
             100.0 * missing,
             " % of their own: there heat is conducted in a linear field that should rest; "
             "take smaller cells where the body is thin, or laplacian = \"corrected\""));
  } else if (settings_.laplacian != Laplacian::corrected) {
    all.push_back(note("peridynamics.comparison-laplacian", "laplacian = \"",
                       name_of(settings_.laplacian),
                       "\" is there for comparison: through walls that do not fit its points it "
                       "conducts 1 to 4 % wrong at 20 points across; leave it out"));
  }
  for (std::size_t k = 0; k < from_walls_.size(); ++k) {
    if (const double lost = exchange_->lost_at_ends(static_cast<int>(k)); lost > end_tolerance) {
      all.push_back(note("peridynamics.held-end", "wall '", walls_->walls()[k].settings.name,
                         "' holds a temperature and ends within a side, where heat crowds: "
                         "about ",
                         std::round(1000.0 * lost) / 10.0,
                         " % of its heat is missed; halve grid.cell to halve that"));
    }
  }
  return all;
}

}  // namespace lapilli
