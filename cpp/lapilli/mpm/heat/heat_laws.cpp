#include "lapilli/mpm/heat/heat_laws.hpp"

#include <algorithm>
#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/weights.hpp"

namespace lapilli {
namespace {

bool is_held(const HeatBoundary& law) { return std::holds_alternative<PrescribedTemperature>(law); }

}  // namespace

const Shape* region_of(const HeatBoundary& law) {
  return std::visit([](const auto& l) { return l.region ? &*l.region : nullptr; }, law);
}

std::string name_of_law(const HeatBoundary& law, std::size_t index) {
  return std::visit(
      [&](const auto& l) { return l.name.empty() ? message(l.kind, " ", index + 1) : l.name; },
      law);
}

template <int Dim>
void HeatLaws<Dim>::Account::add(double value) {
  const double total = sum + value;
  dropped += std::abs(sum) >= std::abs(value) ? (sum - total) + value : (value - total) + sum;
  sum = total;
}

template <int Dim>
HeatLaws<Dim>::HeatLaws(const std::vector<HeatBoundary>& laws, double absolute_zero)
    : laws_(laws), nodes_(laws.size()), account_(laws.size()), zero_(absolute_zero) {
  for (const HeatBoundary& law : laws_) {
    if (const Shape* region = region_of(law)) {
      check(*region, Dim);
    }
  }
}

template <int Dim>
bool HeatLaws<Dim>::has_held_temperature() const {
  return std::any_of(laws_.begin(), laws_.end(), is_held);
}

template <int Dim>
bool HeatLaws<Dim>::has_radiation() const {
  return std::any_of(laws_.begin(), laws_.end(), [](const HeatBoundary& law) {
    return std::holds_alternative<Radiation>(law);
  });
}

template <int Dim>
bool HeatLaws<Dim>::is_linear() const {
  return std::none_of(laws_.begin(), laws_.end(), [](const HeatBoundary& law) {
    const auto* flux = std::get_if<PrescribedFlux>(&law);
    const auto* convection = std::get_if<Convection>(&law);
    return std::holds_alternative<Radiation>(law) ||
           (flux != nullptr && flux->value.is_function()) ||
           (convection != nullptr && convection->coefficient.is_function());
  });
}

template <int Dim>
bool HeatLaws<Dim>::has_constant_slope() const {
  return is_linear() && std::all_of(laws_.begin(), laws_.end(), [](const HeatBoundary& law) {
           const auto* convection = std::get_if<Convection>(&law);
           return convection == nullptr || convection->coefficient.is_constant();
         });
}

template <int Dim>
void HeatLaws<Dim>::assign(const Grid<Dim>& grid, const NodalAreas<Dim>& areas,
                           const std::function<std::vector<SurfacePlace<Dim>>()>& places) {
  for (Nodes& nodes : nodes_) {
    nodes.node.clear();
    nodes.area.clear();
    nodes.normal.clear();
    nodes.position.clear();
  }
  std::vector<const Shape*> regions;
  for (const HeatBoundary& law : laws_) {
    regions.push_back(region_of(law));
  }
  const auto parts = divide_surface<Dim>(grid, areas, places, regions);
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    // Only a flux that does not depend on the temperature may act on negative areas.
    const auto* flux = std::get_if<PrescribedFlux>(&laws_[law]);
    const bool is_signed = flux != nullptr && !flux->value.is_function();
    for (const SurfacePart<Dim>& part : parts[law]) {
      const double area = part.share * (is_signed ? areas.area : areas.positive)[part.row];
      if (area != 0.0) {
        nodes_[law].node.push_back(areas.node[part.row]);
        nodes_[law].area.push_back(area);
        nodes_[law].normal.push_back(areas.normal[part.row]);
        nodes_[law].position.push_back(areas.position[part.row]);
      }
    }
  }
  for (Nodes& nodes : nodes_) {
    nodes.state.resize(nodes.node.size());
    nodes.rate.resize(nodes.node.size());
    nodes.slope.resize(nodes.node.size());
  }
}

template <int Dim>
void HeatLaws<Dim>::place_probes(
    const Grid<Dim>& grid, const std::function<bool(Index)>& is_active,
    const std::function<double(Index, const Vec<Dim>&)>& conductivity) {
  constexpr int corners = 1 << Dim;
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    if (!is_held(laws_[law])) {
      continue;
    }
    Nodes& nodes = nodes_[law];
    nodes.conductance.resize(nodes.node.size());
    nodes.probe.resize(nodes.node.size() * corners);
    for (std::size_t k = 0; k < nodes.node.size(); ++k) {
      const double depth = grid.cell_size();
      const Vec<Dim> probe = nodes.position[k].template head<Dim>() - depth * nodes.normal[k];
      const LinearShape shape;
      const Weights<Dim, LinearShape> weights(grid, shape, probe.data());
      std::size_t corner = k * corners;
      double sum = 0.0;
      weights.for_each_node(grid, [&](Index node, double value, const Vec<Dim>&) {
        const double weight = is_active(node) ? value : 0.0;
        nodes.probe[corner++] = {weight > 0.0 ? node : nodes.node[k], weight};
        sum += weight;
      });
      for (std::size_t c = k * corners; c < (k + 1) * corners; ++c) {
        nodes.probe[c].second = sum > 0.0 ? nodes.probe[c].second / sum : 1.0 / corners;
      }
      nodes.conductance[k] = conductivity(nodes.node[k], nodes.normal[k]) / depth;
    }
  }
}

template <int Dim>
void HeatLaws<Dim>::require_all_used() const {
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    require(!nodes_[law].node.empty(), "heat.boundaries.", law, " (", name_of_law(laws_[law], law),
            ") selects no surface: ",
            region_of(laws_[law]) != nullptr ? "its region covers none that an earlier law left"
                                             : "earlier laws took all of it");
  }
}

template <int Dim>
void HeatLaws<Dim>::read_states(std::size_t law, std::span<const double> temperature) {
  constexpr std::size_t corners = 1 << Dim;
  Nodes& n = nodes_[law];
  const bool held = is_held(laws_[law]);
  for (std::size_t k = 0; k < n.node.size(); ++k) {
    if (!held) {
      n.state[k] = temperature[n.node[k]];
      continue;
    }
    n.state[k] = 0.0;
    for (std::size_t c = k * corners; c < (k + 1) * corners; ++c) {
      n.state[k] += n.probe[c].second * temperature[n.probe[c].first];
    }
  }
}

template <int Dim>
void HeatLaws<Dim>::fill(const Value& value, const Nodes& nodes,
                         std::vector<double>& values) const {
  value.evaluate_mean(nodes.position, nodes.state, begin_, end_, values);
}

template <int Dim>
void HeatLaws<Dim>::fill_ambient(const Value& coefficient, const Value& ambient, int power,
                                 const Nodes& nodes, std::vector<double>& values) const {
  if (ambient.is_function() || ambient.is_constant()) {
    fill(ambient, nodes, values);
    return;
  }
  const double share = coefficient.is_function() ? 1.0 : coefficient.mean(begin_, end_);
  const double mean = mean_of_product({&coefficient, &ambient}, begin_, end_, [&](double time) {
    const double factor = coefficient.is_function() ? 1.0 : coefficient.at(time);
    return factor * std::pow(ambient.at(time) - zero_, power);
  });
  const double absolute = share > 0.0 ? mean / share : 0.0;
  std::fill(values.begin(), values.end(), zero_ + std::pow(std::max(absolute, 0.0), 1.0 / power));
}

template <int Dim>
void HeatLaws<Dim>::evaluate(std::span<const double> temperature, double time) {
  secant_ = false;
  evaluate_between(temperature, time, time);
}

template <int Dim>
void HeatLaws<Dim>::evaluate_over(std::span<const double> temperature, double begin, double end) {
  secant_ = true;
  evaluate_between(temperature, begin, end);
}

template <int Dim>
void HeatLaws<Dim>::evaluate_between(std::span<const double> temperature, double begin,
                                     double end) {
  begin_ = begin;
  end_ = end;
  const bool absolute = has_radiation();
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    read_states(law, temperature);
    Nodes& n = nodes_[law];
    first_.resize(n.node.size());
    second_.resize(n.node.size());
    if (const auto* flux = std::get_if<PrescribedFlux>(&laws_[law])) {
      evaluate_flux(*flux, n);
    } else if (const auto* convection = std::get_if<Convection>(&laws_[law])) {
      evaluate_convection(*convection, n);
    } else if (const auto* radiation = std::get_if<Radiation>(&laws_[law])) {
      evaluate_radiation(*radiation, n);
    } else {
      fill(std::get<PrescribedTemperature>(laws_[law]).value, n, second_);
      evaluate_held(n);
    }
    if (absolute && !std::holds_alternative<PrescribedFlux>(laws_[law])) {
      require_absolute(law, second_);
    }
  }
}

template <int Dim>
void HeatLaws<Dim>::evaluate_flux(const PrescribedFlux& law, Nodes& n) {
  fill(law.value, n, first_);
  std::fill(n.slope.begin(), n.slope.end(), 0.0);
  if (law.value.is_function()) {
    // The slope of a function, by a difference: a flux that falls with the temperature is taken at
    // the end of the step like convection.
    double span = 1.0;
    for (const double state : n.state) {
      span = std::max(span, std::abs(state));
    }
    const double rise = 1e-6 * span;
    std::vector<double> warmer(n.state);
    for (double& state : warmer) {
      state += rise;
    }
    law.value.evaluate_mean(n.position, warmer, begin_, end_, second_);
    for (std::size_t k = 0; k < n.slope.size(); ++k) {
      n.slope[k] = n.area[k] * std::max(0.0, (first_[k] - second_[k]) / rise);
    }
  }
  for (std::size_t k = 0; k < n.rate.size(); ++k) {
    n.rate[k] = n.area[k] * first_[k];
  }
}

template <int Dim>
void HeatLaws<Dim>::evaluate_convection(const Convection& law, Nodes& n) {
  fill(law.coefficient, n, first_);
  fill_ambient(law.coefficient, law.ambient, 1, n, second_);
  for (std::size_t k = 0; k < n.rate.size(); ++k) {
    n.slope[k] = n.area[k] * first_[k];
    n.rate[k] = n.slope[k] * (second_[k] - n.state[k]);
  }
}

template <int Dim>
void HeatLaws<Dim>::evaluate_radiation(const Radiation& law, Nodes& n) {
  fill(law.emissivity, n, first_);
  fill_ambient(law.emissivity, law.ambient, 4, n, second_);
  for (std::size_t k = 0; k < n.rate.size(); ++k) {
    const double factor = n.area[k] * first_[k] * law.stefan_boltzmann;
    const double own = std::max(n.state[k] - zero_, 0.0), far = second_[k] - zero_;
    const double secant = factor * (far * far + own * own) * (far + own);
    n.rate[k] = secant * (far - own);
    n.slope[k] = secant_ ? secant : 4.0 * factor * own * own * own;
  }
}

template <int Dim>
void HeatLaws<Dim>::evaluate_held(Nodes& n) {
  constexpr std::size_t corners = 1 << Dim;
  for (std::size_t k = 0; k < n.rate.size(); ++k) {
    n.slope[k] = 0.0;
    const double conductance = n.area[k] * n.conductance[k];
    for (std::size_t c = k * corners; c < (k + 1) * corners; ++c) {
      n.slope[k] += n.probe[c].first == n.node[k] ? conductance * n.probe[c].second : 0.0;
    }
    n.rate[k] = conductance * (second_[k] - n.state[k]);
  }
}

template <int Dim>
void HeatLaws<Dim>::require_absolute(std::size_t law, std::span<const double> values) const {
  for (const double value : values) {
    if (value < zero_) {
      throw RunError(message("heat: ", name_of_law(laws_[law], law), " gave ", value,
                             ", below absolute zero at ", zero_,
                             ": temperatures under radiation are absolute"));
    }
  }
}

template <int Dim>
std::vector<NodeCoupling> HeatLaws<Dim>::couplings() const {
  constexpr std::size_t corners = 1 << Dim;
  std::vector<NodeCoupling> all;
  for (const Nodes& nodes : nodes_) {
    for (std::size_t k = 0; k < nodes.conductance.size(); ++k) {
      for (std::size_t c = k * corners; c < (k + 1) * corners; ++c) {
        if (nodes.probe[c].first != nodes.node[k]) {
          all.push_back({nodes.node[k], nodes.probe[c].first,
                         nodes.area[k] * nodes.conductance[k] * nodes.probe[c].second});
        }
      }
    }
  }
  return all;
}

template <int Dim>
SurfaceView HeatLaws<Dim>::surface() const {
  SurfaceView view;
  view.dimension = Dim;
  for (const Nodes& nodes : nodes_) {
    view.append(nodes);
  }
  return view;
}

template <int Dim>
std::vector<Ledger::Entry> HeatLaws<Dim>::entries() const {
  std::vector<Ledger::Entry> all;
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    all.push_back({name_of_law(laws_[law], law), account_[law].sum + account_[law].dropped});
  }
  return all;
}

template <int Dim>
void HeatLaws<Dim>::save(Archive& archive, const std::string& name) const {
  std::vector<double> sums;
  for (const Account& account : account_) {
    sums.push_back(account.sum);
    sums.push_back(account.dropped);
  }
  archive.write(name, std::span<const double>(sums));
}

template <int Dim>
void HeatLaws<Dim>::load(const Archive& archive, const std::string& name) {
  std::vector<double> sums(2 * account_.size());
  archive.read(name, std::span<double>(sums));
  for (std::size_t law = 0; law < account_.size(); ++law) {
    account_[law] = {sums[2 * law], sums[2 * law + 1]};
  }
}

template class HeatLaws<1>;
template class HeatLaws<2>;
template class HeatLaws<3>;

}  // namespace lapilli
