#pragma once

#include <string>
#include <string_view>

#include "lapilli/core/vector.hpp"

namespace lapilli {

/// The shortest text that reads back as the same number; "nan", "inf" and "-inf" for the others.
std::string shortest(double value);

/// Writes one JSON value, indented by two blanks. Numbers come back bit by bit when read; JSON has
/// no NaN or infinity, so these become the texts "nan", "inf", "-inf". Texts must be UTF-8. Calls
/// must nest as the value does: a key before each member, an end for each begin.
class JsonWriter {
 public:
  void begin_object() { begin('{'); }
  void end_object() { end('}'); }
  void begin_array() { begin('['); }
  void end_array() { end(']'); }

  JsonWriter& key(std::string_view name);
  void value(double number);
  void value(Index number);
  void value(int number) { value(static_cast<Index>(number)); }
  void value(bool truth);
  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  /// JSON made elsewhere, taken as it is.
  void json(std::string_view made);

  /// One member of an object.
  template <class T>
  void member(std::string_view name, const T& content) {
    key(name).value(content);
  }

  const std::string& text() const { return text_; }

 private:
  void begin(char bracket);
  void end(char bracket);
  void item();
  void line();
  void quoted(std::string_view text);

  std::string text_;
  int depth_ = 0;
  bool first_ = true, after_key_ = false;
};

}  // namespace lapilli
