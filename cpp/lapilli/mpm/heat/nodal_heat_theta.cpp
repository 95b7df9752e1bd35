#include "lapilli/mpm/heat/nodal_heat.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lapilli/mpm/heat/theta_steps.hpp"

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

/// One step of the theta scheme: C d = dt (-K (T + theta d) + (1 - theta) rate(T) + theta rate(T +
/// d)) with d the rise of the temperatures T.
template <int Dim>
class NodalHeat<Dim>::ThetaStep {
 public:
  ThetaStep(NodalHeat& heat, double begin, double size, double theta)
      : heat_(heat),
        begin_(begin),
        end_(begin + size),
        size_(size),
        theta_(theta),
        trial_(heat.temperature_),
        known_(trial_.size(), 0.0),
        sources_(known_),
        residual_(known_),
        middle_(known_) {
    for (const auto& n : heat.laws_.nodes()) {
      of_laws_.emplace_back(n.node.size(), 0.0);
    }
  }

  void take(StepReport& report) {
    if (theta_ < 1.0) {
      add_laws((1.0 - theta_) * size_, known_);
      add_rates((1.0 - theta_) * size_);
      add_sources((1.0 - theta_) * size_, sources_);
    }
    solve(report);
    add_sources(theta_ * size_, sources_);
    book();
    heat_.temperature_ = trial_;
  }

 private:
  void add_laws(double factor, std::span<double> to) {
    heat_.laws_.evaluate(trial_, begin_, end_);
    for (const auto& n : heat_.laws_.nodes()) {
      for (std::size_t k = 0; k < n.node.size(); ++k) {
        to[n.node[k]] += factor * n.rate[k];
      }
    }
  }

  void add_sources(double factor, std::span<double> to) {
    if (heat_.source_) {
      heat_.source_->for_each(trial_, begin_, end_,
                              [&](Index place, double rate) { to[place] += factor * rate; });
    }
  }

  /// The rates that laws had last, to the heat that each gave.
  void add_rates(double factor) {
    for (std::size_t law = 0; law < of_laws_.size(); ++law) {
      for (std::size_t k = 0; k < of_laws_[law].size(); ++k) {
        of_laws_[law][k] += factor * heat_.laws_.nodes()[law].rate[k];
      }
    }
  }

  /// Call body(place, C d + dt K (T + theta d)): the heat that a node took up and handed on.
  template <class Body>
  void for_each_balance(const Body& body) {
    const std::vector<double>& start = heat_.temperature_;
    for (std::size_t place = 0; place < trial_.size(); ++place) {
      middle_[place] = start[place] + theta_ * (trial_[place] - start[place]);
    }
    heat_.conduction_->multiply(middle_.data(), [&](Index place, int count, const auto& product) {
      for (int k = 0; k < count; ++k) {
        const Index at = place + k;
        body(at, heat_.lumped_[at] * (trial_[at] - start[at]) + size_ * product[k]);
      }
    });
  }

  void find_residual() {
    residual_ = known_;
    add_laws(theta_ * size_, residual_);
    for (std::size_t place = 0; place < trial_.size(); ++place) {
      residual_[place] += sources_[place];
    }
    add_sources(theta_ * size_, residual_);
    for_each_balance([&](Index place, double heat) { residual_[place] -= heat; });
  }

  void solve(StepReport& report) {
    const bool linear =
        heat_.laws_.is_linear() && !(heat_.source_ && heat_.source_->depends_on_state());
    double scale = 0.0, change = 0.0;
    for (int iteration = 0; iteration < (linear ? 1 : theta_iterations); ++iteration) {
      find_residual();
      heat_.theta_->prepare(theta_ * size_, heat_.laws_);
      heat_.theta_->solve(residual_, heat_.increment_);
      change = scale = 0.0;
      for (std::size_t place = 0; place < trial_.size(); ++place) {
        trial_[place] += heat_.increment_[place];
        change = std::max(change, std::abs(heat_.increment_[place]));
        scale = std::max(scale, std::abs(trial_[place]));
      }
      ++report.iterations;
      if (change <= 1e-13 * scale) {
        break;
      }
    }
    change = linear ? 0.0 : change;  // one solve is the answer
    report.residual = std::max(report.residual, converged_share(change, scale));
  }

  /// A law gave its nodes what they took up beyond conduction and sources: exact where a stiff law
  /// leaves a small difference of large rates. Where laws share a node, each gave by its rate and
  /// the last one the rest.
  void book() {
    for_each_balance([&](Index place, double heat) { residual_[place] = heat - sources_[place]; });
    heat_.laws_.evaluate(trial_, begin_, end_);
    add_rates(theta_ * size_);
    heat_.book_laws(residual_, of_laws_);
    if (heat_.source_) {
      heat_.source_->book(std::accumulate(sources_.begin(), sources_.end(), 0.0));
    }
  }

  NodalHeat& heat_;
  double begin_, end_, size_, theta_;
  std::vector<double> trial_;
  std::vector<double> known_;    // J, what laws gave at the start of the step
  std::vector<double> sources_;  // J
  std::vector<double> residual_, middle_;
  LawRates of_laws_;  // J over the step
};

template <int Dim>
StepReport NodalHeat<Dim>::advance_implicitly(const Step& step) {
  const double theta = problem_.settings.theta;
  const bool damped = is_damped(theta, step, in_time_);
  const int parts = damped ? 2 : 1;
  const double size = step.size / parts;
  StepReport report{step.size, 0, 0.0};
  for (int part = 0; part < parts; ++part) {
    ThetaStep(*this, step.time + part * size, size, damped ? 1.0 : theta).take(report);
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
