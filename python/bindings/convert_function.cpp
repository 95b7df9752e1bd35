#include "convert_function.hpp"

#include <algorithm>

#include "lapilli/core/require.hpp"

namespace lapilli::python {
namespace {

/// One call of the interpreter a block.
class PythonBlockFunction {
 public:
  explicit PythonBlockFunction(const py::object& callable) : callable_(held_callable(callable)) {}

  const py::object& callable() const { return *callable_; }

  void operator()(const PointBlock& block) const {
    const py::gil_scoped_acquire gil;
    const py::ssize_t rows = block.rows, variables = block.variables;
    const Numbers strain({rows, py::ssize_t{6}}, block.strain.data());
    const Numbers stress({rows, py::ssize_t{6}}, block.stress.data());
    const Numbers state({rows, variables}, block.state.data());
    const py::object answer = call(block, strain, stress, state);
    if (variables == 0) {
      take(block, "stress", answer, block.stress, 6);
      return;
    }
    if (!py::isinstance<py::tuple>(answer) || py::len(answer) != 2) {
      refuse(block, message("answered ", std::string(py::repr(answer)).substr(0, 80),
                            "; a pair (stress, state) is needed where there is a state"));
    }
    take(block, "stress", answer[py::int_(0)], block.stress, 6);
    take(block, "state", answer[py::int_(1)], block.state, variables);
  }

 private:
  py::object call(const PointBlock& block, const Numbers& strain, const Numbers& stress,
                  const Numbers& state) const {
    try {
      return (*callable_)(strain, stress, state, block.step);
    } catch (py::error_already_set& error) {
      add_note(error, message("in the function of the solid of ", block.body,
                              ", called with (strain_increment, stress, state, time_step)"));
      throw;
    }
  }

  static void take(const PointBlock& block, const char* what, const py::object& given,
                   std::span<double> to, py::ssize_t columns) {
    const Numbers numbers = [&] {
      try {
        return numbers_from(what, given);
      } catch (const py::type_error& error) {
        refuse(block, message("answered no numbers: ", error.what()));
      }
    }();
    if (numbers.ndim() != 2 || numbers.shape(0) != block.rows || numbers.shape(1) != columns) {
      refuse(block,
             message("answered a ", what, " of shape ", std::string(py::str(numbers.attr("shape"))),
                     ", (", block.rows, ", ", columns, ") is needed"));
    }
    std::copy_n(numbers.data(), to.size(), to.begin());
  }

  [[noreturn]] static void refuse(const PointBlock& block, const std::string& answer) {
    throw RunError(message("the function of the solid of ", block.body, " ", answer));
  }

  std::shared_ptr<py::object> callable_;
};

}  // namespace

void Convert<BlockFunction>::load(const Where& where, py::handle given, BlockFunction& member) {
  if (PyCallable_Check(given.ptr()) == 0) {
    where.refuse("a function", given);
  }
  member = PythonBlockFunction(py::reinterpret_borrow<py::object>(given));
}

py::object Convert<BlockFunction>::show(const Key&, const BlockFunction& member) {
  const auto* function = member.target<PythonBlockFunction>();
  return function != nullptr ? function->callable() : py::none();
}

}  // namespace lapilli::python
