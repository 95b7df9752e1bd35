#pragma once

#include <string>
#include <string_view>

#include "lapilli/core/require.hpp"

namespace lapilli {

/// The code of a kind of note. Only those in the list of note_kinds.hpp compile.
class NoteCode {
 public:
  consteval NoteCode(const char* code);  // NOLINT(google-explicit-constructor)
  constexpr std::string_view text() const { return code_; }

 private:
  std::string_view code_;
};

/// What the user should know of a scene or a run: words, and the code that stays while they change.
struct Note {
  NoteCode code;
  std::string text;

  /// Read as its words; words alone are no note.
  operator const std::string&() const { return text; }  // NOLINT(google-explicit-constructor)
  bool operator==(const Note& other) const { return text == other.text; }
};

/// "the words [the.code]", as people read it.
inline std::string with_code(const Note& note) {
  return message(note.text, " [", note.code.text(), "]");
}

}  // namespace lapilli
