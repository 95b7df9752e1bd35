#pragma once

#include <string>
#include <variant>
#include <vector>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// Where something stands in a text; line 0: it stands in none.
struct Place {
  int line = 0;
  int column = 0;
};

/// A value of a scene file before anybody knows what it means: the form between TOML or JSON text
/// and the structs of a scene.
struct Tree {
  struct Absent {};
  /// A value no scene uses, named for messages: "a date".
  struct Foreign {
    std::string what;
  };
  struct Entry;
  using Array = std::vector<Tree>;
  using Table = std::vector<Entry>;

  std::variant<Absent, bool, Index, double, std::string, Array, Table, Foreign> value;
  Place place;

  bool is_absent() const { return std::holds_alternative<Absent>(value); }
  const Table* table() const { return std::get_if<Table>(&value); }
  const Array* array() const { return std::get_if<Array>(&value); }
  const std::string* string() const { return std::get_if<std::string>(&value); }
};

/// One key of a table with its value.
struct Tree::Entry {
  std::string name;
  Place place;  // of the key
  Tree value;
};

/// The entry called `name`, or null.
const Tree::Entry* find(const Tree::Table& table, const std::string& name);

/// What a value is, for messages: "a number", "a table", "the text \"fast\"".
std::string in_words(const Tree& tree);

/// Whether two values are the same, wherever they stand; numbers to the last bit.
bool same(const Tree& a, const Tree& b);

}  // namespace lapilli
