#include <charconv>
#include <optional>
#include <span>

#include "lapilli/scene/element_names.hpp"
#include "lapilli/scene/scene_file.hpp"
#include "lapilli/scene/toml_source.hpp"
#include "lapilli/scene/tree_reader.hpp"

namespace lapilli {
namespace {

using Path = std::span<const std::string>;

bool is_index(const std::string& word) {
  return !word.empty() && word.find_first_not_of("0123456789") == std::string::npos;
}

// As messages and places spell it: "bodies[0].shape".
std::string spelled_path(const std::vector<std::string>& names) {
  std::string path;
  for (const std::string& name : names) {
    path = is_index(name) ? path + "[" + name + "]" : joined_path(path, name);
  }
  return path;
}

bool is_word(const std::string& text) {
  return !text.empty() && text.find_first_not_of(
                              "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                              "0123456789_-./") == std::string::npos;
}

Tree value_of(const std::string& text) {
  double number = 0.0;
  const char* end = text.data() + text.size();
  try {
    const Tree tree = parse_toml("value = " + text, "--set");
    if (tree.table()->size() == 1) {
      return tree.table()->front().value;
    }
  } catch (const std::invalid_argument&) {
    if (std::from_chars(text.data(), end, number).ptr == end && !text.empty()) {
      return {number, {}};  // ".5", which TOML does not know
    }
    if (is_word(text)) {
      return {text, {}};
    }
  }
  require(false, "--set: the value ", text.empty() ? "is missing" : "is not valid TOML: ", text);
  return {};
}

// Forget places of an untouched file; the tree of the value has none.
void forget_places(Tree& tree) {
  tree.place = {};
  if (auto* array = std::get_if<Tree::Array>(&tree.value)) {
    std::for_each(array->begin(), array->end(), forget_places);
  } else if (auto* table = std::get_if<Tree::Table>(&tree.value)) {
    for (Tree::Entry& entry : *table) {
      entry.place = {};
      forget_places(entry.value);
    }
  }
}

/// Finds the text member `name` of a described struct.
struct NameOf {
  std::string name;
  template <class T>
  void operator()(const Key& key, const T& member) {
    if constexpr (std::is_same_v<T, std::string>) {
      if (std::string_view(key.name) == "name") {
        name = member;
      }
    }
  }
};

/// What an element of a list may be called by: its name, or its kind.
template <class T>
std::vector<std::string> names_of(const T& element) {
  std::vector<std::string> names;
  if constexpr (Kinded<T>) {
    std::visit(
        [&](const auto& alternative) {
          names = names_of(alternative);
          names.emplace_back(alternative.kind);
        },
        variant_of(element));
  } else if constexpr (Described<T>) {
    NameOf found;
    T::describe(element, found);
    names.push_back(found.name);
  }
  return names;
}

// Walks down a scene to the member at a path and reads a value into it.
class Setter {
 public:
  Setter(Places& places, const Tree& value, std::string label)
      : reader_(places), value_(value), label_(std::move(label)) {}

  /// Throws every mistake that reading the value met.
  void throw_mistakes() const { reader_.throw_mistakes(); }

  template <class T>
  void set(T& member, const Key& key, const std::string& at, Path rest) {
    if (rest.empty()) {
      reader_.read(value_, key, at, member);
    } else if constexpr (is_optional<T>) {
      if (member) {
        set(*member, key, at, rest);
      } else {
        reader_.read(nested(rest), key, at, member);
      }
    } else if constexpr (is_vector<T>) {
      set_element(member, key, at, rest);
    } else if constexpr (Indirect<T>) {
      Held<T> held = member.empty() ? Held<T>() : *member;
      set(held, key, at, rest);
      member = T(std::move(held));
    } else if constexpr (Kinded<T>) {
      require(rest.front() != "kind", label_, at,
              ".kind cannot change alone: set the whole of it, ", at, "={kind = ...}");
      std::visit([&](auto& alternative) { set(alternative, key, at, rest); }, variant_of(member));
    } else if constexpr (Described<T>) {
      set_member(member, at, rest);
    } else if constexpr (std::is_same_v<T, Overrides>) {
      set_entry(member, rest);
    } else {
      require(false, label_, at, " has no parts, so there is no ", joined_path(at, rest.front()));
    }
  }

 private:
  /// Sets the member that the first word of a path names.
  struct MemberSetter {
    Setter& setter;
    const std::string& at;
    Path rest;
    bool found = false;
    std::vector<std::string> allowed{};

    template <class T>
    void operator()(const Key& key, T& member) {
      if (is_named(key)) {
        setter.set(member, key, joined_path(at, key.name), rest.subspan(1));
      }
    }
    bool is_named(const Key& key) {
      allowed.emplace_back(key.name);
      const bool named = !found && rest.front() == key.name;
      found = found || named;
      return named;
    }
  };

  template <Described T>
  void set_member(T& object, const std::string& at, Path rest) {
    MemberSetter visit{*this, at, rest};
    T::describe(object, visit);
    require(visit.found, label_, joined_path(at, rest.front()), " is no known key",
            suggestion(rest.front(), visit.allowed));
  }

  template <class T>
  void set_element(std::vector<T>& list, const Key& key, const std::string& at, Path rest) {
    const std::optional<std::size_t> index = element_at(called(list), key, at, rest.front());
    if (!index) {  // the one element of a list that need not be one
      set(list.front(), key, at, rest);
      return;
    }
    T element = list[*index];
    set(element, key, element_path(at, *index), rest.subspan(1));
    list[*index] = std::move(element);
  }

  template <class T>
  static ElementNames called(const std::vector<T>& list) {
    ElementNames names;
    for (const T& element : list) {
      names.push_back(names_of(element));
    }
    return names;
  }

  /// The element that a word of a path names by number or name, of elements that are called so.
  std::optional<std::size_t> element_at(const ElementNames& elements, const Key& key,
                                        const std::string& at, const std::string& word) const {
    std::size_t index = 0;
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, index);
    if (error != std::errc() || stop != end || word.empty()) {
      const std::vector<std::size_t> named = at_name(elements, word);
      if (named.empty() && key.single_allowed && elements.size() == 1) {
        return std::nullopt;
      }
      require(named.size() < 2, label_, joined_path(at, word), " could be any of ", named.size(),
              " entries: give its number, counted from 0");
      require(!named.empty(), label_, joined_path(at, word), " does not exist: ", at, " has ",
              elements.size(), " entries, counted from 0", listed(elements));
      index = named.front();
    }
    require(index < elements.size(), label_, element_path(at, index), " does not exist: ", at,
            " has ", elements.size(), " entries, counted from 0");
    return index;
  }

  void set_entry(Overrides& overrides, Path rest) const {
    std::string name;
    for (const std::string& word : rest) {
      name = joined_path(name, word);
    }
    std::erase_if(overrides.entries, [&](const Tree::Entry& entry) { return entry.name == name; });
    overrides.entries.push_back({name, {}, value_});
  }

  // {a = {b = value}} for the path a.b.
  Tree nested(Path path) const {
    Tree tree = value_;
    for (std::size_t k = path.size(); k-- > 0;) {
      tree = Tree{Tree::Table{{path[k], {}, std::move(tree)}}, {}};
    }
    return tree;
  }

  TreeReader reader_;
  const Tree& value_;
  std::string label_;
};

}  // namespace

void set_member(Scene& scene, const std::vector<std::string>& path, const Tree& value,
                const std::string& label) {
  Places places;
  places.source = label.empty() ? label : label.substr(0, label.size() - 2);
  Scene changed = scene;
  Setter setter(places, value, label);
  setter.set(changed, Key(""), "", path);
  setter.throw_mistakes();
  scene = std::move(changed);
}

std::vector<std::string> path_names(const std::string& path) {
  std::vector<std::string> names(1);
  for (std::size_t at = 0; at < path.size(); ++at) {
    const bool closes =
        path[at] == ']' && (at + 1 == path.size() || path[at + 1] == '.' || path[at + 1] == '[');
    if (path[at] == '.' || path[at] == '[') {
      names.emplace_back();
    } else if (!closes) {
      names.back() += path[at];
    }
  }
  return names;
}

void apply_override(Scene& scene, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  require(equals != std::string::npos && equals > 0, "--set needs key=value, got \"", assignment,
          "\"");
  const auto trimmed = [](const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    return begin == std::string::npos
               ? std::string()
               : text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
  };
  Tree value = value_of(trimmed(assignment.substr(equals + 1)));
  forget_places(value);
  const std::vector<std::string> names = path_names(trimmed(assignment.substr(0, equals)));
  Scene changed = scene;
  set_member(changed, names, value, "--set: ");
  if (scene.places) {
    auto places = std::make_shared<Places>(*scene.places);
    const std::string path = spelled_path(names);
    std::erase_if(places->at, [&](const auto& entry) {
      return entry.first == path || entry.first.starts_with(path + ".") ||
             entry.first.starts_with(path + "[");
    });
    changed.places = std::move(places);
  }
  scene = std::move(changed);
}

}  // namespace lapilli
