#include "lapilli/scene/keys.hpp"

#include <algorithm>
#include <typeindex>
#include <vector>

#include "lapilli/core/allowed.hpp"
#include "lapilli/core/diagnostics.hpp"
#include "lapilli/scene/emit.hpp"
#include "lapilli/scene/scene.hpp"
#include "lapilli/scene/tree_writer.hpp"

namespace lapilli {
namespace {

// Writes one table for each struct it meets, once.
class KeyTables {
 public:
  /// `heading` is the TOML spelling: "[grid]", "shape: annulus".
  template <Described T>
  void add(const std::string& heading, bool has_kind = false) {
    if (std::find(done_.begin(), done_.end(), heading) != done_.end()) {
      return;
    }
    done_.push_back(heading);
    types_.emplace_back(typeid(T));
    std::string table = "\n## `" + heading + "`\n\n";
    table += "| key | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n";
    if (has_kind) {
      table += message("| `kind` | text | | `\"", kind_word(heading), "\"` | required | |\n");
    }
    const T defaults{};
    RowWriter row{table};
    T::describe(defaults, row);
    tables_.push_back(table);
    Follower deeper{*this, heading};
    T::describe(defaults, deeper);
  }

  /// The tables of a section, or all.
  std::string text(const std::string& section) const {
    std::string text;
    std::vector<std::string> names = {"history"};
    const auto add_name = [&](const std::string& name) {
      if (std::find(names.begin(), names.end(), name) == names.end()) {
        names.push_back(name);
      }
    };
    const std::string last = section.substr(section.rfind('.') + 1);  // material of bodies.material
    for (std::size_t k = 0; k < tables_.size(); ++k) {
      std::string name = done_[k];
      std::erase_if(name, [](char letter) { return letter == '[' || letter == ']'; });
      const bool is_inside = name.starts_with(section + ".") || name.starts_with(section + " ") ||
                             name.starts_with(last + " ");
      const bool ends_so = kind_word(name) == section || name.ends_with("." + section);
      if (section.empty() || name == section || is_inside || ends_so) {
        text += tables_[k];
      }
      add_name(name);
      if (k > 0 && done_[k].back() != ']') {  // of a kind: "shape annulus"
        add_name(kind_word(name));
        add_name(name.substr(0, name.find(' ')));
      }
    }
    require(!text.empty(), text.empty() ? unknown_name("section", section, names) : "");
    return text;
  }

 private:
  struct RowWriter {
    std::string& table;
    template <class T>
    void operator()(const Key& key, const T& member) {
      table += row_of(key, type_of(member, key), choices_of(member, key), default_of(member, key));
    }
  };

  /// Adds the tables of the structs that members hold.
  struct Follower {
    KeyTables& tables;
    const std::string& heading;
    template <class T>
    void operator()(const Key& key, const T& member) {
      if constexpr (holds_structs<T>) {
        tables.follow(key, member, heading);
      }
    }
  };

  static std::string kind_word(const std::string& heading) {
    return heading.substr(heading.rfind(' ') + 1);
  }

  template <class T>
  static std::string type_of(const T& member, const Key& key) {
    if constexpr (std::is_same_v<T, bool>) {
      return "true or false";
    } else if constexpr (std::is_same_v<T, double>) {
      return "number";
    } else if constexpr (std::is_integral_v<T>) {
      return "integer";
    } else if constexpr (std::is_same_v<T, std::string> || Named<T>) {
      return "string";
    } else if constexpr (std::is_same_v<T, Overrides>) {
      return "table";
    } else if constexpr (std::is_same_v<T, Value>) {
      return "number or `{times, values}`";
    } else if constexpr (std::is_same_v<T, SymmetricTensor>) {
      return "number or 6 numbers";
    } else if constexpr (is_over_temperature<T>) {
      return type_of(typename T::constant_type{}, key) + " or `{temperatures, values}`";
    } else if constexpr (is_optional<T>) {
      const std::string word =
          *key.absent_word ? message(" or `\"", key.absent_word, "\"`") : std::string();
      return type_of(typename T::value_type{}, key) + word;
    } else if constexpr (is_vector<T>) {
      const std::string inner = type_of(typename T::value_type{}, key);
      return key.single_allowed ? inner + " or list" : "list of " + inner;
    } else if constexpr (Indirect<T>) {
      return type_of(Held<T>{}, key);
    } else if constexpr (Kinded<T>) {
      return "tagged table (`kind`)";
    } else if constexpr (Described<T>) {
      return "table";
    } else {
      static_cast<void>(member);
      return "from a program only";
    }
  }

  template <class T>
  static std::string choices_of(const T&, const Key& key) {
    std::string words;
    if constexpr (is_optional<T>) {
      return choices_of(typename T::value_type{}, key);
    } else if constexpr (Named<T>) {
      for (const auto& [value, name] : Names<T>::values) {
        words += message(words.empty() ? "" : ", ", "`\"", name, "\"`");
      }
      return words;
    } else {
      Key without_unit = key;
      without_unit.of_unit = "";
      return allowed_range(without_unit);
    }
  }

  template <class T>
  static std::string default_of(const T& member, const Key& key) {
    return key.is_required ? "required" : in_toml(TreeWriter::write_default(member, key));
  }

  static std::string in_toml(const Tree& tree) {
    if (tree.is_absent()) {
      return "";
    }
    std::string line = emit_toml({Tree::Table{{"x", {}, tree}}, {}});
    line = line.substr(4, line.size() - 5);
    return line == "\"\"" || line == "[]" ? "" : message("`", line, "`");
  }

  static std::string row_of(const Key& key, const std::string& type, const std::string& choices,
                            const std::string& default_value) {
    return message("| `", key.name, "` | ", type, " | ", key.of_unit, " | ", choices, " | ",
                   default_value, " | ", key.meaning, " |\n");
  }

  // Headings: "[grid]", "[[bodies]]", "[bodies.geostatic]", "[[heat.boundaries]] convection",
  // "shape annulus".
  template <class T>
  void follow(const Key& key, const T&, const std::string& heading) {
    if (heading.starts_with("[[") && is_known<T>()) {
      return;  // what a stage adds is as in the scene
    }
    if constexpr (is_optional<T>) {
      follow(key, typename T::value_type{}, heading);
    } else if constexpr (is_vector<T>) {
      if constexpr (Kinded<typename T::value_type> && !key_is_shape<typename T::value_type>) {
        follow_kinds<typename T::value_type>(key.single_allowed ? key.name
                                                                : list_heading(key, heading));
      } else if constexpr (Described<typename T::value_type>) {
        add<typename T::value_type>(list_heading(key, heading));
      } else {
        follow(key, typename T::value_type{}, heading);
      }
    } else if constexpr (Indirect<T>) {
      follow(key, Held<T>{}, heading);
    } else if constexpr (Kinded<T>) {
      follow_kinds<T>(key_is_shape<T> ? "shape" : key.name);
    } else if constexpr (Described<T>) {
      add<T>(message("[", inside(heading), key.name, "]"));
    }
  }

  template <class T>
  static constexpr bool key_is_shape = std::is_same_v<T, Shape>;

  static std::string list_heading(const Key& key, const std::string& heading) {
    return message("[[", inside(heading), key.name, "]]");
  }

  /// "heat." of "[heat]", "bodies." of "[[bodies]]"; nothing of "shape annulus".
  static std::string inside(const std::string& heading) {
    if (heading.front() != '[' || heading.back() != ']') {
      return "";
    }
    std::string name = heading;
    std::erase_if(name, [](char letter) { return letter == '[' || letter == ']'; });
    return name + ".";
  }

  /// Whether there is a table for this, or what a list of it holds, already.
  template <class T>
  bool is_known() const {
    if constexpr (is_vector<T>) {
      return is_known<typename T::value_type>();
    } else if constexpr (std::is_same_v<T, DynamicsBoundary>) {
      return is_known<Pressure>();
    } else {
      return std::find(types_.begin(), types_.end(), std::type_index(typeid(T))) != types_.end();
    }
  }

  template <Kinded T>
  void follow_kinds(const std::string& name) {
    for_each_kind<T>([&](auto type) {
      using Alternative = typename decltype(type)::type;
      add<Alternative>(message(name, " ", Alternative::kind), true);
    });
  }

  std::vector<std::string> done_;
  std::vector<std::string> tables_;
  std::vector<std::type_index> types_;
};

}  // namespace

std::string keys_as_markdown(const std::string& section) {
  if (section == "history") {
    return "# What a run records in time\n\n" + diagnostics_as_markdown();
  }
  KeyTables tables;
  tables.add<Scene>("top of the file");
  return message("# Keys of a scene file\n", tables.text(section));
}

}  // namespace lapilli
