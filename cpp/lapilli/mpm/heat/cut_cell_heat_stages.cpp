#include <algorithm>
#include <cmath>

#include "lapilli/mpm/heat/chebyshev_stages.hpp"
#include "lapilli/mpm/heat/cut_cell_heat.hpp"
#include "lapilli/mpm/heat/cut_cell_heat_attempt.hpp"
#include "lapilli/mpm/heat/part_sources.hpp"

namespace lapilli {
namespace {

/// Enter the embedded estimate of the error of a step, from the rates at its ends; returns what
/// nodes stored in it, J.
template <class Attempt>
double estimate_error(std::span<const double> capacity, std::span<const double> start,
                      std::span<const double> first, double size, Attempt& attempt) {
  double stored = 0.0;
  attempt.nodal_error.assign(start.size(), 0.0);
  for (std::size_t place = 0; place < start.size(); ++place) {
    if (capacity[place] > 0.0) {
      const double rise = attempt.nodal[place] - start[place];
      const double rates = first[place] + attempt.rates.rise[place];
      const double local = 0.4 * size * rates - 0.8 * rise;
      stored += capacity[place] * rise;
      attempt.nodal_error[place] = local;
      attempt.local = std::max(attempt.local, std::abs(local));
    }
  }
  return stored;
}

}  // namespace

template <int Dim>
double CutCellHeat<Dim>::rate_of_stages() const {
  // Where the surface is much faster than the body, or sources answer, implicit steps are better.
  constexpr double most = 100.0;
  // A law that is not linear has steeper tangents than its slope, by 4 at most under radiation.
  constexpr double steeper = 4.0;
  const double conduction = 2.0 / limit_.hard;
  double fastest = conduction;
  for (const Solved& one : solved_) {
    double sum = conduction;
    for (std::size_t law = 0; law < laws_.size(); ++law) {
      const double slope = one.near.surface.steepest(law) * one.exchange_rate[law];
      sum += lapilli::is_linear(laws_[law]) ? slope : steeper * slope;
    }
    fastest = std::max(fastest, sum);
  }
  const bool answers = std::ranges::any_of(
      problem_.bodies, [](const HeatBody& body) { return body.source.is_function(); });
  return answers || !(fastest <= most * conduction) ? 0.0 : fastest;
}

template <int Dim>
typename CutCellHeat<Dim>::HeatRates CutCellHeat<Dim>::find_rates(
    Solved& one, std::span<const double> temperature, double time) {
  HeatRates found{std::vector<double>(temperature.size()), std::vector<double>(laws_.size()), 0.0};
  const double* inverse = one.inverse.data();
  double* rate = found.rise.data();
  one.part.conduction->multiply(temperature.data(), [=](Index place, const auto& product) {
    for (std::size_t k = 0; k < product.size(); ++k) {
      rate[place + k] = -inverse[place + k] * product[k];
    }
  });
  for (const WeakExchange& weak : one.weak) {
    const double ambient = laws_.uniform(weak.law, 0.0, {}, time, time).ambient;
    double sum = 0.0;
    for (std::size_t k = 0; k < weak.place.size(); ++k) {
      const Index place = weak.place[k];
      const double given = weak.coefficient * weak.area[k] * (ambient - temperature[place]);
      rate[place] += given * inverse[place];
      sum += given;
    }
    found.by_law[weak.law] = sum;
  }
  one.part.followers.hand_on(found.rise, one.inverse);
  if (!one.part.sources.empty()) {
    const SourceRates given = source_rates(one.part, problem_.bodies, temperature, time, time);
    for (std::size_t place = 0; place < found.rise.size(); ++place) {
      if (const double capacity = one.part.capacity[place]; capacity > 0.0) {
        rate[place] += given.power[place] / capacity;
        found.by_sources += given.power[place];
      }
    }
  }
  SurfaceTerm& surface = one.near.surface;
  if (!surface.empty()) {
    const auto& unknown = one.near.unknown_place;
    SurfaceTerm::Vector there(static_cast<Eigen::Index>(unknown.size()));
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      there[static_cast<Eigen::Index>(k)] = temperature[unknown[k]];
    }
    surface.evaluate(laws_, there, time, time);
    const SurfaceTerm::Vector none = SurfaceTerm::Vector::Zero(there.size());
    for (std::size_t k = 0; k < unknown.size(); ++k) {
      rate[unknown[k]] += surface.force()[static_cast<Eigen::Index>(k)] * inverse[unknown[k]];
    }
    for (std::size_t law = 0; law < laws_.size(); ++law) {
      found.by_law[law] += surface.heat(law, none);
    }
  }
  one.part.followers.prolong(found.rise);
  return found;
}

template <int Dim>
bool CutCellHeat<Dim>::try_stages(Solved& one, double begin, double size, Attempt& attempt) {
  const ChebyshevStages stages(adaptive_.stages(size));
  const std::vector<double>& start = one.part.temperature;
  const auto count = static_cast<Index>(start.size());
  // Steps end at the entries of tables, which are asked just inside of the step.
  const double last = begin + (1.0 - 1e-6) * size;
  if (one.rates.rise.empty()) {
    one.rates = find_rates(one, start, begin);
  }
  const HeatRates& first = one.rates;
  // What laws and sources give goes the way of the temperatures, J.
  std::vector<double> given_before(laws_.size() + 1, 0.0), given = given_before;
  const auto powers = [](const HeatRates& rates) {
    std::vector<double> all = rates.by_law;
    all.push_back(rates.by_sources);
    return all;
  };
  const std::vector<double> first_powers = powers(first);
  std::vector<double> before = start, now(start.size());
  const double of_first = stages.first() * size;
  parallel_for(
      count, [&](Index k) { now[k] = start[k] + of_first * first.rise[k]; }, Work::light);
  for (std::size_t k = 0; k < given.size(); ++k) {
    given[k] = of_first * first_powers[k];
  }
  double at = stages.first();
  for (const ChebyshevStages::Stage& stage : stages.later()) {
    const HeatRates there = find_rates(one, now, std::min(begin + at * size, last));
    const double of_start = 1.0 - stage.mu - stage.nu;
    const auto next = [&](double from, double here, double earlier, double rate, double at_first) {
      return of_start * from + stage.mu * here + stage.nu * earlier +
             size * (stage.rate * rate + stage.start * at_first);
    };
    parallel_for(
        count,
        [&](Index k) {
          before[k] = next(start[k], now[k], before[k], there.rise[k], first.rise[k]);
        },
        Work::light);
    before.swap(now);
    const std::vector<double> there_powers = powers(there);
    for (std::size_t k = 0; k < given.size(); ++k) {
      given_before[k] = next(0.0, given[k], given_before[k], there_powers[k], first_powers[k]);
    }
    given.swap(given_before);
    at = stage.at;
  }
  attempt.rates = find_rates(one, now, last);
  attempt.nodal = std::move(now);
  attempt.of_sources = given.back();
  given.pop_back();
  attempt.of_laws = std::move(given);
  const double stored = estimate_error(one.part.capacity, start, first.rise, size, attempt);
  attempt.given = stored - attempt.of_sources;
  return std::isfinite(attempt.local) && std::isfinite(stored);
}

template <int Dim>
void CutCellHeat<Dim>::commit_stages(double size, std::vector<Attempt>& attempts) {
  double bend = 0.0;
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    const Solved& one = solved_[k];
    for (std::size_t place = 0; place < one.rates.rise.size(); ++place) {
      if (one.part.capacity[place] > 0.0) {
        bend = std::max(bend, std::abs(attempts[k].rates.rise[place] - one.rates.rise[place]));
      }
    }
  }
  bend /= size;
  // What errors there are decays as what bends the temperatures.
  const double left = bend_ > 0.0 ? std::min(1.0, bend / bend_) : 1.0;
  bend_ = bend;
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    Solved& one = solved_[k];
    Attempt& attempt = attempts[k];
    one.part.temperature.swap(attempt.nodal);
    one.rates = std::move(attempt.rates);
    if (keep_in_range(one)) {
      one.rates = {};
    }
    for (std::size_t place = 0; place < one.error.size(); ++place) {
      one.error[place] = left * one.error[place];
      one.error[place] += calming_ > 0 ? 0.0 : attempt.nodal_error[place];
    }
    source_ += attempt.of_sources;
    laws_.account().book(attempt.of_laws, attempt.given);
  }
}

template <int Dim>
void CutCellHeat<Dim>::begin_stages() {
  bend_ = 0.0;
  calming_ = 4;
  for (Solved& one : solved_) {
    one.error.assign(one.part.capacity.size(), 0.0);
    for (std::size_t place = 0; place < one.error.size(); ++place) {
      one.error[place] = one.part.capacity[place] > 0.0 ? explicit_error_ : 0.0;
    }
    one.rates = {};
  }
}

#define LAPILLI_INSTANTIATE(Dim)                                                 \
  template double CutCellHeat<Dim>::rate_of_stages() const;                      \
  template typename CutCellHeat<Dim>::HeatRates CutCellHeat<Dim>::find_rates(    \
      Solved&, std::span<const double>, double);                                 \
  template bool CutCellHeat<Dim>::try_stages(Solved&, double, double, Attempt&); \
  template void CutCellHeat<Dim>::commit_stages(double, std::vector<Attempt>&);  \
  template void CutCellHeat<Dim>::begin_stages();
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
