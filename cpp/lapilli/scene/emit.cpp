#include "lapilli/scene/emit.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "lapilli/core/require.hpp"
#include "lapilli/output/json.hpp"

namespace lapilli {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') {
      result += {'\\', letter};
    } else if (letter == '\n') {
      result += "\\n";
    } else if (letter == '\t') {
      result += "\\t";
    } else if (code < 0x20 || code == 0x7f) {
      std::array<char, 8> escaped;
      std::snprintf(escaped.data(), escaped.size(), "\\u%04X", code);
      result += escaped.data();
    } else {
      result += letter;
    }
  }
  return result + "\"";
}

bool is_table_list(const Tree& tree) {
  const Tree::Array* array = tree.array();
  return array && !array->empty() &&
         std::all_of(array->begin(), array->end(), [](const Tree& t) { return t.table(); });
}

// Always with a point or an exponent: a number without one would be a whole number to TOML.
std::string toml_number(double number) {
  const std::string text = shortest(number);
  const bool whole = text.find_first_not_of("-0123456789") == std::string::npos;
  return whole ? text + ".0" : text;
}

std::string scalar(const Tree& tree) {
  if (const auto* number = std::get_if<double>(&tree.value)) {
    return toml_number(*number);
  }
  if (const auto* integer = std::get_if<Index>(&tree.value)) {
    return std::to_string(*integer);
  }
  if (const auto* boolean = std::get_if<bool>(&tree.value)) {
    return *boolean ? "true" : "false";
  }
  require(tree.string(), "TOML cannot hold ", in_words(tree));
  return quoted(*tree.string());
}

std::string toml_key(const std::string& name) {
  const bool is_bare = !name.empty() && name.find_first_not_of(
                                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                            "0123456789_-") == std::string::npos;
  return is_bare ? name : quoted(name);
}

std::string inline_toml(const Tree& tree) {
  std::string text;
  if (const Tree::Table* table = tree.table()) {
    for (const Tree::Entry& entry : *table) {
      text += (text.empty() ? "" : ", ") + toml_key(entry.name) + " = " + inline_toml(entry.value);
    }
    return "{" + text + "}";
  }
  if (const Tree::Array* array = tree.array()) {
    for (const Tree& element : *array) {
      text += (text.empty() ? "" : ", ") + inline_toml(element);
    }
    return "[" + text + "]";
  }
  return scalar(tree);
}

// The plain keys of a table first, then its sections, as TOML demands. Sections may nest one level.
void emit_section(const Tree::Table& table, const std::string& path, int depth, std::string& text) {
  const auto is_section = [&](const Tree& tree) {
    return (depth == 0 && tree.table()) || (depth < 2 && is_table_list(tree));
  };
  for (const Tree::Entry& entry : table) {
    if (!is_section(entry.value)) {
      text += entry.name + " = " + inline_toml(entry.value) + "\n";
    }
  }
  for (const Tree::Entry& entry : table) {
    if (!is_section(entry.value)) {
      continue;
    }
    const std::string name = path.empty() ? entry.name : path + "." + entry.name;
    if (const Tree::Table* section = entry.value.table()) {
      text += "\n[" + name + "]\n";
      emit_section(*section, name, depth + 1, text);
      continue;
    }
    for (const Tree& element : *entry.value.array()) {
      text += "\n[[" + name + "]]\n";
      emit_section(*element.table(), name, depth + 2, text);
    }
  }
}

void emit_json(const Tree& tree, JsonWriter& json) {
  if (const Tree::Table* table = tree.table()) {
    json.begin_object();
    for (const Tree::Entry& entry : *table) {
      json.key(entry.name);
      emit_json(entry.value, json);
    }
    json.end_object();
  } else if (const Tree::Array* array = tree.array()) {
    json.begin_array();
    for (const Tree& element : *array) {
      emit_json(element, json);
    }
    json.end_array();
  } else if (const auto* number = std::get_if<double>(&tree.value)) {
    json.value(*number);
  } else if (const auto* integer = std::get_if<Index>(&tree.value)) {
    json.value(*integer);
  } else if (const auto* truth = std::get_if<bool>(&tree.value)) {
    json.value(*truth);
  } else if (tree.string()) {
    json.value(*tree.string());
  } else {
    json.json("null");
  }
}

}  // namespace

std::string emit_toml(const Tree& tree) {
  require(tree.table(), "only a table can be written as TOML");
  std::string text;
  emit_section(*tree.table(), "", 0, text);
  return text;
}

std::string emit_json(const Tree& tree) {
  JsonWriter json;
  emit_json(tree, json);
  return json.text() + "\n";
}

}  // namespace lapilli
