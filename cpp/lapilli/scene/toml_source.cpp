#include "lapilli/scene/toml_source.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <istream>
#include <streambuf>

#include "lapilli/core/interruption.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

constexpr std::uintmax_t largest_text = std::uintmax_t{1} << 30;  // bytes

/// Hands out a text in pieces, so that reading a long one can be stopped.
class TextInPieces : public std::streambuf {
 public:
  explicit TextInPieces(std::string_view text) : text_(text) {}

  /// The parser makes a mistake of the text of whatever comes through it.
  void rethrow_what_stopped() const {
    if (stopped_) {
      std::rethrow_exception(stopped_);
    }
  }

 private:
  int_type underflow() override {
    try {
      allow_interruption();
    } catch (...) {
      stopped_ = std::current_exception();
      throw;
    }
    const std::string_view piece = text_.substr(next_, std::size_t{1} << 16);
    next_ += piece.size();
    char* const begin = const_cast<char*>(piece.data());  // nobody writes here
    setg(begin, begin, begin + piece.size());
    return piece.empty() ? traits_type::eof() : traits_type::to_int_type(*begin);
  }

  // The parser looks for a byte-order mark and goes back.
  pos_type seekoff(off_type by, std::ios::seekdir from, std::ios::openmode which) override {
    const auto here = static_cast<off_type>(next_) - (egptr() - gptr());
    return from == std::ios::end ? pos_type(off_type(-1))
                                 : seekpos(from == std::ios::cur ? here + by : by, which);
  }

  pos_type seekpos(pos_type to, std::ios::openmode) override {
    next_ = std::min(static_cast<std::size_t>(to), text_.size());
    setg(nullptr, nullptr, nullptr);
    return to;
  }

  std::string_view text_;
  std::size_t next_ = 0;
  std::exception_ptr stopped_;
};

Place place_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Tree tree_of(const toml::node& node) {
  Tree tree;
  tree.place = place_of(node.source());
  if (const auto* table = node.as_table()) {
    Tree::Table entries;
    for (auto&& [key, value] : *table) {
      entries.push_back({std::string(key.str()), place_of(key.source()), tree_of(value)});
    }
    tree.value = std::move(entries);
  } else if (const auto* array = node.as_array()) {
    Tree::Array elements;
    allow_interruption();
    for (auto&& element : *array) {
      elements.push_back(tree_of(element));
    }
    tree.value = std::move(elements);
  } else if (const auto* text = node.as_string()) {
    tree.value = text->get();
  } else if (const auto* integer = node.as_integer()) {
    tree.value = static_cast<Index>(integer->get());
  } else if (const auto* number = node.as_floating_point()) {
    tree.value = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    tree.value = boolean->get();
  } else {
    tree.value = Tree::Foreign{node.is_time() ? "a time of day" : "a date"};
  }
  return tree;
}

}  // namespace

Tree parse_toml(std::string_view text, const std::string& name) {
  TextInPieces pieces(text);
  std::istream stream(&pieces);
  stream.exceptions(std::ios::badbit);
  try {
    const toml::table table = toml::parse(stream, name);
    return tree_of(table);
  } catch (const toml::parse_error& error) {
    pieces.rethrow_what_stopped();
    const Place place = place_of(error.source());
    throw std::invalid_argument(message(name, ":", place.line, ":", place.column,
                                        ": no valid TOML: ", std::string(error.description())));
  } catch (const std::logic_error& error) {  // see toml_implementation.cpp
    throw std::invalid_argument(message(name, ": no valid TOML: ", error.what()));
  }
}

std::string read_text(const std::string& path) {
  std::error_code ignored;
  require(std::filesystem::exists(path, ignored), path, ": there is no such file");
  require(std::filesystem::is_regular_file(path, ignored), path, ": this is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  require(!ignored && size <= largest_text, path, ": has ", size,
          " bytes, more than the 1 GiB of a scene file that are read");
  std::ifstream file(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');  // no more: /proc/kmsg never ends
  file.read(text.data(), static_cast<std::streamsize>(size));
  require(file.good() || file.eof(), path, ": the file cannot be read");
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

}  // namespace lapilli
