#include <algorithm>
#include <cmath>
#include <iterator>

#include "lapilli/core/pair_entries.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/bridged_gaps.hpp"
#include "lapilli/mpm/heat/enthalpy_heat.hpp"
#include "lapilli/mpm/heat/strong_ends.hpp"
#include "lapilli/mpm/heat/surface_warnings.hpp"
#include "lapilli/mpm/surface/cut_shape.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {

template <int Dim>
void EnthalpyHeat<Dim>::refresh_output() {
  if (!output_temperature_) {
    output_temperature_ = std::make_unique<PointArray>(points_, 1);
    output_flux_ = std::make_unique<PointArray>(points_, Dim);
    if (melts_) {
      output_liquid_ = std::make_unique<PointArray>(points_, 1);
    }
  }
  with_shape(problem_.shape, resting_half_width, [&](auto shape) {
    parallel_for(points_.size(), [&](Index row) {
      const auto body = static_cast<std::size_t>(points_.body()[row]);
      const Thermal& material = problem_.bodies[body].material;
      const Solved& one = solved_[part_of_[body]];
      const Weights<Dim, decltype(shape)> weights(problem_.grid, shape,
                                                  points_.position().data() + row * Dim);
      double value = 0.0, liquid = 0.0;
      Vec<Dim> gradient = Vec<Dim>::Zero();
      weights.for_each_node(problem_.grid, [&](Index node, double s, const Vec<Dim>& slope) {
        if (s > 0.0) {
          const Index place = one.part.rows->place(node);
          const double nodal = one.part.temperature[place];
          value += s * nodal;
          gradient += nodal * slope;
          if (material.melts()) {
            liquid += s * liquid_at(one, number_in_part_[body], place);
          }
        }
      });
      value = std::clamp(value, range_.low, range_.high);
      (*output_temperature_)[row] = value;
      const TemperatureTable* table = material.conductivity.table();
      const double share = table ? table->at(value) / table->largest() : 1.0;
      Eigen::Map<Vec<Dim>>(output_flux_->data() + row * Dim) =
          -share * (coefficients_.conductivity[body] * gradient);
      if (melts_) {
        (*output_liquid_)[row] = liquid;
      }
    });
  });
}

template <int Dim>
double EnthalpyHeat<Dim>::liquid_at(const Solved& one, std::size_t body, Index place) const {
  if (!one.part.followers.follows(place)) {
    return one.enthalpy.leads(place)
               ? one.enthalpy.liquid_fraction(body, place, one.part.temperature[place],
                                              one.stored[place])
               : 0.0;
  }
  double sum = 0.0;
  for (const auto& leader : one.part.followers.leaders(place)) {
    sum += leader.weight * one.enthalpy.liquid_fraction(body, leader.place,
                                                        one.part.temperature[leader.place],
                                                        one.stored[leader.place]);
  }
  return std::clamp(sum, 0.0, 1.0);
}

template <int Dim>
std::vector<Field> EnthalpyHeat<Dim>::fields() {
  if (!output_temperature_) {
    refresh_output();
  }
  std::vector<Field> all = {{"temperature", "K", 1, output_temperature_->values()},
                            {"heat_flux", "W/m^2", Dim, output_flux_->values()}};
  if (melts_) {
    all.push_back({"liquid_fraction", "", 1, output_liquid_->values()});
  }
  return all;
}

template <int Dim>
std::vector<Balance> EnthalpyHeat<Dim>::balances() const {
  Balance balance{"heat", "J", initial_, 0.0, laws_.entries(), 0.0};
  balance.entries.resize(outer_laws());
  double low = std::numeric_limits<double>::infinity(), high = -low, total = 0.0;
  for (const Solved& one : solved_) {
    for (std::size_t place = 0; place < one.stored.size(); ++place) {
      if (one.enthalpy.leads(static_cast<Index>(place))) {
        balance.stored += one.stored[place];
        total += one.part.capacity[place];
        low = std::min(low, one.part.temperature[place]);
        high = std::max(high, one.part.temperature[place]);
      }
    }
  }
  balance.scale = total > 0.0 ? total * (high - low) : 0.0;
  balance.bar = 1e-6;
  if (has_sources_) {
    balance.entries.push_back({"source", source_});
  }
  return {balance};
}

template <int Dim>
std::vector<std::pair<std::string, double>> EnthalpyHeat<Dim>::diagnostics() const {
  double area = 0.0, free = 0.0, liquid = 0.0;
  for (std::size_t law = 0; law < outer_laws(); ++law) {
    for (const double a : surface_.sites(law).area) {
      area += a;
    }
  }
  for (const SurfaceFound& body : found_) {
    free += body.area;
  }
  double stray = 0.0;
  for (const Solved& one : solved_) {
    stray = std::max(stray, one.range.stray(one.part.temperature, range_));
  }
  std::vector<std::pair<std::string, double>> all = {
      {"surface_area", area}, {"free_surface_area", free}, {"nodal_stray", stray}};
  if (melts_) {
    for (const Solved& one : solved_) {
      liquid += one.enthalpy.liquid_volume(one.part.temperature, one.stored);
    }
    all.emplace_back("liquid_volume", liquid);
  }
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    const auto name = [&](std::size_t body) {
      return name_or_number(problem_.bodies[body].name, body);
    };
    all.emplace_back(
        message("heat from ", name(contacts_[k].first), " to ", name(contacts_[k].second)),
        through_contact_[k]);
  }
  return all;
}

template <int Dim>
SurfaceView EnthalpyHeat<Dim>::surface() const {
  SurfaceView view;
  view.dimension = Dim;
  for (std::size_t law = 0; law < outer_laws(); ++law) {
    view.append(surface_.sites(law));
  }
  return view;
}

template <int Dim>
std::vector<Note> EnthalpyHeat<Dim>::warnings() const {
  std::vector<Note> all = surface_warnings<Dim>(found_, problem_, laws_.account(), 0.0, time_);
  std::ranges::copy(steps_between(found_, problem_.settings), std::back_inserter(all));
  for (const Solved& one : solved_) {
    std::ranges::copy(bridged_gaps(problem_, one.part), std::back_inserter(all));
  }
  return all;
}

template <int Dim>
void EnthalpyHeat<Dim>::save(Archive& archive) const {
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    archive.write(message("heat/temperature ", k), solved_[k].part.temperature);
    archive.write(message("heat/stored ", k), solved_[k].stored);
  }
  solver_.save(archive, "heat/solver");
  archive.write("heat/through_contact", through_contact_);
  archive.write("heat/initial", initial_);
  archive.write("heat/source", source_);
  archive.write("heat/self_heating", self_heating_.rate());
  archive.write("heat/time", time_);
  laws_.account().save(archive, "heat/laws");
}

template <int Dim>
void EnthalpyHeat<Dim>::load(const Archive& archive) {
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    Solved& one = solved_[k];
    archive.read(message("heat/temperature ", k), std::span<double>(one.part.temperature));
    archive.read(message("heat/stored ", k), std::span<double>(one.stored));
  }
  solver_.load(archive, "heat/solver");
  archive.read("heat/through_contact", std::span<double>(through_contact_));
  initial_ = archive.read_number("heat/initial");
  source_ = archive.read_number("heat/source");
  self_heating_.set_rate(archive.read_number("heat/self_heating"));
  time_ = archive.read_number("heat/time");
  laws_.account().load(archive, "heat/laws");
}

#define LAPILLI_INSTANTIATE(Dim)                                                               \
  template void EnthalpyHeat<Dim>::refresh_output();                                           \
  template std::vector<Field> EnthalpyHeat<Dim>::fields();                                     \
  template std::vector<Balance> EnthalpyHeat<Dim>::balances() const;                           \
  template std::vector<std::pair<std::string, double>> EnthalpyHeat<Dim>::diagnostics() const; \
  template std::vector<Note> EnthalpyHeat<Dim>::warnings() const;                              \
  template SurfaceView EnthalpyHeat<Dim>::surface() const;                                     \
  template void EnthalpyHeat<Dim>::save(Archive& archive) const;                               \
  template void EnthalpyHeat<Dim>::load(const Archive& archive);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
