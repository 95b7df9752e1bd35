#include <algorithm>
#include <cmath>
#include <iterator>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/bridged_gaps.hpp"
#include "lapilli/mpm/heat/cut_cell_heat.hpp"
#include "lapilli/mpm/heat/functions_in_time.hpp"
#include "lapilli/mpm/heat/heat_balance.hpp"
#include "lapilli/mpm/heat/surface_warnings.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"
#include "lapilli/mpm/surface/cut_shape.hpp"
#include "lapilli/mpm/transfer/weights.hpp"

namespace lapilli {

template <int Dim>
void CutCellHeat<Dim>::require_finite() const {
  for (const Solved& one : solved_) {
    require_finite_nodes<Dim>(problem_.grid, *one.part.rows, one.part.temperature);
  }
}

template <int Dim>
void CutCellHeat<Dim>::refresh_output() {
  require_finite();
  if (!output_temperature_) {
    output_temperature_ = std::make_unique<PointArray>(points_, 1);
    output_flux_ = std::make_unique<PointArray>(points_, Dim);
  }
  with_shape(problem_.shape, resting_half_width, [&](auto shape) {
    parallel_for(points_.size(), [&](Index row) {
      const auto body = static_cast<std::size_t>(points_.body()[row]);
      const HeatPart<Dim>& part = solved_[part_of_[body]].part;
      const Weights<Dim, decltype(shape)> weights(problem_.grid, shape,
                                                  points_.position().data() + row * Dim);
      double value = 0.0;
      Vec<Dim> gradient = Vec<Dim>::Zero();
      weights.for_each_node(problem_.grid, [&](Index node, double s, const Vec<Dim>& slope) {
        if (s > 0.0) {
          const double nodal = part.temperature[part.rows->place(node)];
          value += s * nodal;
          gradient += nodal * slope;
        }
      });
      (*output_temperature_)[row] = std::clamp(value, range_.low, range_.high);
      Eigen::Map<Vec<Dim>>(output_flux_->data() + row * Dim) =
          -coefficients_.conductivity[body] * gradient;
    });
  });
}

template <int Dim>
std::vector<Field> CutCellHeat<Dim>::fields() {
  if (!output_temperature_) {
    refresh_output();
  }
  return {{"temperature", "K", 1, output_temperature_->values()},
          {"heat_flux", "W/m^2", Dim, output_flux_->values()}};
}

template <int Dim>
std::vector<Balance> CutCellHeat<Dim>::balances() const {
  Balance balance{"heat", "J", initial_, 0.0, laws_.entries(), 0.0};
  bool has_sources = false;
  for (const Solved& one : solved_) {
    has_sources = has_sources || !one.part.sources.empty();
    add_stored_heat(one.part.capacity, one.part.temperature, balance);
  }
  if (has_sources) {
    balance.entries.push_back({"source", source_});
  }
  return {balance};
}

template <int Dim>
std::vector<std::pair<std::string, double>> CutCellHeat<Dim>::diagnostics() const {
  double area = 0.0, free = 0.0;
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    for (const Solved& one : solved_) {
      for (const double a : one.near.surface.sites(law).area) {
        area += a;
      }
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
  if (is_adaptive()) {
    all.emplace_back("time_error", largest_error() / temperature_span());
    all.emplace_back("implicit_steps", static_cast<double>(implicit_steps_));
    all.emplace_back("staged_steps", static_cast<double>(staged_steps_));
  }
  return all;
}

template <int Dim>
SurfaceView CutCellHeat<Dim>::surface() const {
  SurfaceView view;
  view.dimension = Dim;
  for (std::size_t law = 0; law < laws_.size(); ++law) {
    for (const Solved& one : solved_) {
      view.append(one.near.surface.sites(law));
    }
  }
  return view;
}

template <int Dim>
std::vector<Note> CutCellHeat<Dim>::warnings() const {
  std::vector<Note> all =
      surface_warnings<Dim>(found_, problem_, laws_.account(), temperature_span(), time_);
  for (const Solved& one : solved_) {
    std::ranges::copy(bridged_gaps(problem_, one.part), std::back_inserter(all));
  }
  if (!is_adaptive()) {
    return all;
  }
  if (implicit_steps_ + staged_steps_ > 0 && has_functions(problem_) && std::isfinite(end_)) {
    all.push_back(note("heat.functions-in-long-steps",
                       "long steps of heat may miss what functions do for less than ",
                       FunctionsInTime(end_).spacing(),
                       " s; tables are exact, and steps of heat.time_integration = \"explicit\" "
                       "are shorter"));
  }
  const double error = largest_error() / temperature_span(),
               tolerance = problem_.settings.tolerance;
  if (error > 10.0 * tolerance) {
    all.push_back(note("heat.time-error",
                       "the error of the time integration of heat is estimated at ", error,
                       " of the span of temperatures, heat.tolerance is ", tolerance,
                       ": compare with a shorter time.step"));
  }
  return all;
}

template <int Dim>
void CutCellHeat<Dim>::save(Archive& archive) const {
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    archive.write(message("heat/temperature ", k), solved_[k].part.temperature);
    if (!is_implicit()) {
      solved_[k].near.solver.save(archive, message("heat/solver ", k));
      solved_[k].solver_of_whole.save(archive, message("heat/solver of whole ", k));
    }
    if (const auto& all = solved_[k].all) {
      all->solver.save(archive, message("heat/solver of all ", k));
    }
  }
  if (is_adaptive()) {
    save_stepping(archive);
  }
  archive.write("heat/initial", initial_);
  archive.write("heat/source", source_);
  archive.write("heat/self_heating", self_heating_.rate());
  archive.write("heat/time", time_);
  laws_.account().save(archive, "heat/laws");
}

template <int Dim>
void CutCellHeat<Dim>::load(const Archive& archive) {
  if (is_adaptive()) {
    load_stepping(archive);
  }
  for (std::size_t k = 0; k < solved_.size(); ++k) {
    archive.read(message("heat/temperature ", k), std::span<double>(solved_[k].part.temperature));
    if (!is_implicit()) {
      solved_[k].near.solver.load(archive, message("heat/solver ", k));
      solved_[k].solver_of_whole.load(archive, message("heat/solver of whole ", k));
    }
    if (const auto& all = solved_[k].all) {
      all->solver.load(archive, message("heat/solver of all ", k));
    }
  }
  initial_ = archive.read_number("heat/initial");
  source_ = archive.read_number("heat/source");
  self_heating_.set_rate(archive.read_number("heat/self_heating"));
  time_ = archive.read_number("heat/time");
  laws_.account().load(archive, "heat/laws");
}

#define LAPILLI_INSTANTIATE(Dim)                                                              \
  template void CutCellHeat<Dim>::require_finite() const;                                     \
  template void CutCellHeat<Dim>::refresh_output();                                           \
  template std::vector<Field> CutCellHeat<Dim>::fields();                                     \
  template std::vector<Balance> CutCellHeat<Dim>::balances() const;                           \
  template std::vector<std::pair<std::string, double>> CutCellHeat<Dim>::diagnostics() const; \
  template std::vector<Note> CutCellHeat<Dim>::warnings() const;                              \
  template SurfaceView CutCellHeat<Dim>::surface() const;                                     \
  template void CutCellHeat<Dim>::save(Archive& archive) const;                               \
  template void CutCellHeat<Dim>::load(const Archive& archive);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
