#include "lapilli/core/archive.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"

namespace lapilli {

template <class T>
const T& Archive::find(const std::string& name) const {
  const auto found = arrays_.find(name);
  require(found != arrays_.end(), "checkpoint holds no '", name, "'; it belongs to another scene");
  const T* array = std::get_if<T>(&found->second);
  require(array != nullptr, "checkpoint entry '", name, "' has another type than this scene needs");
  return *array;
}

void Archive::write(const std::string& name, std::span<const double> values) {
  arrays_[name] = std::vector<double>(values.begin(), values.end());
}

void Archive::write(const std::string& name, std::span<const Index> values) {
  arrays_[name] = std::vector<Index>(values.begin(), values.end());
}

void Archive::write(const std::string& name, const std::string& text) { arrays_[name] = text; }

void Archive::read(const std::string& name, std::span<double> values) const {
  const auto& array = find<std::vector<double>>(name);
  require(array.size() == values.size(), "checkpoint entry '", name, "' has ", array.size(),
          " values, this scene needs ", values.size());
  std::copy(array.begin(), array.end(), values.begin());
}

void Archive::read(const std::string& name, std::span<Index> values) const {
  const auto& array = find<std::vector<Index>>(name);
  require(array.size() == values.size(), "checkpoint entry '", name, "' has ", array.size(),
          " values, this scene needs ", values.size());
  std::copy(array.begin(), array.end(), values.begin());
}

double Archive::read_number(const std::string& name) const {
  double value = 0.0;
  read(name, std::span(&value, 1));
  return value;
}

Index Archive::read_index(const std::string& name) const {
  Index value = 0;
  read(name, std::span(&value, 1));
  return value;
}

std::string Archive::read_text(const std::string& name) const { return find<std::string>(name); }

std::vector<double> Archive::read_numbers(const std::string& name) const {
  return find<std::vector<double>>(name);
}

std::vector<Index> Archive::read_indices(const std::string& name) const {
  return find<std::vector<Index>>(name);
}

}  // namespace lapilli
