#pragma once

#include <functional>
#include <span>
#include <variant>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// A number tabulated in time: linear between the times, constant outside them.
struct Table {
  std::vector<double> times;   // s, increasing
  std::vector<double> values;  // as many

  double at(double time) const;
};

/// A function over whole arrays: positions (rows x 3, m), the quantity there (may be empty), the
/// time (s); fills one value a row.
using ArrayFunction =
    std::function<void(std::span<const Vec3> position, std::span<const double> state, double time,
                       std::span<double> values)>;

/// A number that may be constant, tabulated in time or a function of place, state and time.
class Value {
 public:
  using Form = std::variant<double, Table, ArrayFunction>;

  Value(double constant = 0.0) : form_(constant) {}              // NOLINT: a number is a value
  Value(Table table) : form_(std::move(table)) {}                // NOLINT
  Value(ArrayFunction function) : form_(std::move(function)) {}  // NOLINT

  const Form& form() const { return form_; }
  bool is_function() const { return std::holds_alternative<ArrayFunction>(form_); }
  bool is_constant() const { return std::holds_alternative<double>(form_); }

  /// The value at one time of a constant or a table; 0 for a function.
  double at(double time) const;
  /// Fill `values`, one a row; `state` may be empty where the law does not depend on it.
  void evaluate(std::span<const Vec3> position, std::span<const double> state, double time,
                std::span<double> values) const;

 private:
  Form form_;
};

}  // namespace lapilli
