#include "lapilli/mpm/heat/nodal_heat.hpp"

#include <cmath>

#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/heat_balance.hpp"
#include "lapilli/mpm/heat/temperature_range.hpp"

namespace lapilli {

template <int Dim>
void NodalHeat<Dim>::require_finite() const {
  require_finite_nodes<Dim>(problem_.grid, *rows_, temperature_);
}

template <int Dim>
void NodalHeat<Dim>::refresh_output() {
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
std::vector<Field> NodalHeat<Dim>::fields() {
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
std::vector<Balance> NodalHeat<Dim>::balances() const {
  Balance balance{"heat", "J", initial_, 0.0, laws_.entries(), 0.0};
  if (source_) {
    balance.entries.push_back({"source", source_->booked()});
  }
  add_stored_heat(lumped_, temperature_, balance);
  return {balance};
}

template <int Dim>
std::vector<std::pair<std::string, double>> NodalHeat<Dim>::diagnostics() const {
  return surface_diagnostics(laws_, negative_share_);
}

template <int Dim>
void NodalHeat<Dim>::save(Archive& archive) const {
  archive.write("heat/temperature", temperature_);
  archive.write("heat/updated", updated_);
  archive.write("heat/total", total_);
  archive.write("heat/initial", initial_);
  archive.write("heat/source", source_ ? source_->booked() : 0.0);
  archive.write("heat/self_heating", self_heating_.rate());
  if (start_) {
    archive.write("heat/start", start_->values());
  }
  laws_.save(archive, "heat/laws");
}

template <int Dim>
void NodalHeat<Dim>::load(const Archive& archive) {
  archive.read("heat/temperature", std::span<double>(temperature_));
  archive.read("heat/updated", std::span<double>(updated_));
  archive.read("heat/total", std::span<double>(total_));
  initial_ = archive.read_number("heat/initial");
  if (source_) {
    source_->set_booked(archive.read_number("heat/source"));
  }
  self_heating_.set_rate(archive.read_number("heat/self_heating"));
  if (start_) {
    archive.read("heat/start", start_->values());
  }
  laws_.load(archive, "heat/laws");
}

#define LAPILLI_INSTANTIATE(Dim)                                                            \
  template void NodalHeat<Dim>::require_finite() const;                                     \
  template void NodalHeat<Dim>::refresh_output();                                           \
  template std::vector<Field> NodalHeat<Dim>::fields();                                     \
  template std::vector<Balance> NodalHeat<Dim>::balances() const;                           \
  template std::vector<std::pair<std::string, double>> NodalHeat<Dim>::diagnostics() const; \
  template void NodalHeat<Dim>::save(Archive& archive) const;                               \
  template void NodalHeat<Dim>::load(const Archive& archive);
LAPILLI_INSTANTIATE(1)
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
