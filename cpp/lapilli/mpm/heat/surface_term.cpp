#include "lapilli/mpm/heat/surface_term.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

using Vector = SurfaceTerm::Vector;
using Matrix = SurfaceTerm::Matrix;

Eigen::Map<const Vector> mapped(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace

SurfaceTerm::SurfaceTerm(const SurfaceConditions& laws, std::vector<Part> parts,
                         Eigen::Index unknowns, const std::vector<bool>& elsewhere)
    : force_(Vector::Zero(unknowns)) {
  for (std::size_t law = 0; law < parts.size(); ++law) {
    Known known;
    known.given = std::move(parts[law]);
    SurfaceSites& sites = known.given.sites;
    const auto& trace = known.given.trace;
    sites.state.resize(sites.area.size());
    sites.rate.resize(sites.area.size());
    sites.slope.resize(sites.area.size());
    known.hold = sites.hold.empty() ? 0.0 : *std::ranges::max_element(sites.hold);
    const bool one_material = !(laws.holds_temperature(law) || sites.layer.behind) ||
                              (sites.conductivity.empty() &&
                               std::all_of(sites.hold.begin(), sites.hold.end(), [&](double hold) {
                                 return std::abs(hold / known.hold - 1.0) < 1e-12;
                               }));
    known.elsewhere = elsewhere[law];
    empty_ = empty_ && known.elsewhere;
    known.uniform = known.elsewhere || (laws.is_uniform(law) && one_material);
    const auto area = mapped(sites.area);
    known.area = trace.transpose() * area;
    if (known.uniform && !known.elsewhere) {
      known.areas = Matrix(trace.transpose()) * Matrix(area.asDiagonal() * trace);
    }
    parts_.push_back(std::move(known));
  }
}

void SurfaceTerm::evaluate(const SurfaceConditions& laws, const Vector& temperature, double from,
                           double to) {
  force_.setZero();
  for (std::size_t law = 0; law < parts_.size(); ++law) {
    Known& part = parts_[law];
    if (part.elsewhere) {
      continue;
    }
    if (part.uniform) {
      part.now = laws.uniform(law, part.hold, part.given.sites.layer, from, to);
      const double constant = part.now.flux + part.now.coefficient * part.now.ambient;
      force_ += constant * part.area;
      if (part.now.coefficient != 0.0) {
        force_ -= part.now.coefficient * (part.areas * temperature);
      }
      part.heat_now =
          constant * part.area.sum() - part.now.coefficient * part.area.dot(temperature);
      continue;
    }
    SurfaceSites& sites = part.given.sites;
    Eigen::Map<Vector>(sites.state.data(), static_cast<Eigen::Index>(sites.state.size())) =
        part.given.trace * temperature;
    laws.evaluate(law, sites, from, to);
    const Vector heat = mapped(sites.area).cwiseProduct(mapped(sites.rate));
    part.heat_now = heat.sum();
    force_ += part.given.trace.transpose() * heat;
  }
}

Vector SurfaceTerm::slopes_times(const Vector& x) const {
  Vector product = Vector::Zero(x.size());
  for (const Known& part : parts_) {
    if (part.elsewhere) {
      continue;
    }
    if (part.uniform) {
      product += part.now.coefficient * (part.areas * x);
    } else {
      const auto& sites = part.given.sites;
      const Vector there = part.given.trace * x;
      product += part.given.trace.transpose() *
                 Vector(there.cwiseProduct(mapped(sites.area).cwiseProduct(mapped(sites.slope))));
    }
  }
  return product;
}

Matrix SurfaceTerm::slopes(std::span<const double> signature) const {
  Matrix sum(force_.size(), force_.size());
  std::size_t next = 0;
  for (const Known& part : parts_) {
    if (part.elsewhere) {
      continue;
    }
    if (part.uniform) {
      sum += signature[next++] * part.areas;
      continue;
    }
    const auto& [sites, trace] = part.given;
    Vector weight = mapped(sites.area);
    for (double& w : weight) {
      w *= signature[next++];
    }
    sum += Matrix(trace.transpose()) * Matrix(weight.asDiagonal() * trace);
  }
  return sum;
}

Vector SurfaceTerm::slopes_diagonal() const {
  Vector diagonal = Vector::Zero(force_.size());
  for (const Known& part : parts_) {
    if (part.elsewhere) {
      continue;
    }
    if (part.uniform) {
      diagonal += part.now.coefficient * part.areas.diagonal();
      continue;
    }
    const auto& [sites, trace] = part.given;
    for (Eigen::Index k = 0; k < trace.rows(); ++k) {
      const double weight = sites.area[k] * sites.slope[k];
      for (SurfaceTerm::Trace::InnerIterator it(trace, k); it; ++it) {
        diagonal[it.col()] += weight * it.value() * it.value();
      }
    }
  }
  return diagonal;
}

double SurfaceTerm::steepest(std::size_t law) const {
  const Known& part = parts_[law];
  const auto& slope = part.given.sites.slope;
  return part.uniform    ? part.now.coefficient
         : slope.empty() ? 0.0
                         : *std::max_element(slope.begin(), slope.end());
}

bool SurfaceTerm::has_slopes() const {
  for (std::size_t law = 0; law < parts_.size(); ++law) {
    if (steepest(law) != 0.0) {
      return true;
    }
  }
  return false;
}

std::vector<double> SurfaceTerm::signature() const {
  std::vector<double> all;
  for (const Known& part : parts_) {
    if (part.elsewhere) {
      continue;
    }
    if (part.uniform) {
      all.push_back(part.now.coefficient);
    } else {
      all.insert(all.end(), part.given.sites.slope.begin(), part.given.sites.slope.end());
    }
  }
  return all;
}

double SurfaceTerm::heat(std::size_t law, const Vector& rise) const {
  const Known& part = parts_[law];
  if (part.uniform) {
    return part.heat_now - part.now.coefficient * part.area.dot(rise);
  }
  const auto& [sites, trace] = part.given;
  const Vector there = trace * rise;
  return part.heat_now - there.dot(mapped(sites.area).cwiseProduct(mapped(sites.slope)));
}

}  // namespace lapilli
