#pragma once

#include <string>

#include "lapilli/materials/solid.hpp"

namespace lapilli {

struct ElasticConstants {
  explicit ElasticConstants(const LinearElastic& elastic);

  double lambda, shear_modulus, wave_modulus, density;  // Pa, kg/m^3
};

/// A material made ready for blocks of points.
struct StressMaterial : ElasticConstants {
  explicit StressMaterial(const Solid& solid, std::string body = "a body");

  SolidLaw law;
  std::string body;  // whose it is, for messages
};

/// Points worked on at once, staged as arrays: [component][row].
inline constexpr int block_rows = 128;

template <int Dim>
struct DeformationBlock {
  /// Displacement gradient of the step, dt grad v, row-major.
  alignas(32) double gradient[Dim * Dim][block_rows];
};

/// Where the block's points are kept; pointers to its first row.
struct StressRows {
  double* stress;             // rows x 4 (plane strain) or 6
  double* volume;             // m^Dim
  const double* mass;         // kg
  const double* free_strain;  // isotropic, or null
  double* plastic;            // J, added to, or null
  double* opened;  // volume strain to close before it bears pressure; of solids that part only
  double* const* state = nullptr;  // of each state variable of the law
  int variables = 0;               // how many
  double step = 0.0;               // s
};

struct StressSums {
  double plastic = 0.0;       // J
  double strain_work = 0.0;   // J, of the mean stress of the step on its strain
  double work_ahead = 0.0;    // J, half the work of the stress reached on the strain
  double expansion = 0.0;     // J, given to the points by their free strain
  double least_volume = 1.0;  // least determinant of the incremental deformation
  double strain = 0.0;        // largest square of a strain of the step
  double wave_ratio = 0.0;    // largest volume over mass, m^Dim/kg
};

/// Deform rows [begin, end) of a block: rotate the stress, add the elastic stress of the strain,
/// return it by the law of the material, and let the volume follow.
///
/// Rotation and strain are those of the mid-step configuration (Hughes & Winget 1980): with
/// A = dt grad v, G = A (1 + A/2)^-1, strain = sym G, rotation = Cayley transform of skew G. A
/// finite rotation is exact and strains nothing; a pure stretch gives its logarithm to third order.
template <int Dim>
StressSums update_stress(const StressMaterial& material, const DeformationBlock<Dim>& block,
                         const StressRows& rows, int begin, int end);

/// Elastic energy of a stress over a volume of one cubic metre, J/m^3.
double elastic_energy(const ElasticConstants& material, const SymmetricTensor& stress);

}  // namespace lapilli
