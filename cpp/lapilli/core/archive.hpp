#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Named arrays that hold everything a bitwise resume needs. Names are paths: "heat/temperature".
/// The file form belongs to the output folder.
class Archive {
 public:
  using Array = std::variant<std::vector<double>, std::vector<Index>, std::string>;

  void write(const std::string& name, std::span<const double> values);
  void write(const std::string& name, std::span<const Index> values);
  void write(const std::string& name, double value) { write(name, std::span(&value, 1)); }
  void write(const std::string& name, Index value) { write(name, std::span(&value, 1)); }
  void write(const std::string& name, const std::string& text);

  /// Copy into `values`; throws std::invalid_argument when missing, of another type or size.
  void read(const std::string& name, std::span<double> values) const;
  void read(const std::string& name, std::span<Index> values) const;
  double read_number(const std::string& name) const;
  Index read_index(const std::string& name) const;
  std::string read_text(const std::string& name) const;
  std::vector<double> read_numbers(const std::string& name) const;
  std::vector<Index> read_indices(const std::string& name) const;
  bool contains(const std::string& name) const { return arrays_.contains(name); }

  const std::map<std::string, Array>& arrays() const { return arrays_; }
  void insert(const std::string& name, Array array) { arrays_[name] = std::move(array); }

 private:
  template <class T>
  const T& find(const std::string& name) const;

  std::map<std::string, Array> arrays_;
};

}  // namespace lapilli
