#pragma once

#include <string>
#include <string_view>

#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {

/// The code of a kind of note; one that is not in the list of kinds does not compile.
class NoteCode {
 public:
  consteval NoteCode(const char* code) : code_(code) {  // NOLINT(google-explicit-constructor)
    for (const NoteKind& kind : note_kinds) {
      if (kind.code == code_) {
        return;
      }
    }
    throw "give the note an entry in core/note_kinds.hpp";
  }
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

/// A note of a kind, its words made of parts as those of message().
template <class... Parts>
Note note(NoteCode code, const Parts&... parts) {
  return {code, message(parts...)};
}

/// "the words [the.code]", as people read it.
inline std::string with_code(const Note& note) {
  return message(note.text, " [", note.code.text(), "]");
}

}  // namespace lapilli
