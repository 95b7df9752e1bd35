#pragma once

#include <variant>

#include "lapilli/materials/drucker_prager.hpp"
#include "lapilli/materials/modified_cam_clay.hpp"
#include "lapilli/materials/mohr_coulomb.hpp"
#include "lapilli/materials/solid_parts.hpp"
#include "lapilli/materials/stiffness.hpp"
#include "lapilli/materials/tabulated_mohr_coulomb.hpp"
#include "lapilli/materials/von_mises.hpp"

namespace lapilli {

/// The solids that mechanics can move: the one list of them.
using Solid = std::variant<LinearElastic, MohrCoulomb, DruckerPrager, VonMises,
                           TabulatedMohrCoulomb, ModifiedCamClay, FunctionSolid>;

namespace detail {

template <class List>
struct LawsOf;
template <class... Solids>
struct LawsOf<std::variant<Solids...>> {
  static_assert((is_whole_solid<Solids>() && ...));
  using type = std::variant<typename Solids::Law...>;
};

}  // namespace detail

/// `Variant` with the alternatives of another one behind its own.
template <class Variant, class Other>
struct Joined;
template <class... Own, class... Others>
struct Joined<std::variant<Own...>, std::variant<Others...>> {
  using type = std::variant<Own..., Others...>;
};

/// The law of any solid, made ready.
using SolidLaw = detail::LawsOf<Solid>::type;

inline SolidLaw law_of(const Solid& material) {
  return std::visit(
      [](const auto& solid) {
        return SolidLaw(typename std::remove_cvref_t<decltype(solid)>::Law(solid));
      },
      material);
}

inline const LinearElastic& elastic_part(const Solid& material) {
  return std::visit([](const auto& solid) -> const LinearElastic& { return solid.elastic_part(); },
                    material);
}

inline std::vector<StateVariable> state_variables(const Solid& material) {
  return std::visit([](const auto& solid) { return solid.state_variables(); }, material);
}

inline void check(const Solid& material) {
  std::visit([](const auto& solid) { check(solid); }, material);
}

/// Whether the law ever returns a trial stress.
inline bool yields(const SolidLaw& law) {
  return std::visit([](const auto& one) { return std::remove_cvref_t<decltype(one)>::yields; },
                    law);
}

/// Whether a point of it may come apart.
inline bool parts(const SolidLaw& law) {
  return std::visit([](const auto& one) { return std::remove_cvref_t<decltype(one)>::parts; }, law);
}

/// Whether it knows a stress and its slope at one point, as load steps need.
inline bool has_tangent(const SolidLaw& law) {
  return std::visit([](const auto& one) { return !BlockLaw<std::remove_cvref_t<decltype(one)>>; },
                    law);
}

// Both below are for laws that have a tangent.

/// The stress that a law allows for an elastic trial stress at one point; `state` follows.
inline SymmetricTensor return_stress(const SolidLaw& law, const SymmetricTensor& trial,
                                     double* state) {
  return std::visit(
      [&](const auto& one) {
        if constexpr (BlockLaw<std::remove_cvref_t<decltype(one)>>) {
          return trial;
        } else {
          return return_point(one, trial, state);
        }
      },
      law);
}

/// The same, with the derivative of the stress to the trial stress.
inline SymmetricTensor stress_and_slope(const SolidLaw& law, const SymmetricTensor& trial,
                                        double* state, StressSlope& slope) {
  return std::visit(
      [&](const auto& one) {
        if constexpr (BlockLaw<std::remove_cvref_t<decltype(one)>>) {
          return trial;
        } else {
          return one.stress_and_slope(trial, state, slope);
        }
      },
      law);
}

}  // namespace lapilli
