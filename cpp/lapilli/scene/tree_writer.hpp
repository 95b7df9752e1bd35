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

  /// What a default struct holds for a member, as its documentation tells; absent where the member
  /// must be given, is a table, or holds tables.
  template <class T>
  static Tree write_default(const T& member, const Key& key);

 private:
  class MemberWriter;
  struct DefaultWriter;
  template <class T>
  Tree write_list(const std::vector<T>& list, const Key& key, const std::string& path) const;
  Tree write_number(double number, const Key& key, const std::string& path) const;
  Tree write_value(const Value& value, const Key& key, const std::string& path) const;
  Tree write_tensor(const SymmetricTensor& tensor, const Key& key, const std::string& path) const;
  Tree write_table(const TemperatureTable& table, const std::string& path) const;
  Tree no_file_form(const std::string& path, const char* what) const;
  static Tree with_kind(const char* kind, Tree::Table members);

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
          return with_kind(alternative.kind, write_struct(alternative, path));
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

/// Writes the members of one struct into a table.
class TreeWriter::MemberWriter {
 public:
  /// Members that are the same in `defaults` are left out.
  MemberWriter(const TreeWriter& writer, const std::string& path, const Tree::Table& defaults)
      : writer_(writer), path_(path), defaults_(defaults) {}

  template <class T>
  void operator()(const Key& key, const T& member) {
    add(key, writer_.write(member, key, joined_path(path_, key.name)));
  }
  Tree::Table take() { return std::move(table_); }

 private:
  void add(const Key& key, Tree tree);

  const TreeWriter& writer_;
  const std::string& path_;
  const Tree::Table& defaults_;
  Tree::Table table_;
};

/// Notes the members of a default struct.
struct TreeWriter::DefaultWriter {
  const TreeWriter& writer;
  const std::string& path;
  Tree::Table table{};

  template <class T>
  void operator()(const Key& key, const T& member) {
    table.push_back({key.name, {}, writer.write(member, key, path)});
  }
};

template <Described T>
Tree::Table TreeWriter::write_struct(const T& object, const std::string& path) const {
  DefaultWriter defaults{*this, path};
  if (members_ == Members::changed) {
    const T unchanged{};
    T::describe(unchanged, defaults);
  }
  MemberWriter members(*this, path, defaults.table);
  T::describe(object, members);
  return members.take();
}

template <class T>
Tree TreeWriter::write_default(const T& member, const Key& key) {
  if constexpr (!holds_structs<T>) {
    if (!key.is_required) {
      Tree tree = TreeWriter(Members::all, InMemory::named).write(member, key, key.name);
      return tree.table() ? Tree{} : tree;
    }
  }
  return {};
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
