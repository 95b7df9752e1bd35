#include "lapilli/scene/tree.hpp"

#include <algorithm>
#include <bit>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

bool same_value(Tree::Absent, Tree::Absent) { return true; }
bool same_value(const Tree::Foreign& a, const Tree::Foreign& b) { return a.what == b.what; }
bool same_value(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same_value(const Tree::Array& a, const Tree::Array& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}
bool same_value(const Tree::Table& a, const Tree::Table& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Tree::Entry& left, const Tree::Entry& right) {
                      return left.name == right.name && same(left.value, right.value);
                    });
}
template <class T>
bool same_value(const T& a, const T& b) {
  return a == b;
}

}  // namespace

const Tree::Entry* find(const Tree::Table& table, const std::string& name) {
  for (const Tree::Entry& entry : table) {
    if (entry.name == name) {
      return &entry;
    }
  }
  return nullptr;
}

std::string in_words(const Tree& tree) {
  struct {
    std::string operator()(Tree::Absent) const { return "nothing"; }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(Index value) const { return message(value); }
    std::string operator()(double value) const { return message(value); }
    std::string operator()(const std::string& text) const {
      return text.size() > 40 ? "a long text" : "the text \"" + text + "\"";
    }
    std::string operator()(const Tree::Array& array) const {
      return message("a list of ", array.size());
    }
    std::string operator()(const Tree::Table&) const { return "a table"; }
    std::string operator()(const Tree::Foreign& foreign) const { return foreign.what; }
  } words;
  return std::visit(words, tree.value);
}

bool same(const Tree& a, const Tree& b) {
  return a.value.index() == b.value.index() &&
         std::visit(
             [&](const auto& left) {
               return same_value(left, std::get<std::decay_t<decltype(left)>>(b.value));
             },
             a.value);
}

}  // namespace lapilli
