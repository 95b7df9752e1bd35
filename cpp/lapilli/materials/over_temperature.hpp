#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "lapilli/materials/symmetric_tensor.hpp"

namespace lapilli {

/// A property tabulated over the temperature: linear between the entries, constant outside them.
struct TemperatureTable {
  std::vector<double> temperatures;  // K, in the unit of the scene; rising
  std::vector<double> values;        // as many

  bool operator==(const TemperatureTable&) const = default;

  double at(double temperature) const;
  double largest() const;
  double least() const;
};

/// What is wrong with a table ("needs as many values as temperatures, got 2 and 3"); empty when
/// nothing is.
std::string mistake_in(const TemperatureTable& table);

/// A property that is constant, as a number or tensor, or an isotropic one tabulated over the
/// temperature.
template <class Constant>
class OverTemperature {
 public:
  using constant_type = Constant;

  OverTemperature() = default;
  OverTemperature(Constant constant) : form_(std::move(constant)) {}  // NOLINT: it is one
  OverTemperature(double constant)                                    // NOLINT
      requires(!std::is_same_v<Constant, double>)
      : form_(Constant(constant)) {}
  OverTemperature(TemperatureTable table) : form_(std::move(table)) {}  // NOLINT

  bool operator==(const OverTemperature&) const = default;

  /// The table where the property varies, null where it is constant.
  const TemperatureTable* table() const { return std::get_if<TemperatureTable>(&form_); }
  bool varies() const { return table() != nullptr; }
  /// The constant, or the largest or least value of the table.
  Constant largest() const { return varies() ? Constant(table()->largest()) : constant(); }
  Constant least() const { return varies() ? Constant(table()->least()) : constant(); }
  const Constant& constant() const { return std::get<Constant>(form_); }

 private:
  std::variant<Constant, TemperatureTable> form_;
};

template <class T>
inline constexpr bool is_over_temperature = false;
template <class Constant>
inline constexpr bool is_over_temperature<OverTemperature<Constant>> = true;

}  // namespace lapilli
