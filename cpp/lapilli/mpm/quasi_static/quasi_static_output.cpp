#include "lapilli/mpm/quasi_static/quasi_static.hpp"

#include <Eigen/Eigenvalues>
#include <utility>

#include "lapilli/core/require.hpp"

namespace lapilli {

template <int Dim>
std::vector<Field> QuasiStatic<Dim>::fields() {
  return {{"displacement", "m", Dim, displacement_.values()},
          {"stress", "Pa", 6, stress_.values()}};
}

template <int Dim>
void QuasiStatic<Dim>::save(Archive& archive) const {
  archive.write("quasi_static/stress", stress_.values());
  archive.write("quasi_static/displacement", displacement_.values());
  archive.write("quasi_static/start_volume", start_volume_.values());
  archive.write("quasi_static/guarded", guarded_.values());
  std::vector<double> forces;
  for (const Vec<Dim>& force : support_forces_) {
    forces.insert(forces.end(), force.data(), force.data() + Dim);
  }
  archive.write("quasi_static/support_forces", std::span<const double>(forces));
  if (half_width_) {
    archive.write("quasi_static/half_width", std::as_const(*half_width_).values());
  }
  reference_.save(archive);
}

template <int Dim>
void QuasiStatic<Dim>::load(const Archive& archive) {
  archive.read("quasi_static/stress", stress_.values());
  archive.read("quasi_static/displacement", displacement_.values());
  archive.read("quasi_static/start_volume", start_volume_.values());
  archive.read("quasi_static/guarded", guarded_.values());
  const std::vector<double> forces = archive.read_numbers("quasi_static/support_forces");
  for (std::size_t w = 0; w < support_forces_.size(); ++w) {
    support_forces_[w] = Eigen::Map<const Vec<Dim>>(forces.data() + Dim * w);
  }
  if (half_width_) {
    archive.read("quasi_static/half_width", half_width_->values());
  }
  reference_.scheme = scheme_;
  reference_.load(archive);
  reference_.locate(grid_, points_, materials_, averaged_, boundary_);
}

/// From the stress: it starts at zero and the law is elastic.
template <int Dim>
double QuasiStatic<Dim>::largest_strain() const {
  double largest = 0.0;
  for (Index p = 0; p < points_.size(); ++p) {
    const LinearElastic& material = materials_[points_.body()[p]];
    const double* s = stress_.data() + 6 * p;
    const SymmetricTensor stress(s[0], s[1], s[2], s[3], s[4], s[5]);
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(stress.matrix(), Eigen::EigenvaluesOnly);
    const double nu = material.poissons_ratio;
    const Vec3 strain = ((1.0 + nu) * principal.eigenvalues().array() - nu * stress.trace()) /
                        material.youngs_modulus;
    largest = std::max(largest, strain.cwiseAbs().maxCoeff());
  }
  return largest;
}

template <int Dim>
std::vector<std::string> QuasiStatic<Dim>::warnings() const {
  constexpr double small = 0.02;
  const double strain = largest_strain();
  if (strain <= small) {
    return {};
  }
  return {message("quasi_static: the largest strain is ", strain,
                  "; the law is one of small strains, good to about ", small)};
}

template <int Dim>
std::vector<std::pair<std::string, double>> QuasiStatic<Dim>::diagnostics() const {
  std::vector<std::pair<std::string, double>> numbers{
      {"iterations", report_.newton.iterations},    {"residual", report_.newton.residual},
      {"smallest pivot", report_.pivots.smallest},  {"largest pivot", report_.pivots.largest},
      {"condition estimate", report_.condition},    {"halvings", report_.halvings},
      {"deepest penetration", report_.penetration}, {"largest strain", largest_strain()},
  };
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t w = 0; w < boundary_.walls(); ++w) {
    for (int axis = 0; axis < Dim; ++axis) {
      numbers.emplace_back("force of " + boundary_.wall(w).what() + " along " + axes[axis],
                           support_forces_[w][axis]);
    }
  }
  return numbers;
}

#define LAPILLI_INSTANTIATE(Dim)                                        \
  template std::vector<Field> QuasiStatic<Dim>::fields();               \
  template void QuasiStatic<Dim>::save(Archive& archive) const;         \
  template void QuasiStatic<Dim>::load(const Archive& archive);         \
  template std::vector<std::string> QuasiStatic<Dim>::warnings() const; \
  template double QuasiStatic<Dim>::largest_strain() const;             \
  template std::vector<std::pair<std::string, double>> QuasiStatic<Dim>::diagnostics() const;
LAPILLI_INSTANTIATE(2)
LAPILLI_INSTANTIATE(3)
#undef LAPILLI_INSTANTIATE

}  // namespace lapilli
