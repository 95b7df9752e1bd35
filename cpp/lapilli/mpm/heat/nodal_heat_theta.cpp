#include "lapilli/mpm/heat/nodal_heat.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lapilli/core/require.hpp"

namespace lapilli {

template <int Dim>
void NodalHeat<Dim>::book_laws(std::vector<double>& given, const LawRates& heat) {
  std::vector<int> laws_left(given.size(), 0);
  for (const auto& n : laws_.nodes()) {
    for (const Index place : n.node) {
      ++laws_left[place];
    }
  }
  for (std::size_t law = 0; law < laws_.nodes().size(); ++law) {
    const auto& n = laws_.nodes()[law];
    double sum = 0.0;
    for (std::size_t k = 0; k < n.node.size(); ++k) {
      const Index place = n.node[k];
      const double part = --laws_left[place] == 0 ? given[place] : heat[law][k];
      given[place] -= part;
      sum += part;
    }
    laws_.book(law, sum);
  }
}

template <int Dim>
StepReport NodalHeat<Dim>::advance_implicitly(const Step& step) {
  // The two steps after the start and after every jump of a table are taken as backward Euler
  // halves, which share the matrix of a Crank-Nicolson step and damp what it excites (Rannacher
  // 1984).
  const double theta = problem_.settings.theta;
  const bool damped =
      theta < 1.0 &&
      (step.index < 2 || in_time_.jumps_within(step.time - step.size, step.time + step.size));
  const int parts = damped ? 2 : 1;
  const double size = step.size / parts, weight = damped ? 1.0 : theta;
  const bool linear = laws_.is_linear() && !(source_ && source_->depends_on_state());
  const int iterations_allowed = linear ? 1 : 30;
  StepReport report{step.size, 0, 0.0};
  std::vector<double> residual(temperature_.size()), known(temperature_.size());
  std::vector<double> trial(temperature_.size()), middle(temperature_.size());
  std::vector<double> sources(temperature_.size());
  for (int part = 0; part < parts; ++part) {
    const double begin = step.time + part * size, end = begin + size;
    // What the start of the step contributes, sources apart.
    std::fill(known.begin(), known.end(), 0.0);
    std::fill(sources.begin(), sources.end(), 0.0);
    const auto add_laws = [&](double factor, std::span<double> to) {
      laws_.evaluate(trial, begin, end);
      for (const auto& n : laws_.nodes()) {
        for (std::size_t k = 0; k < n.node.size(); ++k) {
          to[n.node[k]] += factor * n.rate[k];
        }
      }
    };
    const auto add_sources = [&](double factor, std::span<double> to) {
      if (source_) {
        source_->for_each(trial, begin, end,
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
    LawRates of_laws;  // J over the step
    for (const auto& n : laws_.nodes()) {
      of_laws.emplace_back(n.node.size(), 0.0);
    }
    const auto add_rates = [&](double factor) {
      for (std::size_t law = 0; law < of_laws.size(); ++law) {
        for (std::size_t k = 0; k < of_laws[law].size(); ++k) {
          of_laws[law][k] += factor * laws_.nodes()[law].rate[k];
        }
      }
    };
    trial = temperature_;
    if (weight < 1.0) {
      add_laws((1.0 - weight) * size, known);
      add_rates((1.0 - weight) * size);
      add_sources((1.0 - weight) * size, sources);
    }
    double scale = 0.0, change = 0.0;
    for (int iteration = 0; iteration < iterations_allowed; ++iteration) {
      // residual = dt (-K (T + theta d) + (1 - theta) rate(T) + theta rate(T + d)) - C d
      residual = known;
      add_laws(weight * size, residual);
      for (std::size_t place = 0; place < trial.size(); ++place) {
        residual[place] += sources[place];
      }
      add_sources(weight * size, residual);
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
    add_sources(weight * size, sources);
    // A law gave its nodes what they took up beyond conduction and sources: exact where a stiff law
    // leaves a small difference of large rates. Where laws share a node, each gave by its rate and
    // the last one the rest.
    balance([&](Index place, double heat) { residual[place] = heat - sources[place]; });
    laws_.evaluate(trial, begin, end);
    add_rates(weight * size);
    book_laws(residual, of_laws);
    if (source_) {
      source_->book(std::accumulate(sources.begin(), sources.end(), 0.0));
    }
    temperature_ = trial;
  }
  return report;
}

#define LAPILLI_INSTANTIATE(Dim)                                                  \
  template void NodalHeat<Dim>::book_laws(std::vector<double>&, const LawRates&); \
  template StepReport NodalHeat<Dim>::advance_implicitly(const Step& step);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
