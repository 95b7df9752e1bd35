#include "lapilli/core/pair_entries.hpp"

#include <algorithm>

#include "lapilli/core/allowed.hpp"
#include "lapilli/core/require.hpp"

namespace lapilli {

PairEntries::PairEntries(const std::string& where,
                         const std::vector<std::vector<std::string>>& bodies,
                         const std::vector<std::string>& names)
    : count_(names.size()), entry_(count_ * count_, -1) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const std::string place = message(where, ".", k, ".bodies");
    if (bodies[k].empty()) {
      require(other_ < 0, place, " is empty, as in entry ", other_,
              ": one entry may be about all other pairs");
      other_ = static_cast<int>(k);
      continue;
    }
    require(bodies[k].size() == 2, place, " needs the names of two bodies, or none, got ",
            bodies[k].size());
    std::size_t body[2];
    for (std::size_t side = 0; side < 2; ++side) {
      const auto found = std::find(names.begin(), names.end(), bodies[k][side]);
      require(found != names.end(), place, ": ",
              found != names.end() ? "" : unknown_name("body", bodies[k][side], names));
      body[side] = static_cast<std::size_t>(found - names.begin());
    }
    require(body[0] != body[1], place, " names ", names[body[0]],
            " twice: a body has no contact with itself");
    int& entry = entry_[std::min(body[0], body[1]) * count_ + std::max(body[0], body[1])];
    require(entry < 0, place, ": ", names[body[0]], " and ", names[body[1]],
            " have an entry already, ", entry);
    entry = static_cast<int>(k);
  }
}

int PairEntries::own(std::size_t a, std::size_t b) const {
  return entry_[std::min(a, b) * count_ + std::max(a, b)];
}

std::string name_or_number(const std::string& name, std::size_t number) {
  return name.empty() ? message("body ", number) : name;
}

std::vector<std::string> names_or_numbers(std::vector<std::string> names) {
  for (std::size_t k = 0; k < names.size(); ++k) {
    names[k] = name_or_number(names[k], k);
  }
  return names;
}

}  // namespace lapilli
