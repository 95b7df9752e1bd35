#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lapilli/core/archive.hpp"
#include "lapilli/core/field.hpp"
#include "lapilli/core/points.hpp"
#include "lapilli/materials/state_variable.hpp"

namespace lapilli {

/// The state variables of the solids of a scene, each an array over all points; bodies whose solids
/// know a variable of the same name and unit share it.
class StateArrays {
 public:
  /// `variables` by body. `points` must outlive it. Throws std::invalid_argument for too many, or
  /// one name with two units.
  StateArrays(Points& points, std::span<const std::vector<StateVariable>> variables);

  bool empty() const { return arrays_.empty(); }
  /// How many a body has.
  int count(Index body) const { return static_cast<int>(of_body_[body].size()); }
  /// Pointers to row `first` of the variables of a body, in its order.
  std::array<double*, most_state_variables> rows(Index body, Index first);
  /// The variables of one point, in the order of its body, and back.
  std::array<double, most_state_variables> read(Index body, Index row) const;
  void write(Index body, Index row, const double* values);

  std::vector<Field> fields() const;
  /// All variables by name.
  std::vector<std::pair<std::string, PointArray*>> arrays() const;
  void save(Archive& archive, const std::string& prefix) const;
  void load(const Archive& archive, const std::string& prefix);

 private:
  struct Array {
    StateVariable variable;
    std::unique_ptr<PointArray> values;
  };
  std::size_t find_or_add(Points& points, const StateVariable& variable);

  std::vector<Array> arrays_;
  std::vector<std::vector<std::size_t>> of_body_;
};

}  // namespace lapilli
