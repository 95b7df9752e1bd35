#include "lapilli/output/json.hpp"

#include <charconv>
#include <cmath>

namespace lapilli {

std::string shortest(double value) {
  if (std::isnan(value)) {
    return "nan";
  }
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  return {digits, end};
}

JsonWriter& JsonWriter::key(std::string_view name) {
  item();
  quoted(name);
  text_ += ": ";
  after_key_ = true;
  return *this;
}

void JsonWriter::value(double number) {
  if (std::isfinite(number)) {
    json(shortest(number));
  } else if (std::isnan(number)) {
    json("null");
  } else {
    value(std::string_view(shortest(number)));
  }
}

void JsonWriter::value(Index number) { json(std::to_string(number)); }

void JsonWriter::value(bool truth) { json(truth ? "true" : "false"); }

void JsonWriter::value(std::string_view text) {
  item();
  quoted(text);
}

void JsonWriter::json(std::string_view made) {
  item();
  text_ += made;
}

void JsonWriter::begin(char bracket) {
  item();
  text_ += bracket;
  ++depth_;
  first_ = true;
}

void JsonWriter::end(char bracket) {
  --depth_;
  if (!first_) {
    line();
  }
  text_ += bracket;
  first_ = false;
}

/// What comes before a member or an element: a comma but before the first, and a new line.
void JsonWriter::item() {
  if (after_key_) {
    after_key_ = false;
    return;
  }
  if (depth_ > 0) {
    if (!first_) {
      text_ += ',';
    }
    line();
  }
  first_ = false;
}

void JsonWriter::line() {
  text_ += '\n';
  text_.append(2 * static_cast<std::size_t>(depth_), ' ');
}

void JsonWriter::quoted(std::string_view text) {
  text_ += '"';
  for (const char character : text) {
    const auto code = static_cast<unsigned char>(character);
    if (character == '"' || character == '\\') {
      text_ += '\\';
      text_ += character;
    } else if (character == '\n') {
      text_ += "\\n";
    } else if (character == '\t') {
      text_ += "\\t";
    } else if (code < 0x20) {
      text_ += "\\u00";
      text_ += "0123456789abcdef"[code >> 4];
      text_ += "0123456789abcdef"[code & 15];
    } else {
      text_ += character;
    }
  }
  text_ += '"';
}

}  // namespace lapilli
