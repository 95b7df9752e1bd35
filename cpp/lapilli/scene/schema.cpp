#include "lapilli/scene/schema.hpp"

#include <cmath>
#include <map>
#include <typeindex>

#include "lapilli/scene/emit.hpp"
#include "lapilli/scene/scene.hpp"
#include "lapilli/scene/tree_writer.hpp"

namespace lapilli {
namespace {

Tree text(std::string words) { return {std::move(words), {}}; }
Tree number(double value) { return {value, {}}; }
Tree::Entry entry(std::string name, Tree value) { return {std::move(name), {}, std::move(value)}; }
Tree object(Tree::Table entries) { return {std::move(entries), {}}; }
Tree array(Tree::Array elements) { return {std::move(elements), {}}; }
Tree of_type(const char* name) { return object({entry("type", text(name))}); }
Tree any_of(Tree::Array forms) { return object({entry("anyOf", array(std::move(forms)))}); }

/// Makes the schema of every struct it meets, once, under its own name.
class SchemaWriter {
 public:
  template <Described T>
  Tree struct_schema(const char* kind = nullptr) {
    Tree::Table properties;
    Tree::Array required;
    if (kind) {
      properties.push_back(entry("kind", object({entry("const", text(kind))})));
      required.push_back(text("kind"));
    }
    PropertyWriter add{*this, properties, required};
    const T defaults{};
    T::describe(defaults, add);
    return object_schema(std::move(properties), std::move(required));
  }

  Tree definitions() const {
    Tree::Table all;
    for (const auto& [name, schema] : definitions_) {
      all.push_back(entry(name, schema));
    }
    return object(std::move(all));
  }

 private:
  struct PropertyWriter {
    SchemaWriter& writer;
    Tree::Table& properties;
    Tree::Array& required;

    template <class T>
    void operator()(const Key& key, const T& member) {
      if constexpr (!std::is_same_v<T, std::optional<GivenPoints>> && !is_function<T>) {
        add(key, annotated(writer.schema_of<T>(key), key, TreeWriter::write_default(member, key)));
      }
    }

    void add(const Key& key, Tree property) {
      properties.push_back(entry(key.name, std::move(property)));
      if (key.is_required) {
        required.push_back(text(key.name));
      }
    }
  };

  static Tree object_schema(Tree::Table properties, Tree::Array required) {
    Tree::Table schema{entry("type", text("object")),
                       entry("properties", object(std::move(properties))),
                       entry("additionalProperties", {false, {}})};
    if (!required.empty()) {
      schema.push_back(entry("required", array(std::move(required))));
    }
    return object(std::move(schema));
  }

  template <class T>
  Tree schema_of(const Key& key) {
    if constexpr (std::is_same_v<T, bool>) {
      return of_type("boolean");
    } else if constexpr (std::is_same_v<T, double>) {
      return ranged("number", key);
    } else if constexpr (std::is_integral_v<T>) {
      return ranged("integer", key);
    } else if constexpr (std::is_same_v<T, std::string>) {
      return of_type("string");
    } else if constexpr (std::is_same_v<T, Overrides>) {
      return of_type("object");
    } else if constexpr (std::is_same_v<T, Value>) {
      return any_of({ranged("number", key), table_over("times", key)});
    } else if constexpr (std::is_same_v<T, SymmetricTensor>) {
      return any_of({ranged("number", key), list_of(ranged("number", key), 6, 6)});
    } else if constexpr (is_over_temperature<T>) {
      return any_of({schema_of<typename T::constant_type>(key), table_over("temperatures", key)});
    } else if constexpr (Named<T>) {
      Tree::Array names;
      for (const auto& [value, name] : Names<T>::values) {
        names.push_back(text(name));
      }
      return object({entry("enum", array(std::move(names)))});
    } else if constexpr (is_optional<T>) {
      Tree inner = schema_of<typename T::value_type>(key);
      return *key.absent_word == 0
                 ? inner
                 : any_of({std::move(inner), object({entry("const", text(key.absent_word))})});
    } else if constexpr (is_vector<T>) {
      Tree one = schema_of<typename T::value_type>(key);
      Tree list = list_of(one, key.shortest, key.longest);
      return key.single_allowed ? any_of({std::move(one), std::move(list)}) : list;
    } else if constexpr (Indirect<T>) {
      return schema_of<Held<T>>(key);
    } else if constexpr (Kinded<T>) {
      Tree::Array kinds;
      for_each_kind<T>([&](auto type) {
        using Alternative = typename decltype(type)::type;
        kinds.push_back(reference<Alternative>(Alternative::kind, Alternative::kind));
      });
      return any_of(std::move(kinds));
    } else {
      return reference<T>(key.name, nullptr);
    }
  }

  template <Described T>
  Tree reference(const char* wanted_name, const char* kind) {
    if (const std::string name = new_definition(typeid(T), wanted_name); !name.empty()) {
      definitions_[name] = struct_schema<T>(kind);
    }
    return object({entry("$ref", text("#/definitions/" + names_.at(typeid(T))))});
  }

  /// The name of a type that has no definition yet; empty where it has one.
  std::string new_definition(std::type_index type, const char* wanted_name) {
    const auto [found, is_new] = names_.try_emplace(type, wanted_name);
    if (!is_new) {
      return "";
    }
    while (definitions_.contains(found->second)) {
      found->second += "_";
    }
    definitions_[found->second] = {};  // a shape may hold a shape
    return found->second;
  }

  static Tree annotated(Tree schema, const Key& key, const Tree& unset) {
    std::string says = key.meaning;
    says += *key.of_unit ? message(says.empty() ? "" : ", ", key.of_unit) : "";
    // Beside a reference other keywords do not count, so they stand around it.
    Tree::Table table = *schema.table();
    if (find(table, "$ref")) {
      table = {entry("allOf", array({std::move(schema)}))};
    }
    if (!says.empty()) {
      table.push_back(entry("description", text(says)));
    }
    const auto* value = std::get_if<double>(&unset.value);
    if (!unset.is_absent() && !unset.array() && !(value && !std::isfinite(*value))) {
      table.push_back(entry("default", unset));
    }
    return object(std::move(table));
  }

  static Tree ranged(const char* type, const Key& key) {
    Tree::Table table{entry("type", text(type))};
    if (std::isfinite(key.least)) {
      table.push_back(entry(key.open ? "exclusiveMinimum" : "minimum", number(key.least)));
    }
    if (std::isfinite(key.most)) {
      table.push_back(entry("maximum", number(key.most)));
    }
    return object(std::move(table));
  }

  static Tree list_of(Tree element, int least, int most) {
    Tree::Table table{entry("type", text("array")), entry("items", std::move(element))};
    if (least > 0) {
      table.push_back(entry("minItems", {Index{least}, {}}));
    }
    if (most < std::numeric_limits<int>::max()) {
      table.push_back(entry("maxItems", {Index{most}, {}}));
    }
    return object(std::move(table));
  }

  static Tree table_over(const char* name, const Key& key) {
    const Tree places = list_of(of_type("number"), 1, std::numeric_limits<int>::max());
    const Tree values = list_of(ranged("number", key), 1, std::numeric_limits<int>::max());
    return object({entry("type", text("object")),
                   entry("properties", object({entry(name, places), entry("values", values)})),
                   entry("required", array({text(name), text("values")})),
                   entry("additionalProperties", {false, {}})});
  }

  std::map<std::type_index, std::string> names_;
  std::map<std::string, Tree> definitions_;
};

}  // namespace

std::string scene_schema() {
  SchemaWriter writer;
  Tree::Table schema{entry("$schema", text("http://json-schema.org/draft-07/schema#")),
                     entry("title", text("A scene of lapilli"))};
  const Tree scene = writer.struct_schema<Scene>();
  schema.insert(schema.end(), scene.table()->begin(), scene.table()->end());
  schema.push_back(entry("definitions", writer.definitions()));
  return emit_json(object(std::move(schema)));
}

}  // namespace lapilli
