#pragma once

#include <limits>
#include <type_traits>

namespace lapilli {

/// How one member of a plain struct is shown to users: its name in TOML, Python and the run record,
/// its unit, what it means and which values are allowed. A struct is described once, by
///
///     template <class Self, class Visitor>
///     static void describe(Self& self, Visitor& visit) {
///       visit(Key("inner").unit("m").positive().text("radius of the hole"), self.inner);
///     }
///
/// and every reader, writer and binding is a visitor.
struct Key {
  constexpr explicit Key(const char* key_name) : name(key_name) {}

  constexpr Key unit(const char* of) const { return with(&Key::of_unit, of); }
  constexpr Key text(const char* says) const { return with(&Key::meaning, says); }
  constexpr Key positive() const { return range(0.0, infinity(), true); }
  constexpr Key non_negative() const { return range(0.0, infinity(), false); }
  /// Least and largest allowed value; `open` excludes the least one.
  constexpr Key range(double from, double to, bool open_below = false) const {
    Key key = *this;
    key.least = from;
    key.most = to;
    key.open = open_below;
    return key;
  }
  /// The member must be given: its default is no usable value.
  constexpr Key required() const {
    Key key = *this;
    key.is_required = true;
    return key;
  }

  /// Infinity is allowed: "no limit".
  constexpr Key or_infinite() const {
    Key key = *this;
    key.infinity_allowed = true;
    return key;
  }
  /// A text that names a file, from the folder of the scene file where it is relative.
  constexpr Key file() const {
    Key key = *this;
    key.names_file = true;
    return key;
  }
  /// A list that may also be written as its one element.
  constexpr Key one_or_many() const {
    Key key = *this;
    key.single_allowed = true;
    return key;
  }
  /// How many numbers a list holds.
  constexpr Key length(int least_length, int most_length) const {
    Key key = *this;
    key.shortest = least_length;
    key.longest = most_length;
    return key;
  }
  /// The word that stands for an optional member that is not set: "auto".
  constexpr Key absent(const char* word) const { return with(&Key::absent_word, word); }

  const char* name;
  const char* of_unit = "";
  const char* meaning = "";
  double least = -infinity();
  double most = infinity();
  bool open = false;
  bool is_required = false;
  bool infinity_allowed = false;
  bool names_file = false;
  bool single_allowed = false;
  int shortest = 0;
  int longest = std::numeric_limits<int>::max();
  const char* absent_word = "";

 private:
  static constexpr double infinity() { return std::numeric_limits<double>::infinity(); }
  constexpr Key with(const char* Key::*member, const char* value) const {
    Key key = *this;
    key.*member = value;
    return key;
  }
};

/// The names of an enumeration, specialised beside each one:
///
///     template <>
///     struct Names<Transfer> {
///       static constexpr std::pair<Transfer, const char*> values[] = {{Transfer::flip, "flip"},
///       ...};
///     };
template <class Enum>
struct Names;

/// The name of an enumerator.
template <class Enum>
constexpr const char* name_of(Enum value) {
  for (const auto& [candidate, name] : Names<Enum>::values) {
    if (candidate == value) {
      return name;
    }
  }
  return "?";
}

}  // namespace lapilli
