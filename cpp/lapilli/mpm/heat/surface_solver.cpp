#include <algorithm>

#include "lapilli/algebra/symmetric_factor.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/mpm/heat/surface_term.hpp"

namespace lapilli {
namespace {

using Vector = SurfaceTerm::Vector;
using Matrix = SurfaceTerm::Matrix;

bool has_same_pattern(const Matrix& a, const Matrix& b) {
  return a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

bool is_same(const Matrix& a, const Matrix& b) {
  return has_same_pattern(a, b) &&
         std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr());
}

/// The numbers of a base that is diagonal, which holds no conduction; none of others.
std::vector<double> capacity_of(const Matrix& base) {
  const bool diagonal = base.nonZeros() == base.cols();
  return diagonal ? std::vector<double>(base.valuePtr(), base.valuePtr() + base.nonZeros())
                  : std::vector<double>();
}

}  // namespace

struct SurfaceSolver::State {
  Matrix base;
  Method method = Method::direct;
  std::vector<double> loaded;             // capacity_of the base before a resume
  std::vector<std::array<int, 3>> place;  // of the unknowns on the grid
  SymmetricFactor factor;
  double conduction_scale = -1.0;  // of the conduction in the base
  bool analysed = false, factored = false;
  double scale = -1.0;                 // with the slopes in the factor; negative: none was made
  std::vector<double> signature;       // of these slopes
  double last_scale = -1.0;            // of the last solve: what comes twice is worth a factor
  std::vector<double> last_signature;  //
  int iterations = 0;

  void factorise(const SurfaceTerm& term) {
    const Matrix matrix = base + scale * term.slopes(signature);
    if (!analysed) {
      factor.analyse(matrix, place);
      analysed = true;
    }
    if (factor.factorise(matrix).not_positive > 0) {
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

void SurfaceSolver::set_base(Matrix base, double conduction_scale, Method method,
                             std::vector<std::array<int, 3>> place) {
  const bool same_problem =
      state_->conduction_scale == conduction_scale && state_->method == method;
  if (same_problem && is_same(base, state_->base)) {
    return;
  }
  // After a resume the numbers of the factor of this base have been loaded.
  const bool other = !state_->loaded.empty() && capacity_of(base) != state_->loaded;
  if (state_->base.size() > 0 || state_->conduction_scale != conduction_scale || other) {
    state_->scale = -1.0;
  }
  state_->analysed = state_->analysed && has_same_pattern(base, state_->base);
  state_->conduction_scale = conduction_scale;
  state_->base = std::move(base);
  state_->method = method;
  state_->place = std::move(place);
  state_->factored = false;
}

void SurfaceSolver::save(Archive& archive, const std::string& name) const {
  archive.write(name + "/conduction", state_->conduction_scale);
  archive.write(name + "/scale", state_->scale);
  archive.write(name + "/slopes", std::span<const double>(state_->signature));
  archive.write(name + "/last_scale", state_->last_scale);
  archive.write(name + "/last_slopes", std::span<const double>(state_->last_signature));
  archive.write(name + "/capacity", capacity_of(state_->base));
}

void SurfaceSolver::load(const Archive& archive, const std::string& name) {
  state_ = std::make_unique<State>();
  state_->conduction_scale = archive.read_number(name + "/conduction");
  state_->scale = archive.read_number(name + "/scale");
  state_->signature = archive.read_numbers(name + "/slopes");
  state_->last_scale = archive.read_number(name + "/last_scale");
  state_->last_signature = archive.read_numbers(name + "/last_slopes");
  state_->loaded = archive.read_numbers(name + "/capacity");
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
  const bool again = scale == s.last_scale && signature == s.last_signature;
  s.last_scale = scale;
  s.last_signature = signature;
  if (s.factored && !same && !again) {
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
