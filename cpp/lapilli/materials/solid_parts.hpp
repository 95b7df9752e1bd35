#pragma once

#include <concepts>
#include <type_traits>
#include <vector>

#include "lapilli/core/simd.hpp"
#include "lapilli/materials/elastic.hpp"
#include "lapilli/materials/function_solid.hpp"
#include "lapilli/materials/state_variable.hpp"
#include "lapilli/materials/stress_slope.hpp"

namespace lapilli {

// What makes a struct a solid, part by part. Mechanics ask these concepts and never for a type; a
// struct in the list of solids (solid.hpp) that lacks a part does not compile, and the error names
// the part.

/// Its name in scene files.
template <class T>
concept HasKind = requires {
  { T::kind } -> std::convertible_to<const char*>;
};

/// Its parameters, described (core/describe.hpp).
template <class T>
concept HasParameters = requires(T& solid, void (*visit)(const char*)) {
  &T::template describe<T, decltype(visit)>;
};

/// check(solid) throws std::invalid_argument that names the first parameter out of range.
template <class T>
concept HasCheck = requires(const T& solid) {
  check(solid);
};

/// Density and elastic moduli, which give the wave speed and the trial stress.
template <class T>
concept HasElasticPart = requires(const T& solid) {
  { solid.elastic_part() } -> std::same_as<const LinearElastic&>;
};

/// Names and units of what it keeps at every point; empty where there is nothing.
template <class T>
concept HasStateVariables = requires(const T& solid) {
  { solid.state_variables() } -> std::same_as<std::vector<StateVariable>>;
};

/// Its law, made ready once a material, with the number of state variables it works on; `yields`
/// where it returns trial stresses at all, `parts` where it bears no tension beyond a mean stress.
template <class T>
concept HasLaw = std::constructible_from<typename T::Law, const T&> &&
    std::copyable<typename T::Law> && requires {
  { T::Law::states } -> std::convertible_to<int>;
  { T::Law::yields } -> std::convertible_to<bool>;
  { T::Law::parts } -> std::convertible_to<bool>;
};

/// law.return_stress(stress, state): from the elastic trial stress to the one the law allows, in
/// place, for one point (double) or four at once (Double4), in plane strain (xx, yy, zz, xy) and in
/// space (xx, yy, zz, xy, yz, xz).
template <class T>
concept ReturnsPoints = requires(const typename T::Law& law, double (&plane)[4], double (&full)[6],
                                 Double4 (&planes)[4], Double4 (&fulls)[6], double* state,
                                 Double4* states) {
  law.return_stress(plane, state);
  law.return_stress(full, state);
  law.return_stress(planes, states);
  law.return_stress(fulls, states);
};

/// law.return_block(block): the same of a block of points, from the strain increment and the stress
/// before the step (PointBlock). Such a law has no tangent, and no place in load steps.
template <class Law>
concept BlockLaw = requires(const Law& law, const PointBlock& block) {
  law.return_block(block);
};

template <class T>
concept HasReturn = ReturnsPoints<T> || BlockLaw<typename T::Law>;

/// law.stress_and_slope(trial, state, slope): the same at one point, with the derivative of the
/// stress reached to the trial stress: times the elastic stiffness, the consistent tangent.
template <class T>
concept HasTangent = BlockLaw<typename T::Law> ||
    requires(const typename T::Law& law, const SymmetricTensor& trial, double* state,
             StressSlope& slope) {
  { law.stress_and_slope(trial, state, slope) } -> std::same_as<SymmetricTensor>;
};

/// law.parts_at(state): the mean stress beyond which nothing holds a point together, Pa.
template <class T>
concept HasPartingStress = !T::Law::parts || requires(const typename T::Law& law,
                                                      const double* state, const Double4* states) {
  { law.parts_at(state) } -> std::same_as<double>;
  law.parts_at(states);
};

/// True, or a compile error that names the part which is not there.
template <class T>
constexpr bool is_whole_solid() {
  static_assert(HasKind<T>, "a solid needs `static constexpr const char* kind`");
  static_assert(HasParameters<T>, "a solid needs `describe(self, visit)` for its parameters");
  static_assert(HasCheck<T>, "a solid needs `void check(const Solid&)` beside it");
  static_assert(HasElasticPart<T>, "a solid needs `const LinearElastic& elastic_part() const`");
  static_assert(HasStateVariables<T>,
                "a solid needs `std::vector<StateVariable> state_variables() const`");
  static_assert(HasLaw<T>,
                "a solid needs a type `Law` made from it, with `states`, `yields` and "
                "`parts`");
  static_assert(HasReturn<T>, "the law of a solid needs `return_stress(stress, state) const`");
  static_assert(HasTangent<T>,
                "the law of a solid needs `stress_and_slope(trial, state, slope) const`");
  static_assert(HasPartingStress<T>, "the law of a solid that parts needs `parts_at(state) const`");
  return true;
}

}  // namespace lapilli
