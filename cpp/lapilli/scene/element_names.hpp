#pragma once

#include <string>
#include <vector>

namespace lapilli {

/// What each element of a list may be called by: its name, then its kind.
using ElementNames = std::vector<std::vector<std::string>>;

/// The entries called `word`; by their kind only where none has that name.
inline std::vector<std::size_t> at_name(const ElementNames& elements, const std::string& word) {
  std::vector<std::size_t> named, of_kind;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const std::vector<std::string>& names = elements[k];
    if (!names.empty() && names.front() == word) {
      named.push_back(k);
    } else if (!names.empty() && names.back() == word) {
      of_kind.push_back(k);
    }
  }
  return named.empty() ? of_kind : named;
}

/// "; they are called clay, gravel".
inline std::string listed(const ElementNames& elements) {
  std::string text;
  for (const std::vector<std::string>& names : elements) {
    if (!names.empty()) {
      const std::string& name = names.front().empty() ? names.back() : names.front();
      text += name.empty() ? "" : (text.empty() ? "; they are called " : ", ") + name;
    }
  }
  return text;
}

}  // namespace lapilli
