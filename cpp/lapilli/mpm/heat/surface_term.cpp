#include "lapilli/mpm/heat/surface_term.hpp"

#include <Eigen/SparseCholesky>
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

SurfaceTerm::SurfaceTerm(const SurfaceConditions& laws, std::vector<Part> parts) {
  for (std::size_t law = 0; law < parts.size(); ++law) {
    Known known;
    known.given = std::move(parts[law]);
    SurfaceSites& sites = known.given.sites;
    const auto& trace = known.given.trace;
    sites.state.resize(sites.area.size());
    sites.rate.resize(sites.area.size());
    sites.slope.resize(sites.area.size());
    known.hold = sites.hold.empty() ? 0.0 : sites.hold.front();
    const bool one_material = !laws.holds_temperature(law) ||
                              std::all_of(sites.hold.begin(), sites.hold.end(), [&](double hold) {
                                return std::abs(hold / known.hold - 1.0) < 1e-12;
                              });
    known.uniform = laws.is_uniform(law) && one_material;
    const auto area = mapped(sites.area);
    known.area = trace.transpose() * area;
    if (known.uniform) {
      known.areas = Matrix(trace.transpose()) * Matrix(area.asDiagonal() * trace);
    }
    force_ = Vector::Zero(trace.cols());
    parts_.push_back(std::move(known));
  }
}

void SurfaceTerm::evaluate(const SurfaceConditions& laws, const Vector& temperature, double from,
                           double to) {
  force_.setZero();
  for (std::size_t law = 0; law < parts_.size(); ++law) {
    Known& part = parts_[law];
    if (part.uniform) {
      part.now = laws.uniform(law, part.hold, from, to);
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

bool SurfaceTerm::has_slopes() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const Known& part) {
    const auto& slope = part.given.sites.slope;
    return part.uniform
               ? part.now.coefficient != 0.0
               : std::any_of(slope.begin(), slope.end(), [](double s) { return s != 0.0; });
  });
}

std::vector<double> SurfaceTerm::signature() const {
  std::vector<double> all;
  for (const Known& part : parts_) {
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

struct SurfaceSolver::State {
  Matrix base;
  Method method = Method::direct;
  Eigen::SimplicialLDLT<Matrix> factor;
  double conduction_scale = -1.0;  // of the conduction in the base
  bool factored = false;
  double scale = -1.0;            // with the slopes in the factor; negative: none was made
  std::vector<double> signature;  // of these slopes
  int iterations = 0;

  void factorise(const SurfaceTerm& term) {
    factor.compute(base + scale * term.slopes(signature));
    if (factor.info() != Eigen::Success) {
      throw RunError("heat: the matrix of the surface could not be factorised");
    }
    factored = true;
  }
};

SurfaceSolver::SurfaceSolver() : state_(std::make_unique<State>()) {}
SurfaceSolver::~SurfaceSolver() = default;
SurfaceSolver::SurfaceSolver(SurfaceSolver&&) noexcept = default;
SurfaceSolver& SurfaceSolver::operator=(SurfaceSolver&&) noexcept = default;

bool SurfaceSolver::has_base(double conduction_scale) const {
  return state_->base.size() > 0 && state_->conduction_scale == conduction_scale;
}

void SurfaceSolver::set_base(Matrix base, double conduction_scale, Method method) {
  // After a resume the numbers of the factor of this base have been loaded.
  if (state_->base.size() > 0 || state_->conduction_scale != conduction_scale) {
    state_->scale = -1.0;
  }
  state_->conduction_scale = conduction_scale;
  state_->base = std::move(base);
  state_->method = method;
  state_->factored = false;
}

void SurfaceSolver::save(Archive& archive, const std::string& name) const {
  archive.write(name + "/conduction", state_->conduction_scale);
  archive.write(name + "/scale", state_->scale);
  archive.write(name + "/slopes", std::span<const double>(state_->signature));
}

void SurfaceSolver::load(const Archive& archive, const std::string& name) {
  state_ = std::make_unique<State>();
  state_->conduction_scale = archive.read_number(name + "/conduction");
  state_->scale = archive.read_number(name + "/scale");
  state_->signature = archive.read_numbers(name + "/slopes");
}

int SurfaceSolver::iterations() const { return state_->iterations; }

namespace {

/// Conjugate gradients to 1e-13 of the right side; how many rounds it took, or `most` + 1.
template <class Multiply, class Precondition>
int conjugate_gradients(const Multiply& multiply, const Precondition& precondition,
                        const Vector& right, int most, Vector& x) {
  x.setZero(right.size());
  Vector residual = right, direction = precondition(residual);
  const double target = 1e-13 * right.norm();
  double product = residual.dot(direction);
  for (int round = 0; round <= most; ++round) {
    if (!(residual.norm() > target)) {
      return round;
    }
    const Vector image = multiply(direction);
    const double step = product / direction.dot(image);
    x += step * direction;
    residual -= step * image;
    const Vector preconditioned = precondition(residual);
    const double next = residual.dot(preconditioned);
    direction = preconditioned + next / product * direction;
    product = next;
  }
  return most + 1;
}

}  // namespace

Vector SurfaceSolver::solve(const SurfaceTerm& term, double scale, const Vector& right) {
  State& s = *state_;
  const auto multiply = [&](const Vector& x) {
    return Vector(s.base * x + scale * term.slopes_times(x));
  };
  Vector x;
  s.iterations = 0;
  if (s.method == Method::conjugate_gradient) {
    const Vector inverse = (s.base.diagonal() + scale * term.slopes_diagonal()).cwiseInverse();
    const int most = 200 + static_cast<int>(right.size());
    s.iterations = conjugate_gradients(
        multiply, [&](const Vector& r) { return Vector(inverse.cwiseProduct(r)); }, right, most, x);
    if (s.iterations > most || !x.allFinite()) {
      throw RunError(message("heat: conjugate gradients did not converge in ", most, " rounds"));
    }
    return x;
  }
  if (s.scale >= 0.0 && !s.factored) {
    s.factorise(term);
  }
  std::vector<double> signature = term.signature();
  const bool same = s.factored && scale == s.scale && signature == s.signature;
  if (s.factored && !same) {
    constexpr int worth_it = 12;  // rounds; then a new factor is cheaper
    s.iterations = conjugate_gradients(
        multiply, [&](const Vector& r) { return Vector(s.factor.solve(r)); }, right, worth_it, x);
    if (s.iterations <= worth_it) {
      return x;
    }
  }
  if (!same) {
    s.scale = scale;
    s.signature = std::move(signature);
    s.factorise(term);
    s.iterations = 0;
  }
  x = s.factor.solve(right);
  if (!x.allFinite()) {
    throw RunError("heat: the solve at the surface gave values that are not finite");
  }
  return x;
}

}  // namespace lapilli
