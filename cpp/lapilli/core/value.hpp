#pragma once

#include <functional>
#include <initializer_list>
#include <span>
#include <variant>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// A number tabulated in time: linear between the times, constant outside them. Two equal times
/// are a jump.
struct Table {
  std::vector<double> times;   // s, not decreasing, at most two of them equal
  std::vector<double> values;  // as many

  /// Whether the times increase, but for jumps.
  bool is_ordered() const;
  /// The value at one time; at a jump the one after it.
  double at(double time) const;
  /// The limit from earlier times: at a jump the value before it.
  double before(double time) const;
  /// The mean over a span of time, exact; at(begin) where the span is empty.
  double mean(double begin, double end) const;
  /// The first jump after `time`, s; infinite where there is none.
  double next_jump(double time) const;
  /// The first time of an entry after `time`, s; infinite where there is none.
  double next_entry(double time) const;
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
  /// As of a table; a function has neither a mean (0) nor jumps nor entries.
  double before(double time) const;
  double mean(double begin, double end) const;
  double next_jump(double time) const;
  double next_entry(double time) const;
  /// The last jump from the start, 0 s, up to `time`; the start where there is none.
  double last_jump(double time) const;
  /// The last entry of a table from the start up to `time`, the start where there is none; minus
  /// infinity of what is no table.
  double last_entry(double time) const;
  /// The largest and the least value of a constant or a table; infinite for a function.
  double largest() const;
  double least() const;
  /// Fill `values`, one a row; `state` may be empty where the law does not depend on it.
  void evaluate(std::span<const Vec3> position, std::span<const double> state, double time,
                std::span<double> values) const;
  /// Fill `values` with the means over a span of time; a function is taken at its middle.
  void evaluate_mean(std::span<const Vec3> position, std::span<const double> state, double begin,
                     double end, std::span<double> values) const;

 private:
  Form form_;
};

/// The mean over a span of time of `product(time)`, a product of the values given (constants or
/// tables): exact for up to five tables between the times of their entries, which are not asked
/// themselves.
double mean_of_product(std::initializer_list<const Value*> values, double begin, double end,
                       const std::function<double(double)>& product);

}  // namespace lapilli
