#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "lapilli/core/describe.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/core/value.hpp"
#include "lapilli/materials/over_temperature.hpp"
#include "lapilli/scene/member_types.hpp"
#include "lapilli/scene/stage.hpp"
#include "lapilli/scene/tree.hpp"
#include "lapilli/scene/tree_reader.hpp"

namespace lapilli {

/// Which members a written scene shows.
enum class Members { changed, all };

/// What becomes of members that no file can hold: functions and arrays given from a program.
enum class InMemory { refused, named };

/// Makes a tree of described structs, members in their order. Throws std::invalid_argument with the
/// path of a member that no file can hold, unless those are to be named.
class TreeWriter {
 public:
  explicit TreeWriter(Members members = Members::changed, InMemory in_memory = InMemory::refused)
      : members_(members), in_memory_(in_memory) {}

  template <class T>
  Tree write(const T& member, const Key& key, const std::string& path) const;

  template <Described T>
  Tree::Table write_struct(const T& object, const std::string& path) const;

 private:
  template <class T>
  Tree write_list(const std::vector<T>& list, const Key& key, const std::string& path) const;
  Tree write_number(double number, const Key& key, const std::string& path) const;
  Tree write_value(const Value& value, const Key& key, const std::string& path) const;
  Tree write_tensor(const SymmetricTensor& tensor, const Key& key, const std::string& path) const;
  Tree write_table(const TemperatureTable& table, const std::string& path) const;
  Tree no_file_form(const std::string& path, const char* what) const;

  Members members_;
  InMemory in_memory_;
};

template <class T>
Tree TreeWriter::write(const T& member, const Key& key, const std::string& path) const {
  if constexpr (std::is_same_v<T, bool> || std::is_same_v<T, std::string>) {
    return {member, {}};
  } else if constexpr (std::is_same_v<T, double>) {
    return write_number(member, key, path);
  } else if constexpr (std::is_integral_v<T>) {
    return {static_cast<Index>(member), {}};
  } else if constexpr (std::is_same_v<T, Value>) {
    return write_value(member, key, path);
  } else if constexpr (std::is_same_v<T, SymmetricTensor>) {
    return write_tensor(member, key, path);
  } else if constexpr (is_over_temperature<T>) {
    return member.varies() ? write_table(*member.table(), path)
                           : write(member.constant(), key, path);
  } else if constexpr (std::is_same_v<T, Overrides>) {
    return member.entries.empty() ? Tree{} : Tree{member.entries, {}};
  } else if constexpr (Named<T>) {
    return {std::string(name_of(member)), {}};
  } else if constexpr (is_optional<T>) {
    if (member) {
      return write(*member, key, path);
    }
    return *key.absent_word != 0 ? Tree{std::string(key.absent_word), {}} : Tree{};
  } else if constexpr (is_vector<T>) {
    return write_list(member, key, path);
  } else if constexpr (Indirect<T>) {
    return member.empty() ? Tree{} : write(*member, key, path);
  } else if constexpr (Kinded<T>) {
    return std::visit(
        [&](const auto& alternative) {
          Tree::Table table{{"kind", {}, {std::string(alternative.kind), {}}}};
          for (Tree::Entry& entry : write_struct(alternative, path)) {
            table.push_back(std::move(entry));
          }
          return Tree{std::move(table), {}};
        },
        variant_of(member));
  } else if constexpr (Described<T>) {
    return {write_struct(member, path), {}};
  } else if constexpr (is_function<T>) {
    return member ? no_file_form(path, "functions") : Tree{};
  } else {
    return no_file_form(path, "arrays");
  }
}

template <Described T>
Tree::Table TreeWriter::write_struct(const T& object, const std::string& path) const {
  Tree::Table defaults;
  if (members_ == Members::changed) {
    const T unchanged{};
    auto note = [&](const Key& key, const auto& member) {
      defaults.push_back({key.name, {}, write(member, key, path)});
    };
    T::describe(unchanged, note);
  }
  Tree::Table table;
  auto add = [&](const Key& key, const auto& member) {
    Tree tree = write(member, key, joined_path(path, key.name));
    const Tree::Entry* unchanged = find(defaults, key.name);
    if (!tree.is_absent() && (key.is_required || !unchanged || !same(tree, unchanged->value))) {
      table.push_back({key.name, {}, std::move(tree)});
    }
  };
  T::describe(object, add);
  return table;
}

template <class T>
Tree TreeWriter::write_list(const std::vector<T>& list, const Key& key,
                            const std::string& path) const {
  if (key.single_allowed && list.size() == 1) {
    return write(list.front(), key, path);
  }
  Tree::Array array;
  for (std::size_t k = 0; k < list.size(); ++k) {
    array.push_back(write(list[k], key, element_path(path, k)));
  }
  return {std::move(array), {}};
}

}  // namespace lapilli
