#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "convert_scalars.hpp"

namespace lapilli::python {

/// None, or the key's word for it ("auto"), where it is not set.
template <class Member>
struct Convert<std::optional<Member>> {
  static constexpr bool keeps_object = Convert<Member>::keeps_object;
  static std::string type_name() { return Convert<Member>::type_name() + " | None"; }
  static void load(const Where& where, py::handle given, std::optional<Member>& member) {
    member.reset();
    const std::string word = where.key.absent_word;
    const bool absent = given.is_none() || (!word.empty() && PyUnicode_Check(given.ptr()) &&
                                            std::string(py::str(given)) == word);
    if (!absent) {
      Convert<Member>::load(where, given, member.emplace());
    }
  }
  static py::object show(const Key& key, const std::optional<Member>& member) {
    if (member) {
      return Convert<Member>::show(key, *member);
    }
    return *key.absent_word == '\0' ? py::object(py::none()) : py::object(py::str(key.absent_word));
  }
};

/// The elements of any sequence or array that is not text.
inline std::vector<py::object> elements(const Where& where, py::handle given,
                                        const std::string& expected) {
  if (PyUnicode_Check(given.ptr()) || PyDict_Check(given.ptr()) ||
      !py::isinstance<py::iterable>(given)) {
    where.refuse(expected, given);
  }
  std::vector<py::object> all;
  for (py::handle element : given) {
    all.push_back(py::reinterpret_borrow<py::object>(element));
  }
  return all;
}

template <class Member>
struct Convert<std::vector<Member>> {
  static constexpr bool keeps_object = Convert<Member>::keeps_object;
  static std::string type_name() {
    return (keeps_object ? "list[" : "collections.abc.Sequence[") + Convert<Member>::type_name() +
           "]";
  }
  static void load(const Where& where, py::handle given, std::vector<Member>& member) {
    member.clear();
    if (where.key.single_allowed && !PyList_Check(given.ptr()) && !PyTuple_Check(given.ptr()) &&
        !(py::isinstance<py::array>(given) && given.cast<py::array>().ndim() > 0)) {
      Convert<Member>::load(where, given, member.emplace_back());
      return;
    }
    const auto all = elements(where, given, "a list");
    check_length(where.key, static_cast<Index>(all.size()), where.owner);
    for (const py::object& element : all) {
      Where inside = where;
      inside.key = inside.key.length(0, std::numeric_limits<int>::max());
      if constexpr (keeps_object) {
        inside.key.name = "";
        inside.owner = message(where.path(), "[", member.size(), "]");
      }
      Convert<Member>::load(inside, element, member.emplace_back());
    }
  }
  static py::object show(const Key& key, const std::vector<Member>& member) {
    if (key.single_allowed && member.size() == 1) {
      return Convert<Member>::show(key, member.front());
    }
    py::list all;
    for (const Member& element : member) {
      all.append(Convert<Member>::show(key, element));
    }
    return keeps_object ? py::object(all) : py::object(py::tuple(all));
  }
};

template <std::size_t Size>
struct Convert<std::array<double, Size>> {
  static constexpr bool keeps_object = false;
  static std::string type_name() { return "collections.abc.Sequence[float]"; }
  static void load(const Where& where, py::handle given, std::array<double, Size>& member) {
    const std::string expected = message("a list of ", Size, " numbers");
    const auto all = elements(where, given, expected);
    if (all.size() != Size) {
      where.refuse(expected, given);
    }
    for (std::size_t k = 0; k < Size; ++k) {
      Convert<double>::load(where, all[k], member[k]);
    }
  }
  static py::object show(const Key&, const std::array<double, Size>& member) {
    py::tuple all(Size);
    for (std::size_t k = 0; k < Size; ++k) {
      all[k] = member[k];
    }
    return all;
  }
};

/// Reads the one of a variant's alternatives that `given` is an object of; false when it is none.
template <class... Members>
bool load_alternative(const Where& where, py::handle given, std::variant<Members...>& member) {
  const auto load_one = [&]<class Member>(std::type_identity<Member>) {
    if (!Convert<Member>::accepts(given)) {
      return false;
    }
    Convert<Member>::load(where, given, member.template emplace<Member>());
    return true;
  };
  return (load_one(std::type_identity<Members>()) || ...);
}

template <class... Members>
struct Convert<std::variant<Members...>> {
  static constexpr bool keeps_object = true;
  static std::string type_name() {
    std::string names;
    ((names += (names.empty() ? "" : " | ") + Convert<Members>::type_name()), ...);
    return names;
  }
  static void load(const Where& where, py::handle given, std::variant<Members...>& member) {
    if (!load_alternative(where, given, member)) {
      where.refuse(type_name(), given);
    }
  }
  static py::object show(const Key& key, const std::variant<Members...>& member) {
    return std::visit(
        [&](const auto& held) { return Convert<std::decay_t<decltype(held)>>::show(key, held); },
        member);
  }
};

}  // namespace lapilli::python
