// Notes with and without a code. Compiled by the tests only to see what the compiler says.
#include <vector>

#include "lapilli/core/note_kinds.hpp"

namespace lapilli {

std::vector<Note> sample() {
#if defined(CODE_KNOWN)
  return {note("scene.no-effect", "one ", 2)};
#elif defined(CODE_UNKNOWN)
  return {note("scene.unheard-of", "one ", 2)};
#else
  return {message("one ", 2)};
#endif
}

}  // namespace lapilli
