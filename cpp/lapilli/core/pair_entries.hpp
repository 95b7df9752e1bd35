#pragma once

#include <string>
#include <vector>

namespace lapilli {

/// Which entry of a list of settings is about each pair of bodies.
class PairEntries {
 public:
  /// `bodies` by entry: two names of `names`, or none for every pair that no other entry names.
  /// Throws std::invalid_argument that begins with `where` ("heat.contacts") for names that are
  /// unknown or given twice.
  PairEntries(const std::string& where, const std::vector<std::vector<std::string>>& bodies,
              const std::vector<std::string>& names);

  /// The entry that names a pair; -1 where none does.
  int own(std::size_t a, std::size_t b) const;
  /// The same, or the entry of all other pairs.
  int of(std::size_t a, std::size_t b) const { return own(a, b) >= 0 ? own(a, b) : other_; }

 private:
  std::size_t count_;
  std::vector<int> entry_;
  int other_ = -1;
};

/// The name of a body, "body 2" for one without.
std::string name_or_number(const std::string& name, std::size_t number);
std::vector<std::string> names_or_numbers(std::vector<std::string> names);

}  // namespace lapilli
