#include "convert_core.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace lapilli::python {
namespace {

thread_local FunctionCollector* collector = nullptr;

/// A Python callable as an ArrayFunction: called, and let go of, with the GIL held, whichever
/// thread does so.
class PythonFunction {
 public:
  PythonFunction(const py::object& callable, const Where& where)
      : callable_(held_callable(callable)), key_(where.key), path_(where.path()) {}

  const py::object& callable() const { return *callable_; }

  void operator()(std::span<const Vec3> position, std::span<const double> state, double time,
                  std::span<double> values) const {
    const py::gil_scoped_acquire gil;
    const auto rows = static_cast<py::ssize_t>(position.size());
    Numbers places({rows, py::ssize_t{3}});
    for (py::ssize_t row = 0; row < rows; ++row) {
      std::copy_n(position[static_cast<std::size_t>(row)].data(), 3, places.mutable_data(row, 0));
    }
    const Numbers states(static_cast<py::ssize_t>(state.size()), state.data());
    const py::object given = call(places, states, time);
    const Numbers answer = [&] {
      try {
        return numbers_from("it", given);
      } catch (const py::type_error&) {
        refuse(rows, std::string(py::repr(given)).substr(0, 80));
      }
    }();
    if (answer.ndim() == 0) {
      std::fill(values.begin(), values.end(), *answer.data());
    } else if (answer.ndim() == 1 && answer.shape(0) == rows) {
      std::copy_n(answer.data(), rows, values.data());
    } else {
      refuse(rows, "an array of shape " + std::string(py::str(answer.attr("shape"))));
    }
    for (std::size_t row = 0; row < values.size(); ++row) {
      try {
        check_range(key_, values[row], {});
      } catch (const std::invalid_argument& error) {
        throw RunError(message("the function given for ", path_, ", at (",
                               position[row].transpose(), ") and ", time, " s: ", error.what()));
      }
    }
  }

 private:
  py::object call(const Numbers& places, const Numbers& states, double time) const {
    try {
      return (*callable_)(places, states, time);
    } catch (py::error_already_set& error) {
      add_note(error, message("in the function given for ", path_,
                              ", called with (position, state, time)"));
      throw;
    }
  }

  [[noreturn]] void refuse(py::ssize_t rows, const std::string& answer) const {
    throw RunError(message("the function given for ", path_, " was called for ", rows,
                           " places and answered ", answer,
                           "; one number, or one a place, is allowed"));
  }

  std::shared_ptr<py::object> callable_;
  Key key_;
  std::string path_;
};

}  // namespace

std::shared_ptr<py::object> held_callable(const py::object& callable) {
  std::shared_ptr<py::object> shared(new py::object(callable), [](py::object* held) {
    const py::gil_scoped_acquire gil;
    delete held;
  });
  if (collector != nullptr) {
    collector->functions.push_back(shared);
  }
  return shared;
}

void add_note(py::error_already_set& error, const std::string& note) {
  if (py::hasattr(error.value(), "add_note")) {
    error.value().attr("add_note")(note);
  }
}

FunctionCollector::FunctionCollector() : outer_(std::exchange(collector, this)) {}
FunctionCollector::~FunctionCollector() { collector = outer_; }

Numbers numbers_from(const std::string& what, py::handle given) {
  const auto refuse = [&](const std::string& because) {
    throw py::type_error(what + " must be numbers, got " + because);
  };
  const auto masked = py::module_::import("numpy.ma");
  if (py::isinstance(given, masked.attr("MaskedArray")) &&
      py::bool_(masked.attr("is_masked")(given))) {
    refuse("an array with masked entries: fill or leave out what is masked");
  }
  const auto array = py::array::ensure(given);
  if (!array) {
    PyErr_Clear();
    refuse(std::string(py::repr(given)).substr(0, 80));
  }
  if (std::string("biuf").find(array.dtype().kind()) == std::string::npos) {
    refuse("an array of " + std::string(py::str(array.dtype())));
  }
  return Numbers::ensure(array);
}

void check_table(const Where& where, const Table& table) {
  const auto say = [&](const auto&... parts) {
    return message(where.owner, where.owner.empty() ? "" : ": ", where.key.name, " ", parts...);
  };
  require(!table.times.empty(), say("is a table without times"));
  require(table.times.size() == table.values.size(), say("needs as many values as times, got "),
          table.values.size(), " and ", table.times.size());
  for (const double time : table.times) {
    check_range(Key("times").unit("s"), time, where.path());
  }
  require(table.is_ordered(),
          say("needs times that increase; two equal times, not three, are a jump"));
  for (const double value : table.values) {
    check_range(where.key, value, where.owner);
  }
}

void Convert<Value>::load(const Where& where, py::handle given, Value& member) {
  if (py::isinstance<Table>(given)) {
    member = given.cast<Table>();
  } else if (PyCallable_Check(given.ptr()) != 0) {
    member = ArrayFunction(PythonFunction(py::reinterpret_borrow<py::object>(given), where));
    return;
  } else if ((PyTuple_Check(given.ptr()) || PyList_Check(given.ptr())) && py::len(given) == 2) {
    Table table;
    const auto numbers = Where{Key(where.key.name), where.owner};
    Convert<std::vector<double>>::load(numbers, given[py::int_(0)], table.times);
    Convert<std::vector<double>>::load(numbers, given[py::int_(1)], table.values);
    member = std::move(table);
  } else {
    double number = 0.0;
    if (PyUnicode_Check(given.ptr()) || !PyNumber_Check(given.ptr()) ||
        py::hasattr(given, "__len__")) {
      where.refuse("a number, a Table, a pair (times, values) or a function", given);
    }
    Convert<double>::load(where, given, number);
    member = number;
  }
  if (const auto* table = std::get_if<Table>(&member.form())) {
    check_table(where, *table);
  }
}

py::object Convert<Value>::show(const Key&, const Value& member) {
  if (const auto* number = std::get_if<double>(&member.form())) {
    return py::float_(*number);
  }
  if (const auto* table = std::get_if<Table>(&member.form())) {
    return py::cast(*table);
  }
  const auto* function = std::get<ArrayFunction>(member.form()).target<PythonFunction>();
  return function ? function->callable() : py::none();
}

void Convert<SymmetricTensor>::load(const Where& where, py::handle given, SymmetricTensor& member) {
  if (PySequence_Check(given.ptr()) != 0 && !PyUnicode_Check(given.ptr()) &&
      !(py::isinstance<py::array>(given) && given.cast<py::array>().ndim() == 0)) {
    Convert<std::array<double, 6>>::load(where, given, member.components);
  } else {
    double number = 0.0;
    Convert<double>::load(where, given, number);
    member = number;
  }
}

py::object Convert<SymmetricTensor>::show(const Key& key, const SymmetricTensor& member) {
  return member.is_scalar() ? py::float_(member[0])
                            : Convert<std::array<double, 6>>::show(key, member.components);
}

bool is_temperature_table(py::handle given) {
  return py::isinstance<py::dict>(given) ||
         ((PyTuple_Check(given.ptr()) || PyList_Check(given.ptr())) && py::len(given) == 2);
}

TemperatureTable temperature_table_from(const Where& where, py::handle given) {
  const bool named = py::isinstance<py::dict>(given);
  const auto column = [&](const char* name, int number) -> py::object {
    if (!named) {
      return given[py::int_(number)];
    }
    const auto both = py::reinterpret_borrow<py::dict>(given);
    if (both.size() != 2 || !both.contains(name)) {
      where.refuse("a table {\"temperatures\": [...], \"values\": [...]}", given);
    }
    return both[name];
  };
  TemperatureTable table;
  const auto numbers = Where{Key(where.key.name), where.owner};
  Convert<std::vector<double>>::load(numbers, column("temperatures", 0), table.temperatures);
  Convert<std::vector<double>>::load(numbers, column("values", 1), table.values);
  const std::string mistake = mistake_in(table);
  require(mistake.empty(), where.owner, where.owner.empty() ? "" : ": ", where.key.name, " ",
          mistake);
  for (const double value : table.values) {
    check_range(where.key, value, where.owner);
  }
  return table;
}

}  // namespace lapilli::python
