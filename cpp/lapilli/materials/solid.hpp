#pragma once

#include <variant>

#include "lapilli/materials/mohr_coulomb.hpp"

namespace lapilli {

/// Any solid that momentum can move. A new model is one more alternative, its elastic part, its
/// check, and its return over a block (mpm/dynamics/stress_block.cpp).
using Solid = std::variant<LinearElastic, MohrCoulomb>;

inline const LinearElastic& elastic_part(const LinearElastic& material) { return material; }
inline const LinearElastic& elastic_part(const MohrCoulomb& material) { return material.elastic; }
inline const LinearElastic& elastic_part(const Solid& material) {
  return std::visit([](const auto& solid) -> const LinearElastic& { return elastic_part(solid); },
                    material);
}

inline void check(const Solid& material) {
  std::visit([](const auto& solid) { check(solid); }, material);
}

}  // namespace lapilli
