#include "lapilli/mpm/dynamics/stress_update.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

#include "lapilli/mpm/dynamics/stress_rows.hpp"

#pragma GCC diagnostic ignored "-Wpsabi"

namespace lapilli {
namespace {

/// The stresses that a function of the whole block has given, rows x 6.
struct GivenStresses {
  static constexpr int states = 0;
  static constexpr bool yields = true, parts = false;
  const double* stress;
  int first;

  template <class Real, int components>
  void take(int row, Real (&s)[components]) const {
    for (int c = 0; c < components; ++c) {
      s[c] = load_rows<Real>(stress + 6 * (row - first) + c, 6);
    }
  }
};

/// Copied into a loop, so that its constants need not be read again after every store; one that
/// owns memory stays where it is.
template <class Law>
using InLoop = std::conditional_t<std::is_trivially_copyable_v<Law>, const Law, const Law&>;

/// Before the return, which may change the state.
template <class Law, class Real>
auto parting_stress(const Law& law, const Real* state) {
  if constexpr (Law::parts) {
    return law.parts_at(state);
  } else {
    return 0.0;
  }
}

template <int Dim, class Law>
StressSums update_rows(const StressMaterial& material, const Law& its_law,
                       const DeformationBlock<Dim>& block, const StressRows& rows, int begin,
                       int end) {
  constexpr int components = Dim == 2 ? 4 : 6;
  const ElasticConstants m = material;
  InLoop<Law> law = its_law;
  Lanes lanes;
  for_quads(begin, end, [&]<class Real>(int row) {
    Real s[components];
    double* stress = rows.stress + row * components;
    for (int c = 0; c < components; ++c) {
      s[c] = load_rows<Real>(stress + c, components);
    }
    const Real given = rows.free_strain ? load<Real>(rows.free_strain + row) : as<Real>(0.0);
    Real free_strain = given;
    const Real trace = s[0] + s[1] + s[2];  // no rotation changes it
    Real strain[components];
    const Real growth = deform(m, block, row, given, s, strain);
    Real opened = as<Real>(0.0);
    if constexpr (Law::parts) {
      opened = load<Real>(rows.opened + row);
      close_gap(m, strain, opened, free_strain, s);
    }
    const Real before = load<Real>(rows.volume + row);
    const Real volume = before * growth;
    const Real strained = contract(m, s, strain, free_strain);
    Real work = as<Real>(0.0);
    if constexpr (Law::yields) {
      Real trial[components], state[std::max(1, Law::states)];
      for (int c = 0; c < components; ++c) {
        trial[c] = s[c];
      }
      for (int k = 0; k < Law::states; ++k) {
        state[k] = load<Real>(rows.state[k] + row);
      }
      [[maybe_unused]] const auto parts_at = parting_stress(law, state);
      if constexpr (std::is_same_v<Law, GivenStresses>) {
        law.take(row, s);
      } else {
        law.return_stress(s, state);
      }
      for (int k = 0; k < Law::states; ++k) {
        store(rows.state[k] + row, state[k]);
      }
      // What closes a gap bears on the way: its strain is lost like a plastic one.
      const Real closed = 0.5 * (given - free_strain) * (trace + s[0] + s[1] + s[2]);
      work = 0.5 * (before + volume) * (dissipation(m, trial, s, strain, free_strain) - closed);
      if constexpr (Law::parts) {
        store(rows.opened + row, opened + parted(m, parts_at, trial, s));
      }
      if (rows.plastic) {
        store(rows.plastic + row, load<Real>(rows.plastic + row) + work);
      }
    }
    Real reached = as<Real>(0.0);
    for (int c = 0; c < components; ++c) {
      store_rows(stress + c, components, s[c]);
      reached += s[c] * strain[c];
    }
    Real square = strain[0] * strain[0] + strain[1] * strain[1] + strain[2] * strain[2];
    for (int c = 3; c < components; ++c) {
      square += 0.5 * strain[c] * strain[c];
    }
    lanes.add_strain(square);
    store(rows.volume + row, volume);
    if (rows.free_strain) {
      // Elastic energy that strain alone did not bring: the mean stress on the free strain.
      lanes.add_expansion(-0.25 * (before + volume) * (trace + s[0] + s[1] + s[2]) * given);
    }
    lanes.add(work, 0.25 * (before + volume) * (strained + reached), 0.5 * volume * reached, growth,
              volume / load<Real>(rows.mass + row));
  });
  return lanes.total();
}

/// The same by a function of the whole block, which is called first.
template <int Dim>
StressSums update_rows(const StressMaterial& material, const BlockLaw auto& law,
                       const DeformationBlock<Dim>& block, const StressRows& rows, int begin,
                       int end) {
  constexpr int components = Dim == 2 ? 4 : 6;
  const int count = end - begin, variables = rows.variables;
  const ElasticConstants still(LinearElastic{1.0, 0.0, 0.0});  // turns stresses and adds nothing
  double strain[6 * block_rows], stress[6 * block_rows];
  double state[most_state_variables * block_rows];
  for (int k = 0; k < count; ++k) {
    const int row = begin + k;
    double s[components], e[components];
    std::copy_n(rows.stress + row * components, components, s);
    deform(still, block, row, 0.0, s, e);
    const double free_strain = rows.free_strain ? rows.free_strain[row] : 0.0;
    for (int c = 0; c < 6; ++c) {
      strain[6 * k + c] = c < 3 ? e[c] - free_strain : c < components ? 0.5 * e[c] : 0.0;
      stress[6 * k + c] = c < components ? s[c] : 0.0;
    }
    for (int v = 0; v < variables; ++v) {
      state[variables * k + v] = rows.state[v][row];
    }
  }
  const auto size = static_cast<std::size_t>(count);
  law.return_block({count,
                    variables,
                    {strain, 6 * size},
                    {stress, 6 * size},
                    {state, size * static_cast<std::size_t>(variables)},
                    rows.step,
                    material.body});
  for (int k = 0; k < count; ++k) {
    for (int v = 0; v < variables; ++v) {
      rows.state[v][begin + k] = state[variables * k + v];
    }
  }
  return update_rows<Dim>(material, GivenStresses{stress, begin}, block, rows, begin, end);
}

}  // namespace

ElasticConstants::ElasticConstants(const LinearElastic& elastic)
    : lambda(elastic.lambda()),
      shear_modulus(elastic.shear_modulus()),
      wave_modulus(elastic.wave_modulus()),
      density(elastic.density) {}

StressMaterial::StressMaterial(const Solid& solid, std::string of_body)
    : ElasticConstants(elastic_part(solid)), law(law_of(solid)), body(std::move(of_body)) {
  check(solid);
}

template <int Dim>
StressSums update_stress(const StressMaterial& material, const DeformationBlock<Dim>& block,
                         const StressRows& rows, int begin, int end) {
  return std::visit(
      [&](const auto& law) { return update_rows<Dim>(material, law, block, rows, begin, end); },
      material.law);
}

double elastic_energy(const ElasticConstants& m, const SymmetricTensor& s) {
  const double share = m.lambda / (3.0 * m.lambda + 2.0 * m.shear_modulus);
  const double trace = s.trace();
  const double normal = s[0] * s[0] + s[1] * s[1] + s[2] * s[2] - share * trace * trace;
  return 0.25 / m.shear_modulus * (normal + 2.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
}

template StressSums update_stress<2>(const StressMaterial&, const DeformationBlock<2>&,
                                     const StressRows&, int, int);
template StressSums update_stress<3>(const StressMaterial&, const DeformationBlock<3>&,
                                     const StressRows&, int, int);

}  // namespace lapilli
