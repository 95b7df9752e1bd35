#include "lapilli/scene/body.hpp"

#include <type_traits>

namespace lapilli {

std::vector<Solid> solids_in(const Body& body) {
  std::vector<Solid> solids;
  for (const Material& material : body.material) {
    std::visit(
        [&](const auto& known) {
          if constexpr (HasElasticPart<std::remove_cvref_t<decltype(known)>>) {
            solids.emplace_back(known);
          }
        },
        material);
  }
  return solids;
}

}  // namespace lapilli
