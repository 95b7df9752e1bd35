#include "convert_scene.hpp"

namespace lapilli::python {
namespace {

void fill_tree(const Where& where, py::handle given, Tree& tree);

void fill_table(const Where& where, const py::dict& given, Tree::Table& table) {
  for (const auto& [key, value] : given) {
    if (!PyUnicode_Check(key.ptr())) {
      where.refuse("a dict of names", given);
    }
    Tree::Entry& entry = table.emplace_back();
    entry.name = std::string(py::str(key));
    fill_tree(where, value, entry.value);
  }
}

void fill_numbers(const std::vector<double>& numbers, Tree& tree) {
  auto& array = tree.value.emplace<Tree::Array>();
  for (const double number : numbers) {
    array.emplace_back().value = number;
  }
}

void fill_in_time(const Table& in_time, Tree::Table& table) {
  Tree::Entry& times = table.emplace_back();
  times.name = "times";
  fill_numbers(in_time.times, times.value);
  Tree::Entry& values = table.emplace_back();
  values.name = "values";
  fill_numbers(in_time.values, values.value);
}

bool is_listed(py::handle given) {
  return PyList_Check(given.ptr()) || PyTuple_Check(given.ptr()) ||
         (py::isinstance<py::array>(given) && given.cast<py::array>().ndim() > 0);
}

void fill_tree(const Where& where, py::handle given, Tree& tree) {
  if (!is_listed(given) && !PyBool_Check(given.ptr()) && is_other_kind(given)) {
    where.refuse("a dict of numbers, words, lists, tables in time and dicts", given);
  } else if (PyBool_Check(given.ptr())) {
    tree.value = given.ptr() == Py_True;
  } else if (PyUnicode_Check(given.ptr())) {
    tree.value = std::string(py::str(given));
  } else if (PyDict_Check(given.ptr())) {
    fill_table(where, py::reinterpret_borrow<py::dict>(given), tree.value.emplace<Tree::Table>());
  } else if (py::isinstance<Table>(given)) {
    fill_in_time(given.cast<const Table&>(), tree.value.emplace<Tree::Table>());
  } else if (is_listed(given)) {
    auto& array = tree.value.emplace<Tree::Array>();
    for (const py::handle element : given) {
      fill_tree(where, element, array.emplace_back());
    }
  } else if (PyIndex_Check(given.ptr())) {
    const auto whole = py::reinterpret_steal<py::int_>(PyNumber_Index(given.ptr()));
    tree.value = static_cast<Index>(whole.cast<long long>());
  } else if (PyNumber_Check(given.ptr())) {
    tree.value = py::float_(py::reinterpret_borrow<py::object>(given)).cast<double>();
  } else {
    where.refuse("a dict of numbers, words, lists, tables in time and dicts", given);
  }
}

py::object tree_shown(const Tree& tree) {
  if (const Tree::Table* table = tree.table()) {
    py::dict all;
    for (const Tree::Entry& entry : *table) {
      all[py::str(entry.name)] = tree_shown(entry.value);
    }
    return all;
  }
  if (const Tree::Array* array = tree.array()) {
    py::list all;
    for (const Tree& element : *array) {
      all.append(tree_shown(element));
    }
    return all;
  }
  if (const auto* number = std::get_if<double>(&tree.value)) {
    return py::float_(*number);
  }
  if (const auto* integer = std::get_if<Index>(&tree.value)) {
    return py::int_(*integer);
  }
  if (const auto* truth = std::get_if<bool>(&tree.value)) {
    return py::bool_(*truth);
  }
  return tree.string() != nullptr ? py::object(py::str(*tree.string())) : py::object(py::none());
}

}  // namespace

void Convert<Overrides>::load(const Where& where, py::handle given, Overrides& member) {
  if (!PyDict_Check(given.ptr())) {
    where.refuse("a dict", given);
  }
  member.entries.clear();
  fill_table(where, py::reinterpret_borrow<py::dict>(given), member.entries);
}

py::object Convert<Overrides>::show(const Key&, const Overrides& member) {
  py::dict all;
  for (const Tree::Entry& entry : member.entries) {
    all[py::str(entry.name)] = tree_shown(entry.value);
  }
  return all;
}

}  // namespace lapilli::python
