#include "lapilli/materials/state_arrays.hpp"

#include <utility>

#include "lapilli/core/require.hpp"

namespace lapilli {

StateArrays::StateArrays(Points& points, std::span<const std::vector<StateVariable>> variables) {
  for (std::size_t body = 0; body < variables.size(); ++body) {
    require(variables[body].size() <= most_state_variables, "the solid of body ", body, " has ",
            variables[body].size(), " state variables, ", most_state_variables, " are allowed");
    std::vector<std::size_t>& own = of_body_.emplace_back();
    for (const StateVariable& variable : variables[body]) {
      own.push_back(find_or_add(points, variable));
    }
  }
}

std::size_t StateArrays::find_or_add(Points& points, const StateVariable& variable) {
  for (std::size_t k = 0; k < arrays_.size(); ++k) {
    if (arrays_[k].variable.name == variable.name) {
      require(arrays_[k].variable.unit == variable.unit, "two solids have a state variable ",
              variable.name, ", one in ", arrays_[k].variable.unit, ", one in ", variable.unit);
      return k;
    }
  }
  arrays_.push_back({variable, std::make_unique<PointArray>(points, 1)});
  return arrays_.size() - 1;
}

std::array<double*, most_state_variables> StateArrays::rows(Index body, Index first) {
  std::array<double*, most_state_variables> pointers{};
  for (std::size_t k = 0; k < of_body_[body].size(); ++k) {
    pointers[k] = arrays_[of_body_[body][k]].values->data() + first;
  }
  return pointers;
}

std::array<double, most_state_variables> StateArrays::read(Index body, Index row) const {
  std::array<double, most_state_variables> values{};
  for (std::size_t k = 0; k < of_body_[body].size(); ++k) {
    values[k] = (*arrays_[of_body_[body][k]].values)[row];
  }
  return values;
}

void StateArrays::write(Index body, Index row, const double* values) {
  for (std::size_t k = 0; k < of_body_[body].size(); ++k) {
    (*arrays_[of_body_[body][k]].values)[row] = values[k];
  }
}

std::vector<Field> StateArrays::fields() const {
  std::vector<Field> all;
  for (const Array& array : arrays_) {
    all.push_back({array.variable.name, array.variable.unit, 1, array.values->values()});
  }
  return all;
}

std::vector<std::pair<std::string, PointArray*>> StateArrays::arrays() const {
  std::vector<std::pair<std::string, PointArray*>> all;
  for (const Array& array : arrays_) {
    all.emplace_back(array.variable.name, array.values.get());
  }
  return all;
}

void StateArrays::save(Archive& archive, const std::string& prefix) const {
  for (const Array& array : arrays_) {
    archive.write(prefix + array.variable.name, std::as_const(*array.values).values());
  }
}

void StateArrays::load(const Archive& archive, const std::string& prefix) {
  for (Array& array : arrays_) {
    archive.read(prefix + array.variable.name, array.values->values());
  }
}

}  // namespace lapilli
