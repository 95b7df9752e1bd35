#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/mpm/heat/surface_conditions.hpp"

namespace lapilli {

/// The laws on the surface of one body (or several that touch) as forms on its nodes: with the
/// surface's own temperature T = sum S_I T_I,
///   E_I = integral of S_I rate(T) dA,  slopes M_IJ = integral of slope S_I S_J dA
/// (M symmetric, its rows add up to the integral of slope S_I).
class SurfaceTerm {
 public:
  using Vector = Eigen::VectorXd;
  using Matrix = Eigen::SparseMatrix<double>;
  using Trace = Eigen::SparseMatrix<double, Eigen::RowMajor>;  // values at sites from unknowns

  /// One law: where it acts and how the surface's temperature comes from the unknowns.
  struct Part {
    SurfaceSites sites;
    Trace trace;
  };

  SurfaceTerm() = default;
  /// `parts` by law, over `unknowns`; laws of which `elsewhere` says so are taken into account by
  /// others.
  SurfaceTerm(const SurfaceConditions& laws, std::vector<Part> parts, Eigen::Index unknowns,
              const std::vector<bool>& elsewhere);

  bool empty() const { return empty_; }
  const SurfaceSites& sites(std::size_t law) const { return parts_[law].given.sites; }

  /// Take the laws over [from, to] at the temperatures of the unknowns.
  void evaluate(const SurfaceConditions& laws, const Vector& temperature, double from, double to);

  // Of the last evaluation:
  /// Heat by unknown, W.
  const Vector& force() const { return force_; }
  /// M x.
  Vector slopes_times(const Vector& x) const;
  Vector slopes_diagonal() const;
  bool has_slopes() const;
  /// The largest slope of a law, W/(m^2 K).
  double steepest(std::size_t law) const;
  /// The numbers that slopes are made from: coefficients of uniform laws, slopes at sites of
  /// others.
  std::vector<double> signature() const;
  /// M made from such numbers.
  Matrix slopes(std::span<const double> signature) const;
  /// Heat of a law when temperatures have risen by `rise` since the evaluation, W.
  double heat(std::size_t law, const Vector& rise) const;

 private:
  struct Known {
    Part given;
    bool uniform = false, elsewhere = false;
    double hold = 0.0;
    Vector area;   // integral of S
    Matrix areas;  // integral of S S, of a uniform law
    UniformLaw now;
    double heat_now = 0.0;  // W, at the temperatures of the evaluation
  };
  std::vector<Known> parts_;
  bool empty_ = true;
  Vector force_;
};

/// Solves (base + scale M) x = right, base symmetric and positive: by a factor that is kept as long
/// as nothing changes and guides conjugate gradients where slopes change from step to step; by
/// conjugate gradients alone where a factor would not pay.
class SurfaceSolver {
 public:
  enum class Method { direct, conjugate_gradient };

  SurfaceSolver();
  ~SurfaceSolver();
  SurfaceSolver(SurfaceSolver&&) noexcept;
  SurfaceSolver& operator=(SurfaceSolver&&) noexcept;

  /// Whether the base holds `conduction_scale` times the conduction.
  bool has_base(double conduction_scale) const;
  /// `place`: coordinates of the unknowns on the grid, for the order of elimination.
  void set_base(SurfaceTerm::Matrix base, double conduction_scale, Method method,
                std::vector<std::array<int, 3>> place);
  /// Throws RunError when the factor fails or conjugate gradients do not converge.
  SurfaceTerm::Vector solve(const SurfaceTerm& term, double scale,
                            const SurfaceTerm::Vector& right);
  int iterations() const;  // of the last solve, 0 by the factor alone

  /// The factor in use, as the numbers that it was made from: a run that is resumed goes on with
  /// it.
  void save(Archive& archive, const std::string& name) const;
  void load(const Archive& archive, const std::string& name);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace lapilli
