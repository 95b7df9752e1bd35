#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace lapilli {

/// Gathers the mistakes of a scene, so that its author sees up to twenty of them at once.
class Mistakes {
 public:
  /// Run an action; keep the message of a std::invalid_argument and go on.
  template <class Action>
  void gather(const Action& action) {
    try {
      action();
    } catch (const std::invalid_argument& error) {
      add(error.what());
    }
  }
  void add(std::string mistake) { all_.push_back(std::move(mistake)); }

  /// One std::invalid_argument, a line for each mistake; nothing when there is none.
  void throw_if_any() const {
    constexpr std::size_t most = 20;
    if (all_.empty()) {
      return;
    }
    std::string text;
    for (std::size_t k = 0; k < all_.size() && k < most; ++k) {
      text += (k == 0 ? "" : "\n") + all_[k];
    }
    if (all_.size() > most) {
      text += "\nand " + std::to_string(all_.size() - most) + " more";
    }
    throw std::invalid_argument(text);
  }

 private:
  std::vector<std::string> all_;
};

}  // namespace lapilli
