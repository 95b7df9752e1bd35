#include "lapilli/materials/function_solid.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "lapilli/core/require.hpp"

namespace lapilli {
namespace {

bool is_word(const std::string& name) {
  return !name.empty() && std::ranges::all_of(name, [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '_';
  });
}

constexpr const char* components[] = {"xx", "yy", "zz", "xy", "yz", "xz"};

}  // namespace

std::vector<StateVariable> FunctionSolid::state_variables() const {
  std::vector<StateVariable> all;
  for (const std::string& name : state) {
    all.push_back({name, "1"});
  }
  return all;
}

void check(const FunctionSolid& material) {
  check(material.elastic);
  require(static_cast<bool>(material.function), "function solid: needs a function");
  std::set<std::string> taken = {"position",    "velocity", "stress", "density", "displacement",
                                 "temperature", "volume",   "body",   "id"};
  for (const std::string& name : material.state) {
    require(is_word(name), "function solid: state must hold words of letters, digits and _, got '",
            name, "'");
    require(taken.insert(name).second, "function solid: state has '", name,
            "', which is taken already");
  }
}

FunctionLaw::FunctionLaw(const FunctionSolid& material)
    : function(material.function), names(material.state) {
  check(material);
}

void FunctionLaw::return_block(const PointBlock& block) const {
  function(block);
  for (std::size_t k = 0; k < block.stress.size(); ++k) {
    if (!std::isfinite(block.stress[k])) {
      throw RunError(message("the function of the solid of ", block.body, " gave ", block.stress[k],
                             " for stress ", components[k % 6], " of point ", k / 6, " of ",
                             block.rows, " it was called for"));
    }
  }
  for (std::size_t k = 0; k < block.state.size(); ++k) {
    if (!std::isfinite(block.state[k])) {
      throw RunError(message("the function of the solid of ", block.body, " gave ", block.state[k],
                             " for ", names[k % names.size()], " of point ", k / names.size(),
                             " of ", block.rows, " it was called for"));
    }
  }
}

}  // namespace lapilli
