#pragma once

#include <memory>

#include "convert.hpp"
#include "initialized.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/materials/over_temperature.hpp"

namespace lapilli::python {

/// Any array or nest of lists that holds numbers, made contiguous. Texts, dates, complex numbers,
/// objects and masked entries are a TypeError that begins with `what`: nothing is dropped.
Numbers numbers_from(const std::string& what, py::handle given);

/// Notes every function of Python that becomes part of a C++ struct on this thread while it lives.
class FunctionCollector {
 public:
  FunctionCollector();
  ~FunctionCollector();
  FunctionCollector(const FunctionCollector&) = delete;
  FunctionCollector& operator=(const FunctionCollector&) = delete;

  std::vector<std::weak_ptr<py::object>> functions;

 private:
  FunctionCollector* outer_;
};

/// A callable of Python as part of a C++ struct: let go of with the GIL held, whichever thread does
/// so, and noted by the collector of this thread.
std::shared_ptr<py::object> held_callable(const py::object& callable);

/// Tell the error of a user's own code where it was called from.
void add_note(py::error_already_set& error, const std::string& note);

/// Throws std::invalid_argument unless times increase and every value is in the key's range.
void check_table(const Where& where, const Table& table);

/// A number, a lapilli.Table, a pair (times, values), or a callable over whole arrays: it is given
/// positions (rows, 3), the state (rows,) and the time, and answers one number or one a row.
template <>
struct Convert<Value> {
  static constexpr bool keeps_object = false;
  static std::string type_name() {
    return "float | Table | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]]"
           " | collections.abc.Callable[..., typing.Any]";
  }
  static void load(const Where& where, py::handle given, Value& member);
  static py::object show(const Key& key, const Value& member);
};

/// A number (that multiple of the identity) or the components xx, yy, zz, xy, yz, xz.
template <>
struct Convert<SymmetricTensor> {
  static constexpr bool keeps_object = false;
  static std::string type_name() { return "float | collections.abc.Sequence[float]"; }
  static void load(const Where& where, py::handle given, SymmetricTensor& member);
  static py::object show(const Key& key, const SymmetricTensor& member);
};

/// A pair (temperatures, values), or a mapping of both, as a table over the temperature; throws
/// std::invalid_argument for one that cannot be used.
TemperatureTable temperature_table_from(const Where& where, py::handle given);
/// Whether something given can only be meant as a table over the temperature.
bool is_temperature_table(py::handle given);

/// The constant, or a pair (temperatures, values).
template <class Constant>
struct Convert<OverTemperature<Constant>> {
  static constexpr bool keeps_object = false;
  static std::string type_name() {
    return Convert<Constant>::type_name() +
           " | tuple[collections.abc.Sequence[float], collections.abc.Sequence[float]]";
  }
  static void load(const Where& where, py::handle given, OverTemperature<Constant>& member) {
    if (is_temperature_table(given)) {
      member = temperature_table_from(where, given);
      return;
    }
    Constant constant{};
    Convert<Constant>::load(where, given, constant);
    member = constant;
  }
  static py::object show(const Key& key, const OverTemperature<Constant>& member) {
    if (const TemperatureTable* table = member.table()) {
      return py::make_tuple(table->temperatures, table->values);
    }
    return Convert<Constant>::show(key, member.constant());
  }
};

}  // namespace lapilli::python

namespace pybind11::detail {

template <>
class type_caster<lapilli::Table> : public lapilli::python::InitializedCaster<lapilli::Table> {};

}  // namespace pybind11::detail
