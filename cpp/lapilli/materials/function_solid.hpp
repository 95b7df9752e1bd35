#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "lapilli/materials/elastic.hpp"
#include "lapilli/materials/state_variable.hpp"
#include "lapilli/materials/stress_slope.hpp"

namespace lapilli {

/// What a function of a block of points gets: rows x 6 components xx, yy, zz, xy, yz, xz (shear as
/// of tensors; the last two are zero in the plane), rows x variables of state, and where to put its
/// answer. The stress is that before the step, turned with the material.
struct PointBlock {
  int rows = 0, variables = 0;
  std::span<const double> strain;  // increment of the step
  std::span<double> stress;        // Pa; before, then after
  std::span<double> state;         // before, then after
  double step = 0.0;               // s
  const std::string& body;         // "body 'sand'": whose points they are, for messages
};
using BlockFunction = std::function<void(const PointBlock&)>;

struct FunctionLaw;

/// A solid whose stress is a function over blocks of points, from a program only. Its elastic part
/// gives the wave speed, and the elastic energy; what its stress does beyond counts as plastic.
/// Without a tangent: explicit dynamics only.
struct FunctionSolid {
  static constexpr const char* kind = "function";
  using Law = FunctionLaw;
  LinearElastic elastic;
  BlockFunction function;
  std::vector<std::string> state;  // names of what it keeps at every point

  template <class Self, class Visitor>
  static void describe(Self& self, Visitor& visit) {
    LinearElastic::describe(self.elastic, visit);
    visit(
        Key("function")
            .required()
            .text(
                "(strain_increment, stress, state, time_step) of arrays with a row a point and the "
                "columns xx, yy, zz, xy, yz, xz; returns the stress, or the stress and the state"),
        self.function);
    visit(Key("state").length(0, most_state_variables).text("names of its state variables"),
          self.state);
  }

  const LinearElastic& elastic_part() const { return elastic; }
  std::vector<StateVariable> state_variables() const;
};

/// Throws std::invalid_argument for constants out of range, no function, or names that are not
/// words, come twice or are those of other fields.
void check(const FunctionSolid& material);

/// A law of blocks; it knows no single trial stress.
struct FunctionLaw {
  static constexpr int states = 0;
  static constexpr bool yields = true, parts = false;

  explicit FunctionLaw(const FunctionSolid& material);

  /// Calls the function; throws RunError where it leaves a number that is not finite.
  void return_block(const PointBlock& block) const;

  BlockFunction function;
  std::vector<std::string> names;
};

}  // namespace lapilli
