#include <stdexcept>

// Some malformed files break what the parser assumes of its own state. As an assertion that ends
// the process, and without assertions its behaviour is undefined: here it is an error like any
// other.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wterminate"  // a few of its functions may not throw
#endif
#undef NDEBUG
#define TOML_ASSERT(expression)        \
  ((expression) ? static_cast<void>(0) \
                : throw std::logic_error("the parser lost its way (a stray byte or quote)"))
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
