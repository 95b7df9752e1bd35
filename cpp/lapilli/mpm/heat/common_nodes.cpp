#include "lapilli/mpm/heat/common_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lapilli/core/in_brackets.hpp"
#include "lapilli/core/note_kinds.hpp"
#include "lapilli/core/require.hpp"
#include "lapilli/geometry/come_near.hpp"
#include "lapilli/mpm/heat/cut_bodies.hpp"

namespace lapilli {
namespace {

constexpr double reach = 1.5;  // cells, within which bodies share nodes

bool are_near(const HeatBody& one, const HeatBody& other, double cell) {
  return !one.shape || !other.shape || come_near(*one.shape, *other.shape, reach * cell, cell);
}

struct UnlikePair {
  std::size_t poor = 0, good = 0;  // bodies
  double contrast = 0.0;           // of their conductivities
};

/// The pair that conducts least alike of those that come near each other and share nodes, or do
/// not; nothing below a contrast of `least`.
std::optional<UnlikePair> least_alike(const std::vector<std::vector<std::size_t>>& together,
                                      const std::vector<HeatBody>& bodies, double cell_size,
                                      bool share, double least) {
  std::optional<UnlikePair> worst;
  for (const std::vector<std::size_t>& some : together) {
    for (const std::vector<std::size_t>& others : together) {
      if ((&some == &others) != share) {
        continue;
      }
      for (const std::size_t poor : some) {
        for (const std::size_t good : others) {
          const double contrast = largest_conductivity(bodies[good].material) /
                                  std::max(largest_conductivity(bodies[poor].material), 1e-300);
          if (contrast >= least && contrast > (worst ? worst->contrast : 0.0) &&
              are_near(bodies[poor], bodies[good], cell_size)) {
            worst = {poor, good, contrast};
          }
        }
      }
    }
  }
  return worst;
}

}  // namespace

std::vector<Note> unlike_contacts(const std::vector<std::vector<std::size_t>>& together,
                                  const std::vector<HeatBody>& bodies, double cell_size) {
  constexpr double told = 50.0;  // 4, 9, 24 % past the range at 150, 300, 500; 2 % at 50
  const auto pair = least_alike(together, bodies, cell_size, false, told);
  if (!pair) {
    return {};
  }
  const std::vector<std::string> names = names_of(bodies);
  return {note("heat.unlike-contact", names[pair->good], " conducts ", pair->contrast,
               " times better than ", names[pair->poor],
               " and touches it: until heat is a cell deep in the latter its temperatures beside "
               "the face may pass the range by up to a fourth, and with ten of its cells across "
               "some 3 % of the heat may be off; take smaller cells there")};
}

std::vector<Note> common_nodes(const std::vector<std::vector<std::size_t>>& together,
                               const std::vector<HeatBody>& bodies, double cell_size) {
  constexpr double told = 2.0;
  const auto pair = least_alike(together, bodies, cell_size, true, told);
  if (!pair) {
    return {};
  }
  const auto called = [&](std::size_t body) { return in_brackets(bodies[body].name); };
  // A face at f of a cell: f + (1 - f) / c against 1 / (f + (1 - f) c), at most. Slabs of ten
  // cells: 5 % of heat too much for a contrast of 4, 22 % for 100.
  const double thinner = std::pow(1.0 - 1.0 / std::sqrt(pair->contrast), 2) * cell_size;
  return {note("heat.common-nodes", "bodies.", pair->good, called(pair->good), " conducts ",
               pair->contrast, " times better than bodies.", pair->poor, called(pair->poor),
               " and shares nodes with it: where they touch between nodes, heat may pass as if "
               "the latter were thinner by up to ",
               thinner,
               " m; take smaller cells, or contact = \"frictional\" where [dynamics] moves them")};
}

}  // namespace lapilli
