#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/materials/over_temperature.hpp"
#include "lapilli/scene/member_types.hpp"
#include "lapilli/scene/mistakes.hpp"
#include "lapilli/scene/stage.hpp"
#include "lapilli/scene/tree.hpp"

namespace lapilli {

/// Where every key of a scene stood in its file, by path ("bodies[0].shape").
struct Places {
  std::string source;  // file name
  std::map<std::string, Place> at;
};

/// "ring.toml:12:3: " for the key at `path`, or for the nearest table around it; "" when unknown.
std::string place_text(const Places* places, std::string path);

/// "a, b, c".
std::string joined(const std::vector<std::string>& words);

/// The end of a message about a word that is not among `allowed`:
/// "; did you mean 'cell'? allowed: lower, upper, cell".
std::string suggestion(const std::string& word, const std::vector<std::string>& allowed);

/// The path of a member: "grid" and "cell" give "grid.cell".
inline std::string joined_path(const std::string& path, const std::string& name) {
  return path.empty() ? name : path + "." + name;
}

/// The path of an element of a list: "bodies" and 0 give "bodies[0]".
inline std::string element_path(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

/// Fills described structs from a tree. Every mistake says where it stands, the path of the key,
/// what was given and what is allowed; mistakes in members of a struct are gathered.
class TreeReader {
 public:
  explicit TreeReader(Places& places) : places_(places) {}

  /// Throws the mistakes gathered so far as one std::invalid_argument, a line each.
  void throw_mistakes() const { mistakes_.throw_if_any(); }

  /// Read a member of any supported type.
  template <class T>
  void read(const Tree& tree, const Key& key, const std::string& path, T& member);

  /// Read the members of a struct from a table; `skip` is a key that belongs to somebody else.
  template <Described T>
  void read_struct(const Tree& tree, const std::string& path, T& object, const char* skip = "");

 private:
  [[noreturn]] void fail(const Tree& tree, const std::string& path, const std::string& what) const {
    fail(tree.place, path, what);
  }
  [[noreturn]] void fail(Place place, const std::string& path, const std::string& what) const;

  void check_in_range(const Tree& tree, const Key& key, const std::string& path,
                      double number) const;
  void read_number(const Tree& tree, const Key& key, const std::string& path, double& number) const;
  void read_integer(const Tree& tree, const Key& key, const std::string& path, Index& number) const;
  void read_text(const Tree& tree, const Key& key, const std::string& path,
                 std::string& text) const;
  Table table_of_file(const Tree::Table& table, const Tree::Entry& file, const Key& key,
                      const std::string& path);
  /// The lists of numbers `by` and "values" of a table, as many of each.
  void read_columns(const Tree& tree, const Key& by, const Key& key, const std::string& path,
                    std::vector<double>& places, std::vector<double>& values) const;
  void read_value(const Tree& tree, const Key& key, const std::string& path, Value& value);
  TemperatureTable read_temperature_table(const Tree& tree, const Key& key,
                                          const std::string& path);
  void read_tensor(const Tree& tree, const Key& key, const std::string& path,
                   SymmetricTensor& tensor) const;
  const Tree::Table& table_of(const Tree& tree, const std::string& path) const;
  void check_length(const Tree& tree, const Key& key, const std::string& path,
                    std::size_t length) const;
  /// Gathers the unknown keys of a table; returns the known ones that they were meant for.
  std::vector<std::string> check_known(const Tree::Table& table, const std::string& path,
                                       const std::vector<std::string>& allowed);

  class MemberReader;
  /// `read`, whose mistakes are kept.
  template <class T>
  void read_or_gather(const Tree& tree, const Key& key, const std::string& path, T& member);
  template <Named T>
  void read_name(const Tree& tree, const std::string& path, T& member) const;
  [[noreturn]] void fail_name(const Tree& tree, const std::string& path,
                              const std::vector<std::string>& allowed) const;
  template <class T>
  void read_list(const Tree& tree, const Key& key, const std::string& path, std::vector<T>& list);
  template <Kinded T>
  void read_kind(const Tree& tree, const std::string& path, T& member);
  /// The word under "kind" of a table, one of `allowed`.
  std::string kind_of(const Tree& tree, const std::string& path,
                      const std::vector<std::string>& allowed) const;

  Places& places_;
  Mistakes mistakes_;
};

template <class T>
void TreeReader::read(const Tree& tree, const Key& key, const std::string& path, T& member) {
  if constexpr (std::is_same_v<T, bool>) {
    const bool* value = std::get_if<bool>(&tree.value);
    if (!value) {
      fail(tree, path, message("must be true or false, got ", in_words(tree)));
    }
    member = *value;
  } else if constexpr (std::is_same_v<T, double>) {
    read_number(tree, key, path, member);
  } else if constexpr (std::is_integral_v<T>) {
    Index number = 0;
    Key bounded = key;
    bounded.least = std::max(key.least, static_cast<double>(std::numeric_limits<T>::min()));
    bounded.most = std::min(key.most, static_cast<double>(std::numeric_limits<T>::max()));
    read_integer(tree, bounded, path, number);
    member = static_cast<T>(number);
  } else if constexpr (std::is_same_v<T, std::string>) {
    read_text(tree, key, path, member);
  } else if constexpr (std::is_same_v<T, Value>) {
    read_value(tree, key, path, member);
  } else if constexpr (std::is_same_v<T, SymmetricTensor>) {
    read_tensor(tree, key, path, member);
  } else if constexpr (is_over_temperature<T>) {
    if (tree.table()) {
      member = read_temperature_table(tree, key, path);
      return;
    }
    typename T::constant_type constant{};
    read(tree, key, path, constant);
    member = constant;
  } else if constexpr (std::is_same_v<T, Overrides>) {
    member.entries = table_of(tree, path);
  } else if constexpr (Named<T>) {
    read_name(tree, path, member);
  } else if constexpr (is_optional<T>) {
    const std::string* word = tree.string();
    if (word && *key.absent_word != 0 && *word == key.absent_word) {
      member.reset();
    } else {
      typename T::value_type value{};
      read(tree, key, path, value);
      member = std::move(value);
    }
  } else if constexpr (is_vector<T>) {
    read_list(tree, key, path, member);
  } else if constexpr (Indirect<T>) {
    Held<T> held;
    read(tree, key, path, held);
    member = T(std::move(held));
  } else if constexpr (Kinded<T>) {
    read_kind(tree, path, member);
  } else if constexpr (Described<T>) {
    read_struct(tree, path, member);
  } else {
    fail(tree, path, "can be given from a program only, not in a file");
  }
}

/// Reads the members of one struct from a table.
class TreeReader::MemberReader {
 public:
  MemberReader(TreeReader& reader, const Tree& tree, const std::string& path,
               const std::vector<std::string>& allowed)
      : reader_(reader),
        tree_(tree),
        path_(path),
        table_(reader.table_of(tree, path)),
        misspelt_(reader.check_known(table_, path, allowed)) {}

  template <class T>
  void operator()(const Key& key, T& member) {
    const std::string path = joined_path(path_, key.name);
    if (const Tree* given = find_value(key, path)) {
      reader_.read_or_gather(*given, key, path, member);
    }
  }

 private:
  /// What the table holds; null where it holds nothing, which may be a mistake.
  const Tree* find_value(const Key& key, const std::string& path);

  TreeReader& reader_;
  const Tree& tree_;
  const std::string& path_;
  const Tree::Table& table_;
  std::vector<std::string> misspelt_;
};

template <class T>
void TreeReader::read_or_gather(const Tree& tree, const Key& key, const std::string& path,
                                T& member) {
  mistakes_.gather([&] { read(tree, key, path, member); });
}

template <Described T>
void TreeReader::read_struct(const Tree& tree, const std::string& path, T& object,
                             const char* skip) {
  MemberNames allowed;
  if (*skip != 0) {
    allowed.names.emplace_back(skip);
  }
  T::describe(object, allowed);
  MemberReader members(*this, tree, path, allowed.names);
  T::describe(object, members);
}

template <Named T>
void TreeReader::read_name(const Tree& tree, const std::string& path, T& member) const {
  std::vector<std::string> allowed;
  const std::string* word = tree.string();
  for (const auto& [value, name] : Names<T>::values) {
    if (word && *word == name) {
      member = value;
      return;
    }
    allowed.emplace_back(name);
  }
  fail_name(tree, path, allowed);
}

template <class T>
void TreeReader::read_list(const Tree& tree, const Key& key, const std::string& path,
                           std::vector<T>& list) {
  list.clear();
  const Tree::Array* array = tree.array();
  if (!array && !key.single_allowed) {
    fail(tree, path, message("must be a list, got ", in_words(tree)));
  }
  check_length(tree, key, path, array ? array->size() : 1);
  for (std::size_t k = 0; k < (array ? array->size() : 1); ++k) {
    const Tree& element = array ? (*array)[k] : tree;
    const std::string here = array ? element_path(path, k) : path;
    places_.at[here] = element.place;
    T value{};
    Key row = key;
    if constexpr (is_vector<T>) {
      row.shortest = 0;
      row.longest = std::numeric_limits<int>::max();
    }
    read_or_gather(element, row, here, value);
    list.push_back(std::move(value));
  }
}

template <Kinded T>
void TreeReader::read_kind(const Tree& tree, const std::string& path, T& member) {
  std::vector<std::string> allowed;
  for_each_kind<T>([&](auto type) { allowed.emplace_back(decltype(type)::type::kind); });
  const std::string word = kind_of(tree, path, allowed);
  for_each_kind<T>([&](auto type) {
    using Alternative = typename decltype(type)::type;
    if (word == Alternative::kind) {
      Alternative value{};
      read_struct(tree, path, value, "kind");
      variant_of(member) = std::move(value);
    }
  });
}

}  // namespace lapilli
