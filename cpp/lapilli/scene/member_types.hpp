#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "lapilli/core/describe.hpp"

namespace lapilli {

// What visitors of describe() need to know about the type of a member. A visitor is a class of its
// own, not a lambda of the function that visits: its body is then compiled once for every type of
// member, not once for every member of every struct.

/// A visitor that does nothing; it also stands for any visitor in the concepts below.
struct IgnoreMembers {
  template <class T>
  void operator()(const Key&, T&) {}
};

/// Any member: a visitor that takes one looks at keys only.
struct AnyMember {
  template <class T>
  AnyMember(const T&) {}  // NOLINT: whatever there is
};

/// Gathers the names of the members of described structs.
struct MemberNames {
  std::vector<std::string> names;
  void operator()(const Key& key, AnyMember);
};

/// A struct with describe().
template <class T>
concept Described = requires {
  &T::template describe<T, IgnoreMembers>;
};

/// An enumeration with names.
template <class T>
concept Named = std::is_enum_v<T> && requires {
  Names<T>::values;
};

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// A function from a program.
template <class T>
inline constexpr bool is_function = false;
template <class T>
inline constexpr bool is_function<std::function<T>> = true;

/// The std::variant that `kinded` is or derives from.
template <class... T>
std::variant<T...>& variant_of(std::variant<T...>& kinded) {
  return kinded;
}
template <class... T>
const std::variant<T...>& variant_of(const std::variant<T...>& kinded) {
  return kinded;
}

/// A variant of described structs, told apart by their `kind`, or a struct that derives from one.
template <class T>
concept Kinded = requires(T& t) {
  variant_of(t);
};

/// A value held elsewhere, perhaps not given: what lets a struct contain its own kind.
template <class T>
concept Indirect = !std::is_pointer_v<T> && requires(const T& t) {
  { t.empty() } -> std::same_as<bool>;
  requires Kinded<std::remove_cvref_t<decltype(*t)>>;
};
template <Indirect T>
using Held = std::remove_cvref_t<decltype(*std::declval<const T&>())>;

/// Whether a member is, or lists, structs with keys of their own.
template <class T>
inline constexpr bool holds_structs = Described<T> || Kinded<T> || Indirect<T>;
template <class T>
inline constexpr bool holds_structs<std::optional<T>> = holds_structs<T>;
template <class T>
inline constexpr bool holds_structs<std::vector<T>> = holds_structs<T>;

/// Call action(std::type_identity<Alternative>()) for every alternative of a variant type.
template <class... T, class Action>
void for_each_alternative(const std::variant<T...>*, const Action& action) {
  (action(std::type_identity<T>()), ...);
}
template <Kinded T, class Action>
void for_each_kind(const Action& action) {
  using Variant = std::remove_cvref_t<decltype(variant_of(std::declval<T&>()))>;
  for_each_alternative(static_cast<const Variant*>(nullptr), action);
}

}  // namespace lapilli
